/**
 * The zero set of nodal values as triangles, by naive surface nets (S. Gibson, "Constrained elastic surface nets", 1998):
 * one vertex in each cell that the surface passes, one quadrilateral around each edge of the grid that it crosses.
 */

export type Lattice = {
  /** Nodes along each axis. */
  readonly sizes: readonly [number, number, number];
  /** From node to node along each axis. */
  readonly spacings: readonly [number, number, number];
  /** One a node, x fastest, negative inside. */
  readonly values: Float64Array;
};

/** Of (cells + 1)³ values in the unit box. */
export function zeroSetOfBox(cells: number, values: Float64Array) {
  const [size, spacing] = [cells + 1, 1 / cells];
  return zeroSet({ sizes: [size, size, size], spacings: [spacing, spacing, spacing], values });
}

/** Beyond the border is outside. */
export function zeroSet({ sizes: [width, height, depth], spacings, values }: Lattice) {
  // One layer more on all sides, so that the surface closes at the border.
  const steps = [1, width + 2, (width + 2) * (height + 2)];
  const nodes = new Float64Array(steps[2] * (depth + 2)).fill(Number.MAX_VALUE);
  for (let z = 0; z < depth; z += 1)
    for (let y = 0; y < height; y += 1) {
      const row = (z * height + y) * width;
      nodes.set(values.subarray(row, row + width), (z + 1) * steps[2] + (y + 1) * steps[1] + 1);
    }
  const vertexOf = new Map<number, number>();
  const positions: number[] = [];
  const indices: number[] = [];
  const vertex = (cell: number): number => {
    const known = vertexOf.get(cell);
    if (known !== undefined) return known;
    const sum = [0, 0, 0];
    let crossings = 0;
    for (let axis = 0; axis < 3; axis += 1) {
      const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
      for (const [i, j] of [
        [0, 0],
        [0, 1],
        [1, 0],
        [1, 1],
      ]) {
        const from = cell + i * steps[u] + j * steps[v];
        const [a, b] = [nodes[from], nodes[from + steps[axis]]];
        if (a < 0 === b < 0) continue;
        crossings += 1;
        sum[axis] += a / (a - b);
        sum[u] += i;
        sum[v] += j;
      }
    }
    const corner = [cell % steps[1], Math.floor(cell / steps[1]) % (height + 2), Math.floor(cell / steps[2])];
    for (let axis = 0; axis < 3; axis += 1) positions.push((corner[axis] - 1 + sum[axis] / crossings) * spacings[axis]);
    vertexOf.set(cell, positions.length / 3 - 1);
    return positions.length / 3 - 1;
  };
  for (let k = 0; k < nodes.length; k += 1)
    for (let axis = 0; axis < 3; axis += 1) {
      const next = k + steps[axis];
      if (next >= nodes.length || nodes[k] < 0 === nodes[next] < 0) continue;
      const [u, v] = [steps[(axis + 1) % 3], steps[(axis + 2) % 3]];
      const [a, b, c, d] = [k - u - v, k - v, k, k - u].map(vertex);
      if (nodes[k] < 0) indices.push(a, b, c, a, c, d);
      else indices.push(a, c, b, a, d, c);
    }
  return { positions: Float64Array.from(positions), indices: Uint32Array.from(indices) };
}
