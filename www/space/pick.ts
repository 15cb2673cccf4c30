/** Which point of a surface is under the pointer, and its partners. */

import { at, corners, cross, dot, minus, type Vector } from "./solid";

export type Picked = {
  /** The first of the three places in the list of triangles. */
  readonly triangle: number;
  /** Of its corners; they sum to one. */
  readonly weights: Vector;
};

/** The triangle that the ray meets first; null for none (T. Möller, B. Trumbore, "Fast, minimum storage ray/triangle", 1997). */
export function picked(eye: Vector, ray: Vector, positions: ArrayLike<number>, indices: Uint32Array): Picked | null {
  let nearest = Number.POSITIVE_INFINITY;
  let found: Picked | null = null;
  for (let k = 0; k < indices.length; k += 3) {
    const [p, q, r] = corners(positions, indices, k);
    const [one, other] = [minus(q, p), minus(r, p)];
    const across = cross(ray, other);
    const size = dot(one, across);
    if (size === 0) continue;
    const from = minus(eye, p);
    const b = dot(from, across) / size;
    const along = cross(from, one);
    const c = dot(ray, along) / size;
    const depth = dot(other, along) / size;
    if (b < 0 || c < 0 || b + c > 1 || depth <= 0 || depth >= nearest) continue;
    nearest = depth;
    found = { triangle: k, weights: [1 - b - c, b, c] };
  }
  return found;
}

/** The point with these weights, of vertices that may have been moved. */
export function pointOf({ triangle, weights }: Picked, positions: ArrayLike<number>, indices: Uint32Array): Vector {
  const all = [0, 1, 2].map((k) => at(positions, indices[triangle + k]));
  const [x, y, z] = [0, 1, 2].map((axis) => weights.reduce((sum, weight, k) => sum + weight * all[k][axis], 0));
  return [x, y, z];
}
