/** Where the plane folds on its way to a match; fetched when somebody leaves the end of the way. */

import { minDeterminant, thinned } from "./field";
import { identity } from "./identity";
import { movedAt, wayOf } from "./morph";
import type { Match } from "./result";

/** Cells a side on which folds are looked for. */
const FOLD_CELLS = 64;
const FOLD_STEPS = 20;

/** The part of the way, first and last, on which some cell is turned over; null for none. φ itself never folds. */
export function foldOf(match: Match): readonly [number, number] | null {
  const { cells, deformation } = thinned({ cells: 2 ** match.level, deformation: match.deformation }, FOLD_CELLS);
  const [way, nodes] = [wayOf(match), identity(cells)];
  const folded = Array.from({ length: FOLD_STEPS - 1 }, (_, k) => (k + 1) / FOLD_STEPS).filter(
    (s) => !(minDeterminant({ cells, deformation: movedAt(way, nodes, deformation, s) }) > 0),
  );
  return folded.length === 0 ? null : [folded[0], folded[folded.length - 1]];
}
