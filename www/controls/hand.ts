/** Puts a tool into the hand that works on a surface. */

import { effect } from "@preact/signals";
import { kit as pins } from "../pins/kit";
import type { Session, Side } from "../session";
import { finestLevel } from "../settings";
import { Drawing } from "../shapes/draw";
import { withLoop } from "../shapes/edit";
import type { Loop, Shape } from "../shapes/geometry";
import type { Judgement } from "../shapes/judge";
import type { Pin } from "../shapes/pins";
import { focusOn } from "../tools/focus";
import { type Ground, Hand, type Tool } from "../tools/hand";
import { curve, fetchKit, kit } from "../tools/kit";
import { said, type ToolName } from "../tools/tool";
import type { Surface } from "../view/canvas";
import { later } from "../words/later";
import { changeWords, faultWords, strokes } from "../words/strokes";

const SIDES: readonly Side[] = ["reference", "template"];

export { drawFaulty } from "../view/pen";
export { Computed } from "./Computed";
export { CopyLink } from "./CopyLink";
export { listenForLanguage } from "./changeLanguage";
export { Exchange } from "./Exchange";
export { listenForImports } from "./importing";
export { Present } from "./Present";
export { Save } from "./Save";

/** What leaving out a term means. */
export function withoutTerm(name: string): string | undefined {
  return later.without[name as keyof typeof later.without];
}

/** What a button does. */
export function hint(name: keyof typeof later.hints): string {
  return later.hints[name];
}

export function handOf(name: ToolName, session: Session, side: Side, surface: Surface): Hand {
  const ground: Ground & { restore(): void } = {
    side,
    canvas: surface.canvas,
    get pixelsPerUnit() {
      return surface.pixelsPerUnit;
    },
    pointFrom: (event) => surface.pointFrom(event),
    repaint: () => surface.invalidate(),
    restore: () => session.restoreShape(),
  };
  return new Hand(ground, toolOf(name, session, ground));
}

function toolOf(name: ToolName, session: Session, ground: Ground & { restore(): void }): Tool {
  const { side } = ground;
  const [pinning, further] = [pins.peek(), kit.peek()];
  if (name === "pin" && pinning) {
    const host = Object.assign(ground, {
      shapes: () => session.shapes.value,
      preview: (pins: readonly Pin[], at: number) => session.previewPins(pins, at),
      commit: (pins: readonly Pin[]) => session.commitPins(pins),
      goOn: () => focusOn(side === "reference" ? "template" : "reference"),
    });
    return new pinning.PinTool(host);
  }
  const easel = Object.assign(ground, {
    limits: () => ({ cell: 1 / 2 ** finestLevel(session.settings.value) }),
    draw: (judgement: Judgement) => draw(session, side, judgement),
  });
  if (further && name === "circle") return new further.Circle(easel);
  if (further && name === "polygon") return new further.Polygon(easel);
  if (further && name === "mirror") return new further.Mirror(easel);
  const bench = Object.assign(easel, {
    shape: () => session.shapes.value[side],
    preview: (shape: Shape, at: number) => session.previewShape(side, shape, at),
    commit: (shape: Shape) => session.commitShape(side, shape),
  });
  if (further && name === "points") return new further.Points(bench);
  return new Drawing(
    Object.assign(bench, {
      isExample: () => session.isExample(side),
      choose: (loop: number | null) => choose(session, side, loop),
    }),
  );
}

/** Says what has become of the shapes, by whatever hand; a tool that knows better says it after that. */
export function announceChanges(session: Session): void {
  let last = session.present;
  effect(() => {
    const [before, after] = [last, session.present];
    last = after;
    const changed = SIDES.filter((side) => before[side] !== after[side]);
    if (changed.length === 0) return;
    said.value = changed.map((side) => changeWords(side, before[side].length, after[side].length)).join(" ");
  });
}

/** Takes a curve for one more of the shape, or asks what is to become of it. */
function draw(session: Session, side: Side, judgement: Judgement): void {
  if (judgement.kind === "tap") return;
  if (judgement.kind === "loop") {
    take(session, side, judgement.loop);
    return;
  }
  const { kind, size, loop, mended } = judgement;
  const ways = mended ? [{ label: strokes.ways[kind], go: () => take(session, side, mended) }] : [];
  session.question.value = { side, loop, words: faultWords(kind, size), ways };
}

/** The first curve replaces an example. */
function take(session: Session, side: Side, loop: Loop): void {
  const before = session.isExample(side) ? [] : session.shapes.value[side];
  session.commitShape(side, withLoop(before, loop));
  choose(session, side, before.length);
}

/** What is done to one curve comes on demand. */
function choose(session: Session, side: Side, loop: number | null): void {
  curve.value = loop === null ? null : { side, loop };
  if (loop === null) return;
  fetchKit().catch((error: Error) => {
    session.problem.value = error.message;
  });
}
