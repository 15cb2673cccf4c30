/** Predicting first: where a marked point of the reference will go, guessed before it is seen. Domain units. */

import { arcLengthParts } from "./curve";
import type { Match } from "./result";

export type Place = { readonly x: number; readonly y: number };

export type Question = { readonly point: Place; readonly partner: Place };

/** Steps along the reference that never come back to where they were, and soon have been everywhere. */
const GOLDEN = (Math.sqrt(5) - 1) / 2;

/** The n-th question of a match: points of the reference spread over its whole length. Null without curves. */
export function questionOf({ curves: { reference, matched } }: Match, n: number): Question | null {
  const wanted = (0.37 + n * GOLDEN) % 1;
  let best: { question: Question; off: number } | null = null;
  arcLengthParts(reference).forEach((parts, l) => {
    parts.forEach((part, i) => {
      const off = Math.abs(part - wanted);
      if (best && off >= best.off) return;
      const at = (loop: Float64Array) => ({ x: loop[2 * i], y: loop[2 * i + 1] });
      best = { off, question: { point: at(reference[l]), partner: at(matched[l]) } };
    });
  });
  return (best as { question: Question } | null)?.question ?? null;
}

export function distance(a: Place, b: Place): number {
  return Math.hypot(a.x - b.x, a.y - b.y);
}
