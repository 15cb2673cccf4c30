/** Which runs are kept to come back to. */

import { effect, type ReadonlySignal } from "@preact/signals";
import type { Run } from "../run";
import type { Runs } from "../runs";

/** Every match that has been asked for and belongs to what is chosen; what only follows the hand is none. */
export function keepRuns(
  run: Pick<Run, "result" | "stale" | "phase">,
  isLive: ReadonlySignal<boolean>,
  runs: Pick<Runs, "add">,
): void {
  effect(() => {
    const { result, stale, phase } = run;
    if (phase.value === "matched" && result.value && !stale.value && !isLive.value) runs.add(result.value);
  });
}
