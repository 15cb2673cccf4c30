/** The matched points as a table, one point of the reference a line. */

import type { Curves } from "../protocol";
import type { Loop, Shape } from "../shapes/geometry";
import { arcLengthParts } from "../view/curve";

/**
 * Columns: `loop` (from 0), the point `x, y` and its partner `phi_x, phi_y`, `arc_length` (the part 0…1 of the whole
 * reference's length reached there), `stretch` (|Dφ t| by central differences along the curve) and `distance` of the
 * partner to the template. Lengths in sides of the box, y up.
 */
export function csv({ reference, template, matched }: Curves): string {
  const parts = arcLengthParts(reference);
  const lines = ["loop,x,y,phi_x,phi_y,arc_length,stretch,distance"];
  reference.forEach((loop, l) => {
    const moved = matched[l];
    for (let i = 0; i < loop.length / 2; i += 1) {
      const [x, y] = [moved[2 * i], moved[2 * i + 1]];
      const values = [
        loop[2 * i],
        loop[2 * i + 1],
        x,
        y,
        parts[l][i],
        stretch(loop, moved, i),
        distance(template, x, y),
      ];
      lines.push(`${l},${values.map((value) => String(value)).join(",")}`);
    }
  });
  return `${lines.join("\n")}\n`;
}

/** The length around point i after, over before. */
export function stretch(loop: Loop, moved: Loop, i: number): number {
  const n = loop.length / 2;
  const [before, after] = [(i + n - 1) % n, (i + 1) % n];
  const span = (points: Loop) =>
    Math.hypot(points[2 * i] - points[2 * before], points[2 * i + 1] - points[2 * before + 1]) +
    Math.hypot(points[2 * after] - points[2 * i], points[2 * after + 1] - points[2 * i + 1]);
  return span(moved) / span(loop);
}

/** To the nearest edge of the closed polylines. */
export function distance(shape: Shape, x: number, y: number): number {
  let least = Infinity;
  for (const loop of shape) {
    for (let i = 0, j = loop.length - 2; i < loop.length; j = i, i += 2) {
      const [u, v] = [loop[i] - loop[j], loop[i + 1] - loop[j + 1]];
      const [a, b] = [x - loop[j], y - loop[j + 1]];
      const square = u * u + v * v;
      const t = square > 0 ? Math.min(1, Math.max(0, (a * u + b * v) / square)) : 0;
      least = Math.min(least, Math.hypot(a - t * u, b - t * v));
    }
  }
  return least;
}
