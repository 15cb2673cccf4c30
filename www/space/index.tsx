/** The way into surfaces: everything of them comes with this module, on demand. */

import { effect } from "@preact/signals";
import { engineFor } from "../card/choice";
import { Delay } from "../delay";
import { type Engine, moduleAt } from "../engine";
import solverUrl from "../wasm-solid/thinshell_bg.wasm?url";
import { space as say } from "../words/space";
import { openSolid } from "./files";
import { PAIRS, surface } from "./gallery";
import { decode, encode, type Linked } from "./link";
import { Space } from "./Space";
import { FIRST_LOOK, type Side, SpaceSession, type Step } from "./session";
import type { Solid } from "./solid";
import { isFile, keep, kept } from "./store";
import type { Ways } from "./ways";
import SolidWorker from "./worker?worker&inline";

const WRITE_MILLIS = 400;

/** The one of this page: who comes back finds everything as it was. */
let session: SpaceSession | null = null;
let isShown = false;

/** Shows what the link says, or what was there before, or the first pair. */
export async function open(hash: string, leave: () => void) {
  const text = hash.replace(/^#/, "");
  const isLink = new URLSearchParams(text).has("space");
  const asked = isLink ? await linked(text) : null;
  if (!session) {
    const spawn = () => new SolidWorker({ name: "thinshell solver of surfaces" });
    const engine: Engine = {
      module: moduleAt(solverUrl),
      spawn,
      // From 65 × 65 × 65 on a card may be faster.
      card: (settings) =>
        settings.backend === "gpu" || (settings.backend !== "cpu" && (settings.finest ?? 0) > 5)
          ? engineFor(settings, "space", engine)
          : undefined,
    };
    session = new SpaceSession(engine, asked?.step ?? first(), asked?.linked.look);
    writeAddress(session);
    session.start();
  } else if (asked && !asked.problem && encode(asked.step, asked.linked.look) !== textOf(session)) {
    session.commit(asked.step);
    session.look(asked.linked.look);
    session.start();
  }
  if (asked?.problem) session.problem.value = asked.problem;
  isShown = true;
  write(session);
  const shown = session;
  const ways: Ways = {
    leave: () => {
      isShown = false;
      leave();
    },
    take: (side, file) => take(shown, side, file),
    address: () => {
      if ([shown.step.value.reference, shown.step.value.template].some(({ id }) => isFile(id)))
        shown.problem.value = say.links.notWhole;
      write(shown);
      return location.href;
    },
  };
  return {
    View: () => <Space session={shown} ways={ways} />,
    session: shown,
    /** Shows what such a text says. Throws a sentence's part where it cannot be read; then nothing has changed. */
    set: (text: string) => {
      const { reference, template, pins, settings, look } = decode(text);
      shown.commit({ reference: galleryOnly(reference), template: galleryOnly(template), pins, settings });
      shown.look(look);
      shown.start();
    },
    text: () => textOf(shown),
    undo: () => shown.undo(),
    redo: () => shown.redo(),
    /** Another link has been opened, or the way back been taken. */
    hide: () => {
      isShown = false;
    },
  };
}

function first(): Step {
  const [{ reference, template }] = PAIRS;
  return { reference: galleryOnly(reference), template: galleryOnly(template), pins: [], settings: {} };
}

function galleryOnly(id: string): Solid {
  const solid = surface(id);
  if (!solid) throw new Error(say.links.unknown(id));
  return solid;
}

type Asked = { readonly step: Step; readonly linked: Pick<Linked, "look">; readonly problem: string | null };

/** Of what cannot be read only the reason; the first pair stands in for it where nothing is shown yet. */
async function linked(text: string): Promise<Asked> {
  try {
    const found = decode(text);
    const [reference, template] = await Promise.all([
      solidOf(found.reference, "reference"),
      solidOf(found.template, "template"),
    ]);
    const { pins, settings } = found;
    return { step: { reference, template, pins, settings }, linked: found, problem: null };
  } catch (error) {
    const why = error instanceof Error ? error.message : String(error);
    return { step: first(), linked: { look: FIRST_LOOK }, problem: say.links.notRead(why) };
  }
}

async function solidOf(id: string, side: Side): Promise<Solid> {
  if (!isFile(id)) return galleryOnly(id);
  const solid = await kept(id);
  if (!solid) throw new Error(say.links.elsewhere(side));
  return solid;
}

/** A file for one side; what cannot be read is reported and changes nothing. */
async function take(session: SpaceSession, side: Side, file: File): Promise<void> {
  try {
    const solid = await openSolid(file.name, new Uint8Array(await file.arrayBuffer()));
    session.commit({ [side]: solid });
    if (!(await keep(solid))) session.problem.value = say.links.notKept;
  } catch (error) {
    session.problem.value = error instanceof Error ? error.message : String(error);
  }
}

function textOf({ step, view, morph, plane, pose }: SpaceSession): string {
  return encode(step.value, { view: view.value, morph: morph.value, plane: plane.value, pose: pose.value });
}

function write(session: SpaceSession): void {
  if (isShown) history.replaceState(null, "", `#${textOf(session)}`);
}

/** A moment after each change: browsers allow the address to be written some three times a second. */
function writeAddress(session: SpaceSession): void {
  const delay = new Delay(WRITE_MILLIS);
  effect(() => {
    textOf(session);
    delay.start(() => write(session));
  });
}
