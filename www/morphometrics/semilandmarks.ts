/** Points along outlines that correspond: even on the reference, carried to each target by its match. */

import { perimeter, resampled, type Shape } from "../shapes/geometry";
import { nearest } from "../view/along";

/** A closed curve has three at least. */
const FEWEST = 3;

/**
 * `count` points, loop after loop, evenly along each from its first point on; loops get of them what their length asks
 * for, three at least.
 */
export function evenPoints(shape: Shape, count: number): Float64Array {
  if (count < FEWEST * shape.length) {
    throw new Error(`${shape.length} closed curves need ${FEWEST * shape.length} points at least, not ${count}.`);
  }
  const lengths = shape.map(perimeter);
  const shares = lengths.map(() => FEWEST);
  // One by one to where they lie furthest apart.
  for (let given = FEWEST * shape.length; given < count; given += 1) {
    let widest = 0;
    for (let l = 1; l < shape.length; l += 1) {
      if (lengths[l] / shares[l] > lengths[widest] / shares[widest]) widest = l;
    }
    shares[widest] += 1;
  }
  return Float64Array.from(shape.flatMap((loop, l) => [...resampled(loop, shares[l])]));
}

/** Each point moved to the nearest place of the outline: a match ends a small part of a cell off it. */
export function onOutline(points: Float64Array, shape: Shape): Float64Array {
  const out = new Float64Array(points.length);
  for (let i = 0; i < points.length; i += 2) {
    const place = nearest(shape, points[i], points[i + 1]);
    if (!place) throw new Error("there is no outline");
    const loop = shape[place.loop];
    const [from, to] = [2 * place.edge, (2 * place.edge + 2) % loop.length];
    out[i] = loop[from] + place.part * (loop[to] - loop[from]);
    out[i + 1] = loop[from + 1] + place.part * (loop[to + 1] - loop[from + 1]);
  }
  return out;
}
