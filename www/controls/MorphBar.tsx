import { type Signal, useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { en } from "../words/en";
import { PLAYS, type Play, partAt } from "./playing";
import { resting } from "./viewing";

type Properties = {
  readonly morph: Signal<number>;
  /** Nothing is there to be slid. */
  readonly none: boolean;
  readonly children?: ComponentChildren;
};

/** Slides and plays between the identity and the match. */
export function MorphBar({ morph, none, children }: Properties) {
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
      morph.value = morph.value < 0.5 ? 1 : 0;
      return;
    }
    playing.value = true;
    const begin = performance.now();
    const tick = (now: number) => {
      const part = partAt(play.value, now - begin);
      if (!resting.value) morph.value = part ?? 1;
      if (part !== null) pending.current = requestAnimationFrame(tick);
      else playing.value = false;
    };
    pending.current = requestAnimationFrame(tick);
  };

  const percent = Math.round(100 * morph.value);
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
            morph.value = event.currentTarget.valueAsNumber / 100;
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
      {children}
    </div>
  );
}
