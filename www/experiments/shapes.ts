/** The experiments' shapes, sampled so finely that their corners lie far below the finest grid's spacing. */

import { about, type Shape as Loops, type Point, transformed } from "../shapes/geometry";
import { PRESETS } from "../shapes/presets";
import type { Shape } from "./experiment";

const CENTRE: Point = { x: 0.5, y: 0.5 };
const SAMPLES = 2048;

export function curves(...loops: Float64Array[]): Shape {
  return { kind: "curves", loops };
}

/** Half axes along x and y. */
export function ellipse(a: number, b: number): Shape {
  const loop = new Float64Array(2 * SAMPLES);
  for (let i = 0; i < SAMPLES; i += 1) {
    const t = (2 * Math.PI * i) / SAMPLES;
    loop[2 * i] = CENTRE.x + a * Math.cos(t);
    loop[2 * i + 1] = CENTRE.y + b * Math.sin(t);
  }
  return curves(loop);
}

export function circle(radius: number): Shape {
  return ellipse(radius, radius);
}

/** A square of half side `half` with circular corners, turned counter-clockwise. */
export function roundedSquare(half: number, corner: number, degrees: number): Shape {
  const flat = half - corner;
  const points: number[] = [];
  for (let quarter = 0; quarter < 4; quarter += 1) {
    const x = quarter === 0 || quarter === 3 ? flat : -flat;
    const y = quarter < 2 ? flat : -flat;
    for (let k = 0; k <= 128; k += 1) {
      const t = (quarter * Math.PI) / 2 + (k * Math.PI) / 256;
      points.push(CENTRE.x + x + corner * Math.cos(t), CENTRE.y + y + corner * Math.sin(t));
    }
  }
  return curves(...transformed([Float64Array.from(points)], about(CENTRE, 1, (degrees * Math.PI) / 180)));
}

/** A pair of the page's examples. */
export function example(id: string): { readonly reference: Shape; readonly template: Shape } {
  const preset = PRESETS.find((preset) => preset.id === id);
  if (!preset) throw new Error(`there is no example "${id}"`);
  const shape = (loops: Loops) => curves(...loops);
  return { reference: shape(preset.reference), template: shape(preset.template) };
}

/** The ellipse's perimeter: the trapezoidal rule, which converges exponentially on a period. */
export function ellipsePerimeter(a: number, b: number): number {
  let sum = 0;
  for (let i = 0; i < SAMPLES; i += 1) {
    const t = (2 * Math.PI * i) / SAMPLES;
    sum += Math.hypot(a * Math.sin(t), b * Math.cos(t));
  }
  return (2 * Math.PI * sum) / SAMPLES;
}
