/** What is read off a deformation or off matched curves. */

import { perimeter } from "../shapes/geometry";
import type { Curves } from "./solve";

/** Points and weights of the Gauss rule of order 5 on [0,1]. */
const GAUSS: readonly (readonly [number, number])[] = [
  [0.5 - Math.sqrt(0.15), 5 / 18],
  [0.5, 8 / 18],
  [0.5 + Math.sqrt(0.15), 5 / 18],
];

/**
 * Mean and standard deviation of l = |Dφ t| over the ring | |x − c| − radius | < h around the box's middle c, by area;
 * t is the circles' tangent at x. Three Gauss points an axis in every cell, those inside the ring counted.
 */
export function ringStretch(
  level: number,
  deformation: Float64Array,
  radius: number,
): { mean: number; deviation: number } {
  const side = 2 ** level + 1;
  const h = 1 / (side - 1);
  let [weight, sum, square] = [0, 0, 0];
  for (let j = 0; j < side - 1; j += 1)
    for (let i = 0; i < side - 1; i += 1)
      for (const [v, weightY] of GAUSS)
        for (const [u, weightX] of GAUSS) {
          const x = (i + u) * h - 0.5;
          const y = (j + v) * h - 0.5;
          const distance = Math.hypot(x, y);
          if (Math.abs(distance - radius) >= h) continue;
          let length = 0;
          for (const k of [0, 1]) {
            const at = 2 * (j * side + i) + k;
            const [p, q] = [deformation[at], deformation[at + 2]];
            const [r, s] = [deformation[at + 2 * side], deformation[at + 2 * side + 2]];
            const alongX = ((1 - v) * (q - p) + v * (s - r)) / h;
            const alongY = ((1 - u) * (r - p) + u * (s - q)) / h;
            length += ((alongY * x - alongX * y) / distance) ** 2;
          }
          const w = weightX * weightY;
          weight += w;
          sum += w * Math.sqrt(length);
          square += w * length;
        }
  const mean = sum / weight;
  return { mean, deviation: Math.sqrt(square / weight - mean * mean) };
}

export function length(loops: readonly Float64Array[]): number {
  return loops.reduce((sum, loop) => sum + perimeter(loop), 0);
}

/** The rotation, in degrees, that takes the reference's points to the matched ones best in the least squares sense. */
export function rotationAngle({ reference, matched }: Curves): number {
  const from = middle(reference);
  const to = middle(matched);
  let [cos, sin] = [0, 0];
  reference.forEach((loop, l) => {
    for (let i = 0; i < loop.length; i += 2) {
      const [a, b] = [loop[i] - from.x, loop[i + 1] - from.y];
      const [u, v] = [matched[l][i] - to.x, matched[l][i + 1] - to.y];
      cos += a * u + b * v;
      sin += a * v - b * u;
    }
  });
  return (Math.atan2(sin, cos) * 180) / Math.PI;
}

function middle(loops: readonly Float64Array[]): { x: number; y: number } {
  let [x, y, count] = [0, 0, 0];
  for (const loop of loops)
    for (let i = 0; i < loop.length; i += 2) {
      x += loop[i];
      y += loop[i + 1];
      count += 1;
    }
  return { x: x / count, y: y / count };
}

/** The exponent p of e ∼ hᵖ from one level to the next, h halved. */
export function order(coarser: number, finer: number): number {
  return Math.log2(coarser / finer);
}
