/**
 * The facts that the solver's sentences are made of, named: for languages in which it does not say them itself. Their order
 * is that of src/verdict.rs, src/minimize.rs and src/search/plan.rs; where there are none, the first is -1.
 */

import type { Status } from "../protocol";

const STOPS = ["converged", "creeping", "noDescent", "iterationLimit", "refined", "bestOf"] as const;

const APPROACHES = [
  "direct",
  "exchanged",
  "inverted",
  "sharpened",
  "sharpenedExchanged",
  "guided",
  "guidedExchanged",
] as const;

const KINDS = ["parts", "notReached", "holes", "crumpled", "fits", "unresolved", "misfit"] as const;
const PLACES = ["hole", "part", "outline", "moved"] as const;

export type Stop = (typeof STOPS)[number];
export type Approach = (typeof APPROACHES)[number];
export type Kind = (typeof KINDS)[number];

/** The kinds that English says more of. */
export const CRUMPLED = 3;
export const FITS = 4;

/** Whether what is off is more than a pixel or two of the picture: a quarter of a cell on 129² nodes, twice that on 257². */
export function isSeen({ level, mismatch, cover }: Pick<Status, "level" | "mismatch" | "cover">): boolean {
  return Math.max(mismatch.max, cover.max) > 2 ** (level - 9);
}

/** A neck or gap that the grid does not resolve. */
export type Unresolved = {
  readonly side: "reference" | "template";
  /** In cells. */
  readonly width: number;
  readonly x: number;
  readonly y: number;
  readonly part: "gap" | "neck";
  /** Of the least fine grid that resolves it; null where none that is offered does. */
  readonly level: number | null;
};

export type Verdict = {
  readonly kind: Kind;
  /** Bodies, or holes, of reference and template. */
  readonly from: number;
  readonly to: number;
  /** Where the largest distance is: at what of the target, or of the moved reference. */
  readonly place: (typeof PLACES)[number];
  readonly x: number;
  readonly y: number;
  readonly unresolved: Unresolved | null;
};

/** Undefined where there is none, as in files of before. */
export function stopOf([stop]: Iterable<number>): Stop | undefined {
  return STOPS[stop];
}

export function approachOf([, approach]: Iterable<number>): Approach | undefined {
  return APPROACHES[approach];
}

export function verdictOf([, , kind, from, to, place, x, y, ...rest]: Iterable<number>): Verdict | null {
  if (!(kind in KINDS) || !(place in PLACES)) return null;
  return { kind: KINDS[kind], from, to, place: PLACES[place], x, y, unresolved: unresolvedOf(rest) };
}

export function unresolvedOf([template, width, x, y, gap, level]: Iterable<number>): Unresolved | null {
  if (level === undefined || template < 0) return null;
  return { side: template ? "template" : "reference", width, x, y, part: gap ? "gap" : "neck", level: level || null };
}
