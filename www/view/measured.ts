/** What views show of a match in numbers: along its curve and over the plane. */

import { curvatures, nearest, stretch } from "./along";
import { atNodes, bendingAt, stretchingAt, volumeDensities } from "./density";
import { bandWeights, distances, logDeterminants, mismatches, thinned } from "./field";
import { CURVATURE_CELLS } from "./local";
import { movedGrid, movedLoops } from "./morph";
import type { View } from "./names";
import type { Match } from "./result";

/** Fields with a distance at each node are costly, and smooth: no more cells than this. */
const FIELD_CELLS = 64;

/** What the curve costs at each of its points. The target's curvature is met at the end of the way only. */
export function costs(view: "stretching" | "bending", match: Match, morph: number): Float64Array[] {
  if (view === "stretching") return stretches(match, morph).map((values) => values.map(stretchingAt));
  const { reference, partner } = bothCurvatures(match);
  return stretches(match).map((values, l) => values.map((s, i) => bendingAt(s, reference[l][i], partner[l][i])));
}

export function mismatchWithin(match: Match, bandwidth: number): Float64Array {
  const { values, d1 } = mismatchAt(match, 1, bandwidth);
  return values.filter((_, node) => Math.abs(d1[node]) < bandwidth);
}

type Shown = { readonly match: Match; readonly morph: number; readonly bandwidth: number };

export type Field = { readonly cells: number; readonly values: Float64Array; readonly d1?: Float64Array };

/** Nodal values on the undeformed grid, in the units of the view's scale. */
export function fieldOf(view: View, { match, morph, bandwidth }: Shown): Field {
  const map = movedGrid(match, morph);
  if (view === "determinant") return { cells: map.cells, values: logDeterminants(map).map((log) => 2 ** log) };
  if (view === "mismatch") return mismatchAt(match, morph, bandwidth);
  if (view === "volume") return { cells: map.cells, values: atNodes(volumeDensities(map), map.cells) };
  const cells = Math.min(map.cells, FIELD_CELLS);
  return { cells, values: bandWeights(distances(match.curves.reference, cells), bandwidth) };
}

function mismatchAt(match: Match, morph: number, bandwidth: number): Required<Field> {
  const map = thinned(movedGrid(match, morph), FIELD_CELLS);
  const d1 = distances(match.curves.reference, map.cells);
  const lengths = mismatches(map, match.curves.template, d1, bandwidth);
  return { cells: map.cells, values: lengths.map((length) => length * 2 ** match.level), d1 };
}

export function mapOf(match: Match) {
  return { cells: 2 ** match.level, deformation: match.deformation };
}

export function stretches(match: Match, morph = 1): Float64Array[] {
  const moves = movedLoops(match, morph);
  return match.curves.reference.map((loop, l) => {
    const moved = moves[l];
    return Float64Array.from({ length: loop.length / 2 }, (_, i) => stretch(loop, moved, i));
  });
}

type Curvatures = { readonly reference: readonly Float64Array[]; readonly partner: readonly Float64Array[] };
const known = new WeakMap<object, Curvatures>();

/** At every point of the reference, and of the template at the place nearest to its partner. */
export function bothCurvatures(match: Match): Curvatures {
  const before = known.get(match.deformation);
  if (before) return before;
  const { reference, template, matched } = match.curves;
  const reach = CURVATURE_CELLS / 2 ** match.level;
  const own = reference.map((loop) => curvatures(loop, reach));
  const theirs = template.map((loop) => curvatures(loop, reach));
  const partner = matched.map((loop) =>
    Float64Array.from({ length: loop.length / 2 }, (_, i) => {
      const at = nearest(template, loop[2 * i], loop[2 * i + 1]);
      return at ? theirs[at.loop][at.point] : Number.NaN;
    }),
  );
  const both = { reference: own, partner };
  known.set(match.deformation, both);
  return both;
}
