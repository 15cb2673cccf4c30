/** Distances from points to a surface. */

import { corners, cross, dot, minus, type Solid, type Vector } from "./solid";

/** Buckets a side of the box. */
const SIDE = 24;

/** Of each point, x y z each: how far the nearest triangle is, and which of its vertices is nearest. */
export function nearest(points: ArrayLike<number>, { positions, indices }: Pick<Solid, "positions" | "indices">) {
  const buckets = new Map<number, number[]>();
  const bucket = (at: number) => Math.min(SIDE - 1, Math.max(0, Math.floor(SIDE * at)));
  const key = (x: number, y: number, z: number) => (z * SIDE + y) * SIDE + x;
  for (let k = 0; k < indices.length; k += 3) {
    const triangle = corners(positions, indices, k);
    const span = [0, 1, 2].map((axis) => {
      const along = triangle.map((corner) => corner[axis]);
      return [bucket(Math.min(...along)), bucket(Math.max(...along))];
    });
    for (let z = span[2][0]; z <= span[2][1]; z += 1)
      for (let y = span[1][0]; y <= span[1][1]; y += 1)
        for (let x = span[0][0]; x <= span[0][1]; x += 1) {
          const list = buckets.get(key(x, y, z));
          if (list) list.push(k);
          else buckets.set(key(x, y, z), [k]);
        }
  }
  const out = { distances: new Float64Array(points.length / 3), vertices: new Uint32Array(points.length / 3) };
  for (let i = 0; i < out.distances.length; i += 1) {
    const point: Vector = [points[3 * i], points[3 * i + 1], points[3 * i + 2]];
    const [x, y, z] = point.map(bucket);
    let best = Number.POSITIVE_INFINITY;
    let triangle = 0;
    // Shell after shell of buckets, until what is farther away cannot be nearer. Points may lie outside of the box.
    const outside = Math.hypot(...point.map((at) => Math.max(0, -at, at - 1)));
    for (let reach = 0; reach < SIDE && best > Math.max(0, (reach - 1) / SIDE - outside); reach += 1) {
      for (let c = Math.max(0, z - reach); c <= Math.min(SIDE - 1, z + reach); c += 1)
        for (let b = Math.max(0, y - reach); b <= Math.min(SIDE - 1, y + reach); b += 1)
          for (let a = Math.max(0, x - reach); a <= Math.min(SIDE - 1, x + reach); a += 1) {
            if (Math.max(Math.abs(a - x), Math.abs(b - y), Math.abs(c - z)) !== reach) continue;
            for (const k of buckets.get(key(a, b, c)) ?? []) {
              const distance = toTriangle(point, ...corners(positions, indices, k));
              if (distance < best) [best, triangle] = [distance, k];
            }
          }
    }
    out.distances[i] = best;
    const away = corners(positions, indices, triangle).map((corner) => Math.hypot(...minus(corner, point)));
    out.vertices[i] = indices[triangle + away.indexOf(Math.min(...away))];
  }
  return out;
}

/** Inside, the height above the plane; else the distance to the nearest edge. */
export function toTriangle(point: Vector, p: Vector, q: Vector, r: Vector): number {
  const normal = cross(minus(q, p), minus(r, p));
  const sides = [
    [p, q],
    [q, r],
    [r, p],
  ] as const;
  const length = Math.hypot(...normal);
  if (length > 0 && sides.every(([a, b]) => dot(cross(normal, minus(b, a)), minus(point, a)) >= 0))
    return Math.abs(dot(normal, minus(point, p))) / length;
  return Math.min(...sides.map(([a, b]) => toSegment(point, a, b)));
}

function toSegment(point: Vector, a: Vector, b: Vector): number {
  const [along, from] = [minus(b, a), minus(point, a)];
  const part = Math.min(1, Math.max(0, dot(along, from) / (dot(along, along) || 1)));
  return Math.hypot(from[0] - part * along[0], from[1] - part * along[1], from[2] - part * along[2]);
}
