/** What a frame tells of a match: plain numbers and texts, the same names as in the solver's status. */

import { isDone, type Phase } from "../phase";
import type { Status } from "../protocol";

export type Report = {
  /** What the page has behind its #: with it, everything is there again. */
  readonly state: string;
  /** A match of the present shapes and settings is there and final. */
  readonly finished: boolean;
  /** Why there is none. */
  readonly problem: string | null;
  readonly match: Numbers | null;
  /** Of two settings side by side. */
  readonly sides?: readonly (Numbers | null)[];
};

export type Numbers = Pick<
  Status,
  "level" | "iteration" | "evaluations" | "energies" | "leastDeterminant" | "mismatch" | "cover" | "measure" | "stretch"
> & { readonly verdict: string | null };

type Known = {
  readonly state: string;
  readonly phase: Phase;
  readonly stale: boolean;
  readonly problem: string | null;
  readonly status: Status | null;
};

export function reportOf({ state, phase, stale, problem, status }: Known): Report {
  return { state, finished: status !== null && isDone(phase) && !stale, problem, match: status && numbersOf(status) };
}

export function numbersOf(status: Status): Numbers {
  const { level, iteration, evaluations, energies, leastDeterminant, mismatch, cover, measure, stretch } = status;
  const known = { level, iteration, evaluations, energies, leastDeterminant, mismatch, cover, measure, stretch };
  return { ...known, verdict: status.verdict ?? null };
}
