/** The page within another one: everything of that comes with this module, on demand. */

import { effect } from "@preact/signals";
import { render } from "preact";
import { adopt } from "../controls/adopt";
import { choose, view } from "../controls/viewing";
import type { Engine } from "../engine";
import { open, reason } from "../link/open";
import { Session } from "../session";
import { enter, isSpace, space } from "../space/way";
import { embed as say } from "../words/embed";
import { type Asked, asked } from "./asked";
import { Frame } from "./Frame";
import { Forgetful } from "./forgetful";
import style from "./frame.css?inline";
import { double, type Scene, single, solid } from "./scene";
import { answer } from "./talk";
import { seen, watchSight } from "./unseen";

adopt(style);

/** Shows in `root` what the address asks for, and listens to the page around it. */
export async function embed(root: HTMLElement, engine: Engine): Promise<void> {
  const wish = wished();
  const isSolid = isSpace(location.hash);
  document.documentElement.dataset.embed = isSolid && wish.asked.kind === "compare" ? "result" : wish.asked.kind;
  // The page around has such landmarks of its own.
  for (const landmark of document.querySelectorAll("body > header, main")) landmark.ariaLabel = say.title;
  watchSight();
  const opened = open(isSolid ? { hash: "", search: location.search } : location, null);
  const session = new Session(engine, opened, { view, choose }, new Forgetful());
  const scene = await sceneOf(session, wish.asked, isSolid);
  if (wish.problem) session.problem.value = wish.problem;
  root.replaceChildren();
  render(<Frame session={session} asked={wish.asked} scene={scene} />, root);
  if (!opened.later) whenSeen(scene.start);
  talk(wish.asked.origin, scene);
}

/** What cannot be asked for is said over what is usually shown. */
function wished(): { readonly asked: Asked; readonly problem: string | null } {
  const usual = asked("?embed=result");
  if (!usual) throw new Error("a frame shows something");
  try {
    return { asked: asked(location.search) ?? usual, problem: null };
  } catch (error) {
    return { asked: usual, problem: reason(error) };
  }
}

async function sceneOf(session: Session, wish: Asked, isSolid: boolean): Promise<Scene> {
  if (!isSolid) return wish.kind === "compare" ? double(session, wish) : single(session);
  await enter(session.problem, () => {});
  if (!space.value) return single(session);
  if (wish.kind === "compare") space.value.session.problem.value = say.onlyCurves;
  return solid(space.value);
}

/** Nobody waits for what is further down the other page. */
function whenSeen(start: () => void): void {
  let begun = false;
  effect(() => {
    if (begun || !seen.value) return;
    begun = true;
    start();
  });
}

/** Answers the page around this one, and tells it of every match that is final. */
function talk(origin: string | null, { host, final }: Scene): void {
  if (parent === window) return;
  /** The origin that is told: the one in the address, or that of the last message of the parent's that was obeyed. */
  let listener = origin;
  addEventListener("message", ({ data, source, origin: from }) => {
    const said = answer(data, { isParent: source === parent, origin: from }, origin, host);
    if (!said || !source) return;
    if (said.kind !== "refused") listener = from;
    source.postMessage(said, { targetOrigin: targetOf(from) });
  });
  effect(() => {
    if (!final() || listener === null) return;
    parent.postMessage({ thinshell: 1, kind: "finished", report: host.report() }, targetOf(listener));
  });
  // Nothing is in it that anybody could want to know.
  parent.postMessage({ thinshell: 1, kind: "ready" }, "*");
}

/** An opaque origin, such as that of a file, cannot be named. */
function targetOf(origin: string): string {
  return origin === "null" ? "*" : origin;
}
