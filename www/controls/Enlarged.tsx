import { useEffect } from "preact/hooks";
import type { Session } from "../session";
import { focusOn } from "../tools/focus";
import { said } from "../tools/tool";
import { later } from "../words/later";
import { adopt } from "./adopt";
import { enlarged } from "./Enlarge";
import style from "./enlarged.css?inline";

adopt(style);

/** What is not seen meanwhile, nor reached by keys. */
const BEHIND = "body > header, body > footer, article, #app > :not(.sketches, .actions), .toolbar";

/** One surface over the whole screen, with what is needed to draw and the way back. */
export function Enlarged({ session }: { session: Session }) {
  const side = enlarged.value ?? "reference";
  const other = side === "reference" ? "template" : "reference";

  useEffect(() => {
    const root = document.documentElement;
    root.dataset.enlarged = side;
    said.value = later.enlarged.begun(side);
    focusOn(side);
    return () => {
      delete root.dataset.enlarged;
    };
  }, [side]);

  useEffect(() => {
    const behind = [...document.querySelectorAll<HTMLElement>(BEHIND)];
    for (const element of behind) element.inert = true;
    const listening = new AbortController();
    addEventListener(
      "keydown",
      (event) => {
        // A tool gives up what it has begun first.
        if (event.key === "Escape" && !event.defaultPrevented) enlarged.value = null;
      },
      { signal: listening.signal },
    );
    return () => {
      listening.abort();
      for (const element of behind) element.inert = false;
    };
  }, []);

  const leave = () => {
    enlarged.value = null;
    focusOn(side);
  };
  return (
    <div class="enlarged-bar">
      <button type="button" disabled={!session.canUndo.value} onClick={() => session.undo()}>
        {later.enlarged.undo}
      </button>
      <button type="button" disabled={!session.canRedo.value} onClick={() => session.redo()}>
        {later.enlarged.redo}
      </button>
      <button
        type="button"
        onClick={() => {
          enlarged.value = other;
        }}
      >
        {later.enlarged.other(other)}
      </button>
      <button type="button" class="primary" onClick={leave}>
        {later.enlarged.done}
      </button>
    </div>
  );
}
