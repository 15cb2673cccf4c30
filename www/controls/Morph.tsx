import { useComputed, useSignal, useSignalEffect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import type { Session } from "../session";
import { en } from "../words/en";
import { fetched } from "./fetched";
import { PLAYS, type Play, partAt } from "./playing";
import { resting } from "./viewing";

/** Slides between the identity and the match; see view/morph.ts for the way between them. */
export function Morph({ session }: { session: Session }) {
  const playing = useSignal(false);
  const play = useSignal<Play>("once");
  const pending = useRef(0);
  const stop = () => {
    cancelAnimationFrame(pending.current);
    playing.value = false;
  };
  useEffect(() => stop, []);

  const start = () => {
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
      session.morph.value = session.morph.value < 0.5 ? 1 : 0;
      return;
    }
    playing.value = true;
    const begin = performance.now();
    const tick = (now: number) => {
      const part = partAt(play.value, now - begin);
      if (!resting.value) session.morph.value = part ?? 1;
      if (part !== null) pending.current = requestAnimationFrame(tick);
      else playing.value = false;
    };
    pending.current = requestAnimationFrame(tick);
  };

  const none = session.match.value === null;
  const percent = Math.round(100 * session.morph.value);
  return (
    <div class="morph">
      <button
        type="button"
        disabled={none}
        aria-label={playing.value ? en.morph.stop : en.morph.play}
        onClick={() => (playing.value ? stop() : start())}
      >
        <svg viewBox="0 0 16 16" aria-hidden="true">
          <path d={playing.value ? "M3 3h10v10H3z" : "M4 2l10 6-10 6z"} />
        </svg>
      </button>
      <label class="way">
        <span class="unseen">{en.morph.name}</span>
        <input
          type="range"
          min={0}
          max={100}
          step={1}
          value={percent}
          disabled={none}
          aria-valuetext={en.morph.part(percent)}
          onInput={(event) => {
            stop();
            session.morph.value = event.currentTarget.valueAsNumber / 100;
          }}
        />
        <span class="percent">{percent} %</span>
      </label>
      <select
        aria-label={en.morph.how}
        value={play.value}
        onChange={(event) => {
          play.value = event.currentTarget.value as Play;
        }}
      >
        {PLAYS.map((way) => (
          <option key={way} value={way}>
            {en.morph.plays[way]}
          </option>
        ))}
      </select>
      <Folds session={session} />
    </div>
  );
}

/** Where the plane folds on its way, that is said: the match itself never does. */
function Folds({ session }: { session: Session }) {
  // Looked for only when somebody leaves the match's end of the way.
  const away = useComputed(() => session.morph.value < 1);
  const foldOf = useSignal<typeof import("../view/fold").foldOf | null>(null);
  useSignalEffect(() => {
    if (!away.value || foldOf.peek()) return;
    fetched(en.morph.what, () => import("../view/fold")).then(
      (part) => {
        foldOf.value = part.foldOf;
      },
      (problem: Error) => {
        session.problem.value = problem.message;
      },
    );
  });
  const fold = useComputed(() => {
    const frame = away.value ? session.match.value : null;
    return frame && foldOf.value?.({ level: frame.status.level, deformation: frame.deformation, curves: frame.curves });
  });
  if (!fold.value) return null;
  const [first, last] = fold.value.map((part) => Math.round(100 * part));
  return <p class="folds">{en.morph.folds(first, last)}</p>;
}
