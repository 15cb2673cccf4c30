/** Where the views' scales end, and what stands at them. */

import { later } from "../words/later";
import { volumeDensities } from "./density";
import { logDeterminants } from "./field";
import { bothCurvatures, costs, mapOf, mismatchWithin, stretches } from "./measured";
import type { View } from "./names";
import type { Match } from "./result";
import { amounts, clipped, factors, place, quantile, roundUp, type Scale, signed } from "./scales";

/** What the match needs the view's scale to reach: doublings, cells or 1/length. 1 where nothing is to choose. */
export function limitOf(view: View, match: Match, bandwidth: number): number {
  const values = valuesOf(view, match, bandwidth);
  switch (view) {
    case "stretch":
    case "determinant":
      return doublings(values.map((value) => Math.abs(Math.log2(value))));
    case "curvature":
      return roundUp(quantile(values.map(Math.abs), 0.98));
    case "mismatch":
      return roundUp(quantile(values, 0.995));
    case "stretching":
    case "bending":
    case "volume":
      return roundUp(quantile(values, 0.98));
    default:
      return 1;
  }
}

/** Everything that the view's scale is for. */
function valuesOf(view: View, match: Match, bandwidth: number): Float64Array {
  switch (view) {
    case "stretch":
      return joined(stretches(match));
    case "determinant":
      return logDeterminants(mapOf(match)).map((log) => 2 ** log);
    case "curvature": {
      const both = bothCurvatures(match);
      return joined([...both.reference, ...both.partner]);
    }
    case "mismatch":
      return mismatchWithin(match, bandwidth);
    case "stretching":
    case "bending":
      return joined(costs(view, match, 1));
    case "volume":
      return volumeDensities(mapOf(match));
    default:
      return new Float64Array(0);
  }
}

function joined(parts: readonly Float64Array[]): Float64Array {
  return Float64Array.from(parts.flatMap((values) => [...values]));
}

/** The scale with its ends marked where the match has values beyond them, which the ends' colours stand for. */
export function markedScale(view: View, match: Match, bandwidth: number, limit: number, dark: boolean): Scale | null {
  const scale = scaleOf(view, limit, dark);
  if (!scale) return null;
  let [least, most] = [0, 0];
  for (const value of valuesOf(view, match, bandwidth)) {
    const part = scale.part(value);
    if (part < least) least = part;
    if (part > most) most = part;
  }
  return clipped(scale, least, most);
}

/** A quarter of a doubling at least: smaller changes cannot be told from noise. */
function doublings(sizes: ArrayLike<number>): number {
  const reached = quantile(sizes, 0.98);
  return [0.25, 0.5, 1, 2, 3, 4, 6].find((step) => step >= reached) ?? 8;
}

export function scaleOf(view: View, limit: number, dark: boolean): Scale | null {
  switch (view) {
    case "stretch":
      return factors(later.scales.stretch, dark, limit);
    case "determinant":
      return factors(later.scales.determinant, dark, limit);
    case "curvature":
      return signed(later.scales.curvature, later.scales.perSide, dark, limit);
    case "band":
      return amounts(later.scales.band, "", 1);
    case "mismatch":
      return amounts(later.scales.mismatch, later.scales.cells, limit);
    case "stretching":
      return amounts(later.scales.stretching, "", limit);
    case "bending":
      return amounts(later.scales.bending, later.scales.perSquare, limit);
    case "volume":
      return amounts(later.scales.volume, "", limit);
    default:
      return null;
  }
}

/** Parts of the matched curve, by length of the reference, in even bins of the stretch's scale. */
export function histogram(match: Match, scale: Scale, bins: number): number[] {
  const out = new Array<number>(bins).fill(0);
  const values = stretches(match);
  let whole = 0;
  match.curves.reference.forEach((loop, l) => {
    for (let i = 0, j = loop.length - 2; i < loop.length; j = i, i += 2) {
      const length = Math.hypot(loop[i] - loop[j], loop[i + 1] - loop[j + 1]);
      out[place(scale.part((values[l][i / 2] + values[l][j / 2]) / 2), bins)] += length;
      whole += length;
    }
  });
  return out.map((length) => length / whole);
}
