/** A frame that nobody sees rests: its run is paused, its morph stands still. */

import { effect, signal } from "@preact/signals";
import { resting } from "../controls/viewing";

/** Whether any of the frame is in somebody's sight. A frame tells that of the whole page, across origins too. */
export const seen = signal(false);

type Runner = {
  /** Whether a run is on, and not paused. */
  readonly runs: () => boolean;
  readonly pause: () => void;
  readonly resume: () => void;
};

/** Watches the window's own place in the page around it. */
export function watchSight(): void {
  let within = false;
  const look = () => {
    seen.value = within && document.visibilityState === "visible";
    resting.value = !seen.value;
  };
  new IntersectionObserver((entries) => {
    within = entries[entries.length - 1].isIntersecting;
    look();
  }).observe(document.documentElement);
  document.addEventListener("visibilitychange", look);
}

/** Pauses what runs unseen, and goes on with what it has paused itself. */
export function restUnseen({ runs, pause, resume }: Runner): void {
  let paused = false;
  effect(() => {
    const running = runs();
    if (!seen.value && running) {
      paused = true;
      pause();
    } else if (seen.value && paused) {
      paused = false;
      if (!running) resume();
    }
  });
}
