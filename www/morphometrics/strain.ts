/**
 * How a deformation strains the plane, cell by cell. With F = factor · Dφ at a cell's middle, λ₁ ≥ λ₂ are its singular
 * values, λ₁ − 1 and λ₂ − 1 the principal strains, det F = λ₁ λ₂ the expansion: 1 where areas stay.
 */

export type Strains = {
  /** Cells a side; all lists are cell by cell, x fastest. */
  readonly cells: number;
  readonly first: Float64Array;
  readonly second: Float64Array;
  /** Of the first principal direction in the reference, radians in (−π/2, π/2]. */
  readonly angle: Float64Array;
  readonly expansion: Float64Array;
};

/** φ at the nodes, x y a node, x fastest. */
export function strains(deformation: Float64Array, factor: number): Strains {
  const side = Math.round(Math.sqrt(deformation.length / 2));
  const cells = side - 1;
  const made = () => new Float64Array(cells * cells);
  const [first, second, angle, expansion] = [made(), made(), made(), made()];
  for (let j = 0; j < cells; j += 1) {
    for (let i = 0; i < cells; i += 1) {
      const [a, b, c, d] = gradient(deformation, side, i, j).map((value) => factor * cells * value);
      // λ² are the eigenvalues of FᵀF.
      const [xx, xy, yy] = [a * a + c * c, a * b + c * d, b * b + d * d];
      const [mean, spread] = [(xx + yy) / 2, Math.hypot((xx - yy) / 2, xy)];
      const determinant = a * d - b * c;
      const most = Math.sqrt(mean + spread);
      const at = j * cells + i;
      first[at] = most - 1;
      second[at] = determinant / most - 1;
      angle[at] = Math.atan2(2 * xy, xx - yy) / 2;
      expansion[at] = determinant;
    }
  }
  return { cells, first, second, angle, expansion };
}

/** ∂φx/∂x, ∂φx/∂y, ∂φy/∂x, ∂φy/∂y at the middle of a cell, in units of a cell: the mean over two edges each. */
function gradient(deformation: Float64Array, side: number, i: number, j: number): readonly number[] {
  const at = (di: number, dj: number, part: number) => deformation[2 * ((j + dj) * side + i + di) + part];
  return [0, 1].flatMap((part) => [
    (at(1, 0, part) - at(0, 0, part) + at(1, 1, part) - at(0, 1, part)) / 2,
    (at(0, 1, part) - at(0, 0, part) + at(1, 1, part) - at(1, 0, part)) / 2,
  ]);
}
