/** Fields of a deformation at its nodes (x fastest) and at points: determinant, band, mismatch. Domain units. */

import { signedDistance } from "./along";

/** φ on a grid of `cells` a side. */
export type GridMap = { readonly cells: number; readonly deformation: Float64Array };

/** Every (cells / most)th node of a finer map. */
export function thinned({ cells, deformation }: GridMap, most: number): GridMap {
  if (cells <= most) return { cells, deformation };
  const stride = cells / most;
  const side = cells + 1;
  const out = new Float64Array(2 * (most + 1) ** 2);
  for (let j = 0; j <= most; j += 1) {
    for (let i = 0; i <= most; i += 1) {
      const from = 2 * (j * stride * side + i * stride);
      const to = 2 * (j * (most + 1) + i);
      out[to] = deformation[from];
      out[to + 1] = deformation[from + 1];
    }
  }
  return { cells: most, deformation: out };
}

/** The cell of a point of the box, and the point's place in it, each 0 to 1. */
function locate(cells: number, x: number, y: number) {
  const i = Math.min(cells - 1, Math.max(0, Math.floor(x * cells)));
  const j = Math.min(cells - 1, Math.max(0, Math.floor(y * cells)));
  return { node: j * (cells + 1) + i, u: x * cells - i, v: y * cells - j };
}

/** Nodal values between their nodes; NaN beside a node without a value. */
export function valueAt(values: Float64Array, cells: number, x: number, y: number): number {
  const { node, u, v } = locate(cells, x, y);
  const above = node + cells + 1;
  return (
    (1 - v) * ((1 - u) * values[node] + u * values[node + 1]) + v * ((1 - u) * values[above] + u * values[above + 1])
  );
}

/** φ(x). */
export function mapped({ cells, deformation: d }: GridMap, x: number, y: number): [number, number] {
  const { node, u, v } = locate(cells, x, y);
  const a = 2 * node;
  const b = 2 * (node + cells + 1);
  const at = (k: number) =>
    (1 - v) * ((1 - u) * d[a + k] + u * d[a + 2 + k]) + v * ((1 - u) * d[b + k] + u * d[b + 2 + k]);
  return [at(0), at(1)];
}

/** det Dφ: the factor by which areas grow. */
export function determinantAt({ cells, deformation: d }: GridMap, x: number, y: number): number {
  const { node, u, v } = locate(cells, x, y);
  const a = 2 * node;
  const b = 2 * (node + cells + 1);
  const across = (k: number) => (1 - v) * (d[a + 2 + k] - d[a + k]) + v * (d[b + 2 + k] - d[b + k]);
  const up = (k: number) => (1 - u) * (d[b + k] - d[a + k]) + u * (d[b + 2 + k] - d[a + 2 + k]);
  return cells * cells * (across(0) * up(1) - across(1) * up(0));
}

/** The least det Dφ over all corners of cells, where a bilinear map has it. */
export function minDeterminant({ cells, deformation: d }: GridMap): number {
  let least = Number.POSITIVE_INFINITY;
  const row = 2 * (cells + 1);
  for (let j = 0; j < cells; j += 1) {
    for (let i = 0; i < cells; i += 1) {
      const a = j * row + 2 * i;
      // Each corner's two edges: along x, then along y.
      for (const [x, y] of [
        [a, a],
        [a, a + 2],
        [a + row, a],
        [a + row, a + 2],
      ]) {
        const across = [d[x + 2] - d[x], d[x + 3] - d[x + 1]];
        const up = [d[y + row] - d[y], d[y + row + 1] - d[y + 1]];
        least = Math.min(least, across[0] * up[1] - across[1] * up[0]);
      }
    }
  }
  return cells * cells * least;
}

/** log₂ det Dφ at the nodes: the mean over the cells that meet there. */
export function logDeterminants(map: GridMap): Float64Array {
  const { cells } = map;
  const side = cells + 1;
  const sums = new Float64Array(side * side);
  const counts = new Uint8Array(side * side);
  // A hair inside each cell's corner, so that the point belongs to that cell.
  const inset = 1e-9;
  for (let j = 0; j < cells; j += 1) {
    for (let i = 0; i < cells; i += 1) {
      for (const [p, q] of [
        [0, 0],
        [1, 0],
        [0, 1],
        [1, 1],
      ]) {
        const node = (j + q) * side + i + p;
        const x = (i + (p === 0 ? inset : 1 - inset)) / cells;
        const y = (j + (q === 0 ? inset : 1 - inset)) / cells;
        sums[node] += Math.log2(determinantAt(map, x, y));
        counts[node] += 1;
      }
    }
  }
  return sums.map((sum, node) => sum / counts[node]);
}

/** The distance d₁ to the reference at the nodes. */
export function distances(reference: readonly Float64Array[], cells: number): Float64Array {
  const side = cells + 1;
  return Float64Array.from({ length: side * side }, (_, node) =>
    signedDistance(reference, (node % side) / cells, Math.floor(node / side) / cells),
  );
}

/** The band's weight η(d₁/σ) = (1 − (d₁/σ)²)² inside |d₁| < σ, 0 outside. */
export function bandWeights(d1: Float64Array, bandwidth: number): Float64Array {
  return d1.map((distance) => Math.max(0, 1 - (distance / bandwidth) ** 2) ** 2);
}

/** |d₂∘φ − d₁| at the nodes of the band and of the cells it cuts; NaN elsewhere, where the energy does not see it. */
export function mismatches(
  map: GridMap,
  template: readonly Float64Array[],
  d1: Float64Array,
  bandwidth: number,
): Float64Array {
  const reach = bandwidth + Math.SQRT2 / map.cells;
  return d1.map((distance, node) =>
    Math.abs(distance) < reach
      ? Math.abs(signedDistance(template, map.deformation[2 * node], map.deformation[2 * node + 1]) - distance)
      : Number.NaN,
  );
}
