/** Parts of the target that the moved reference has not come to. */

import { nearest } from "./along";

type Loops = readonly Float64Array[];

/** A match that may have missed parts, with what the solver says of it. */
type Judged = {
  readonly status: { readonly finished: boolean; readonly level: number; readonly cover: { readonly max: number } };
  readonly curves: { readonly template: Loops; readonly matched: Loops };
};

/** Farther than so many cells is not reached: what the solver's verdict takes for covered. */
const REACHED_CELLS = 1;

/** Looked for only where the solver says that there is something. */
export function missedBy(match: Judged | null): Float64Array[] {
  if (!match?.status.finished || !(match.status.cover.max > REACHED_CELLS)) return [];
  const { status, curves } = match;
  return unreached(curves.template, curves.matched, status.level);
}

/** Stretches of the target's loops farther from the moved curve than a cell, as open polylines; whole loops closed. */
export function unreached(target: Loops, moved: Loops, level: number): Float64Array[] {
  const reach = REACHED_CELLS / 2 ** level;
  return target.flatMap((loop) => {
    const count = loop.length / 2;
    const far = Array.from(
      { length: count },
      (_, i) => (nearest(moved, loop[2 * i], loop[2 * i + 1])?.distance ?? Number.POSITIVE_INFINITY) > reach,
    );
    if (far.every(Boolean)) return [Float64Array.of(...loop, loop[0], loop[1])];
    const begin = far.indexOf(false);
    const out: number[][] = [];
    for (let k = 0; k < count; k += 1) {
      const i = (begin + k) % count;
      if (!far[i]) continue;
      // It begins at the last point that was reached, so that no gap is left.
      const before = (i + count - 1) % count;
      if (!far[before]) out.push([loop[2 * before], loop[2 * before + 1]]);
      const next = (i + 1) % count;
      out[out.length - 1].push(loop[2 * i], loop[2 * i + 1]);
      if (!far[next]) out[out.length - 1].push(loop[2 * next], loop[2 * next + 1]);
    }
    return out.map((points) => Float64Array.from(points));
  });
}
