/**
 * The energies' densities where they can be seen: stretching and bending along the curve, volume over the plane. The
 * same formulas as the solver's (src/energy/membrane.rs, bending.rs, volume.rs), without weights and less what they are at
 * rest, so that nothing deformed is nothing shown.
 */

import { SETTINGS } from "../wasm/settings.js";
import type { GridMap } from "./field";

function initial(name: "lambda" | "mu"): number {
  const setting = SETTINGS.find((candidate) => candidate.name === name);
  return setting?.kind === "number" ? setting.initial : Number.NaN;
}

/** No setting of the page: the solver's own. */
const LAMBDA = initial("lambda");
const MU = initial("mu");

/** g(x) = (λ − 2μ)/8 x + (λ + 2μ)/8 x⁻¹, of squared determinants. */
function dilation(x: number): number {
  return ((LAMBDA - 2 * MU) / 8) * x + (LAMBDA + 2 * MU) / 8 / x;
}

/** W = μ/2 s² + g(s²) at the stretch s. */
export function stretchingAt(stretch: number): number {
  return (MU / 2) * stretch ** 2 + dilation(stretch ** 2) - stretchingAtRest;
}

const stretchingAtRest = MU / 2 + LAMBDA / 4;

/** W = (s² κ₂ − κ₁)²: curvatures of the target at the partner and of the reference. Units: length⁻². */
export function bendingAt(stretch: number, own: number, partner: number): number {
  return (stretch ** 2 * partner - own) ** 2;
}

/** What the plane's density is where nothing is deformed. */
export const VOLUME_AT_REST = MU + LAMBDA / 4;

/** W = μ/2 |F|² + g((det F)²) in the middle of every cell, less its rest; x fastest. */
export function volumeDensities({ cells, deformation: d }: GridMap): Float64Array {
  const row = 2 * (cells + 1);
  return Float64Array.from({ length: cells * cells }, (_, cell) => {
    const i = cell % cells;
    const a = ((cell - i) / cells) * row + 2 * i;
    const half = cells / 2;
    const across = [0, 1].map((k) => half * (d[a + 2 + k] - d[a + k] + d[a + row + 2 + k] - d[a + row + k]));
    const up = [0, 1].map((k) => half * (d[a + row + k] - d[a + k] + d[a + row + 2 + k] - d[a + 2 + k]));
    const square = across[0] ** 2 + across[1] ** 2 + up[0] ** 2 + up[1] ** 2;
    const determinant = across[0] * up[1] - across[1] * up[0];
    return (MU / 2) * square + dilation(determinant ** 2) - VOLUME_AT_REST;
  });
}

/** Values of cells at the nodes: the mean over the cells that meet there. */
export function atNodes(values: Float64Array, cells: number): Float64Array {
  const side = cells + 1;
  return Float64Array.from({ length: side * side }, (_, node) => {
    const [i, j] = [node % side, Math.floor(node / side)];
    let [sum, count] = [0, 0];
    for (const [p, q] of [
      [i - 1, j - 1],
      [i, j - 1],
      [i - 1, j],
      [i, j],
    ]) {
      if (p < 0 || q < 0 || p >= cells || q >= cells) continue;
      sum += values[q * cells + p];
      count += 1;
    }
    return sum / count;
  });
}
