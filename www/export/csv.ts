/** The matched points as a table, one point of the reference a line. */

import type { Curves } from "../protocol";
import { nearest, stretch } from "../view/along";
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
        nearest(template, x, y)?.distance ?? Number.POSITIVE_INFINITY,
      ];
      lines.push(`${l},${values.map((value) => String(value)).join(",")}`);
    }
  });
  return `${lines.join("\n")}\n`;
}
