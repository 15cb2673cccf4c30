/** Polygons given by their points as a choice: outlined, and asked whether they lie in the box already. */

import { bounds, type Shape } from "../geometry";
import { type Choice, ImportError } from "./found";
import { united } from "./region";

/** Shapes that keep two cells of the coarsest finest grid from the border can be taken as they stand. */
const CLEARANCE = 2 / 32;

/**
 * A loop encloses what it winds around; one inside another is a hole.
 * Throws when a loop has fewer than three points or nothing encloses an area.
 */
export function shapeFromLoops(
  name: string,
  loops: Shape,
  { mainPart = false, smoothing = 0 }: Partial<Pick<Choice, "mainPart" | "smoothing">> = {},
): Choice {
  loops.forEach((loop, i) => {
    if (loop.length < 6) {
      throw new ImportError(
        `Loop ${i + 1} of ${name} has ${loop.length / 2} points; a closed curve needs at least three.`,
      );
    }
  });
  const outlines = loops.map((loop) => united([{ loops: [loop], rule: "nonzero" }]));
  const shape = loops.length === 1 ? outlines[0] : united([{ loops: outlines.flat(), rule: "evenodd" }]);
  if (shape.length === 0) throw new ImportError(`The points of ${name} enclose no area.`);
  return { name, loops: shape, placed: liesInBox(loops), mainPart, smoothing };
}

export function liesInBox(shape: Shape): boolean {
  const box = bounds(shape);
  if (!box) return false;
  const least = Math.min(box.left, box.bottom);
  const most = Math.max(box.right, box.top);
  return least >= CLEARANCE && most <= 1 - CLEARANCE;
}
