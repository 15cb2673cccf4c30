/** The result alone on the whole screen, large enough to be read from the last row; keys do the rest. */

import type { Session } from "../session";
import { VIEWS } from "../view/names";
import { later } from "../words/later";
import { adopt } from "./adopt";
import style from "./present.css?inline";
import { choose, view } from "./viewing";

adopt(style);

/** Steps of the arrow keys along the morph. */
const STEP = 0.05;

/** What the keys do, in words. */
export const keys = () => later.present.keys;

/** Begins a presentation; the function given back ends it, and so do the user and the browser, who tell by `ended`. */
export function present(session: Session, ended: () => void): () => void {
  const root = document.documentElement;
  const listening = new AbortController();
  const { signal } = listening;
  root.toggleAttribute("data-presenting", true);
  scrollTo(0, 0);
  const end = () => {
    if (signal.aborted) return;
    listening.abort();
    root.toggleAttribute("data-presenting", false);
    if (document.fullscreenElement) document.exitFullscreen().catch(() => {});
    ended();
  };
  const press = (event: KeyboardEvent) => {
    const plain = !event.ctrlKey && !event.metaKey && !event.altKey;
    if (plain && act(session, event, end)) event.preventDefault();
  };
  // Before the controls' own keys: an arrow is one step of the morph wherever the focus is.
  addEventListener("keydown", press, { capture: true, signal });
  document.addEventListener("fullscreenchange", () => document.fullscreenElement ?? end(), { signal });
  // Where the browser gives no full screen, the page's window is what there is.
  root.requestFullscreen?.().catch(() => {});
  return end;
}

/** Whether the key was one of the presentation's. */
function act(session: Session, { key, target }: KeyboardEvent, leave: () => void): boolean {
  const inList = target instanceof HTMLSelectElement;
  if (key === "Escape") leave();
  else if (inList) return false;
  else if (key === " ") document.querySelector<HTMLButtonElement>(".morph button")?.click();
  else if (key === "ArrowLeft" || key === "ArrowRight") {
    const next = session.morph.value + (key === "ArrowRight" ? STEP : -STEP);
    session.morph.value = Math.min(1, Math.max(0, Math.round(next / STEP) * STEP));
  } else if (key === "v" || key === "V") {
    const at = VIEWS.indexOf(view.value);
    const next = VIEWS[(at + (key === "v" ? 1 : VIEWS.length - 1)) % VIEWS.length];
    choose(next).catch((problem: unknown) => {
      session.problem.value = problem instanceof Error ? problem.message : String(problem);
    });
  } else return false;
  return true;
}
