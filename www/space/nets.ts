/**
 * The zero set of nodal values as triangles, by naive surface nets (S. Gibson, "Constrained elastic surface nets", 1998):
 * one vertex in each cell that the surface passes, one quadrilateral around each edge of the grid that it crosses.
 */

/** (cells + 1)³ values, x fastest, negative inside. Beyond the border is outside. */
export function zeroSet(cells: number, values: Float64Array) {
  // One layer more on all sides, so that the surface closes at the border.
  const side = cells + 3;
  const at = (x: number, y: number, z: number) => {
    const inside = [x, y, z].every((k) => k >= 1 && k <= cells + 1);
    return inside ? values[((z - 1) * (cells + 1) + y - 1) * (cells + 1) + x - 1] : Number.MAX_VALUE;
  };
  const nodes = Float64Array.from({ length: side ** 3 }, (_, k) =>
    at(k % side, Math.floor(k / side) % side, Math.floor(k / side ** 2)),
  );
  const steps = [1, side, side * side];
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
    const corner = [cell % side, Math.floor(cell / side) % side, Math.floor(cell / side ** 2)];
    for (let axis = 0; axis < 3; axis += 1) positions.push((corner[axis] - 1 + sum[axis] / crossings) / cells);
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
