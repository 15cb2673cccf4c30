/** Closed triangle meshes: where they lie in the box, their normals and areas. No DOM, no solver. */

import { space as say } from "../words/space";

export type Vector = readonly [x: number, y: number, z: number];

/** A mesh in the box [0,1]³, y up. It never changes. */
export type Solid = {
  /** Of the gallery, or of what is kept in this browser. */
  readonly id: string;
  readonly name: string;
  /** x y z a vertex. */
  readonly positions: Float64Array;
  /** Three vertices a triangle, counter-clockwise seen from outside. */
  readonly indices: Uint32Array;
};

/** The longest side of a mesh that has been fitted into the box. */
const EXTENT = 0.6;

type Mesh = Pick<Solid, "positions" | "indices">;

/** What the triangles fill: what none of them uses is no part of the surface. */
export function box({ positions, indices }: Mesh) {
  const [least, most] = [[1, 1, 1].map(() => Number.POSITIVE_INFINITY), [1, 1, 1].map(() => Number.NEGATIVE_INFINITY)];
  for (const vertex of indices)
    for (let axis = 0; axis < 3; axis += 1) {
      const at = positions[3 * vertex + axis];
      least[axis] = Math.min(least[axis], at);
      most[axis] = Math.max(most[axis], at);
    }
  const extent = Math.max(...most.map((value, axis) => value - least[axis]));
  if (!(extent > 0)) throw new Error(say.files.flat);
  if (extent === Number.POSITIVE_INFINITY) throw new Error(say.files.far);
  return { least, most, extent };
}

/** The mesh scaled and moved into the middle of the box, with its triangles outward. Throws a sentence's part. */
export function fitted({ positions, indices }: Mesh) {
  const { least, most, extent } = box({ positions, indices });
  const middle = least.map((value, axis) => value + (most[axis] - value) / 2);
  const placed = positions.map((at, k) => 0.5 + EXTENT * ((at - middle[k % 3]) / extent));
  return { positions: placed, indices: outward(placed, indices) };
}

function outward(positions: Float64Array, indices: Uint32Array): Uint32Array {
  if (volume(positions, indices) >= 0) return indices;
  return indices.map((_, k) => indices[k % 3 === 0 ? k : k % 3 === 1 ? k + 1 : k - 1]);
}

/** Positive where the triangles are counter-clockwise seen from outside. */
export function volume(positions: ArrayLike<number>, indices: Uint32Array): number {
  let sum = 0;
  for (let k = 0; k < indices.length; k += 3) {
    const [p, q, r] = corners(positions, indices, k);
    sum += dot(p, cross(q, r)) / 6;
  }
  return sum;
}

/** Unit normals, x y z a vertex: those of its triangles, by area. */
export function normals(positions: ArrayLike<number>, indices: Uint32Array): Float32Array {
  const sums = new Float32Array(positions.length);
  for (let k = 0; k < indices.length; k += 3) {
    const normal = twiceArea(positions, indices, k);
    for (let corner = 0; corner < 3; corner += 1)
      for (let axis = 0; axis < 3; axis += 1) sums[3 * indices[k + corner] + axis] += normal[axis];
  }
  for (let k = 0; k < sums.length; k += 3) {
    const length = Math.hypot(sums[k], sums[k + 1], sums[k + 2]) || 1;
    for (let axis = 0; axis < 3; axis += 1) sums[k + axis] /= length;
  }
  return sums;
}

/** How much the triangles around each vertex grow. */
export function areaRatios(before: ArrayLike<number>, after: ArrayLike<number>, indices: Uint32Array): Float64Array {
  const [old, now] = [before, after].map((positions) => {
    const sums = new Float64Array(positions.length / 3);
    for (let k = 0; k < indices.length; k += 3) {
      const area = Math.hypot(...twiceArea(positions, indices, k));
      for (let corner = 0; corner < 3; corner += 1) sums[indices[k + corner]] += area;
    }
    return sums;
  });
  return now.map((area, vertex) => area / old[vertex]);
}

export function corners(positions: ArrayLike<number>, indices: Uint32Array, k: number): [Vector, Vector, Vector] {
  return [at(positions, indices[k]), at(positions, indices[k + 1]), at(positions, indices[k + 2])];
}

export function at(positions: ArrayLike<number>, vertex: number): Vector {
  return [positions[3 * vertex], positions[3 * vertex + 1], positions[3 * vertex + 2]];
}

function twiceArea(positions: ArrayLike<number>, indices: Uint32Array, k: number): Vector {
  const [p, q, r] = corners(positions, indices, k);
  return cross(minus(q, p), minus(r, p));
}

export function minus(a: Vector, b: Vector): Vector {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

export function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function cross(a: Vector, b: Vector): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

export function unit(v: Vector): Vector {
  const length = Math.hypot(...v);
  return [v[0] / length, v[1] / length, v[2] / length];
}
