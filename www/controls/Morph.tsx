import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import type { Session } from "../session";

const PLAY_MILLIS = 2200;

/** Slides between the identity and the match: (1 − s) x + s φ(x). */
export function Morph({ session }: { session: Session }) {
  const playing = useSignal(false);
  const pending = useRef(0);
  const stop = () => {
    cancelAnimationFrame(pending.current);
    playing.value = false;
  };
  useEffect(() => stop, []);

  const play = () => {
    if (playing.value) {
      stop();
      return;
    }
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
      session.morph.value = session.morph.value < 0.5 ? 1 : 0;
      return;
    }
    playing.value = true;
    const begin = performance.now();
    const tick = (now: number) => {
      const part = Math.min(1, Math.max(0, now - begin) / PLAY_MILLIS);
      session.morph.value = (1 - Math.cos(Math.PI * part)) / 2;
      if (part < 1) pending.current = requestAnimationFrame(tick);
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
        aria-label={playing.value ? "Stop the morph" : "Play the morph"}
        onClick={play}
      >
        <svg viewBox="0 0 16 16" aria-hidden="true">
          <path d={playing.value ? "M3 3h10v10H3z" : "M4 2l10 6-10 6z"} />
        </svg>
      </button>
      <label>
        <span>Morph</span>
        <input
          type="range"
          min={0}
          max={100}
          step={1}
          value={percent}
          disabled={none}
          aria-valuetext={`${percent} % of the deformation`}
          onInput={(event) => {
            stop();
            session.morph.value = event.currentTarget.valueAsNumber / 100;
          }}
        />
        <span class="percent">{percent} %</span>
      </label>
    </div>
  );
}
