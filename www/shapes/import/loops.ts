/** Polygons given by their points as a choice: outlined, and asked whether they lie in the box already. */

import { bounds, type Shape } from "../geometry";
import { type Choice, ImportError, MOST_NUMBER } from "./found";
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
  checkSize(name, loops);
  const outlines = loops.map((loop) => united([{ loops: [loop], rule: "nonzero" }]));
  const shape = loops.length === 1 ? outlines[0] : united([{ loops: outlines.flat(), rule: "evenodd" }]);
  if (shape.length === 0) throw new ImportError(`The points of ${name} enclose no area.`);
  return { name, loops: shape, placed: liesInBox(loops), mainPart, smoothing };
}

function checkSize(name: string, loops: Shape): void {
  const box = bounds(loops);
  if (!box) return;
  const farthest = Math.max(...Object.values(box).map(Math.abs));
  const size = Math.max(box.right - box.left, box.top - box.bottom);
  if (farthest > MOST_NUMBER || (size > 0 && size < 1 / MOST_NUMBER))
    throw new ImportError(`The numbers of ${name} are too large or too small to be computed with; take another unit.`);
}

/** Each of a list as a choice: one that is none does not keep the others out. Throws where none is. */
export function choicesFrom<T>(
  list: readonly T[],
  nameOf: (item: T, index: number) => string,
  make: (item: T, name: string) => Choice,
): Choice[] {
  let [first, good]: [ImportError | null, number] = [null, 0];
  const choices = list.map((item, index): Choice => {
    const name = nameOf(item, index);
    try {
      const choice = make(item, name);
      good += 1;
      return choice;
    } catch (error) {
      if (!(error instanceof ImportError)) throw error;
      first ??= error;
      return { name, loops: [], placed: false, mainPart: false, smoothing: 0, problem: error.message };
    }
  });
  if (first && good === 0) throw first;
  return choices;
}

export function liesInBox(shape: Shape): boolean {
  const box = bounds(shape);
  if (!box) return false;
  const least = Math.min(box.left, box.bottom);
  const most = Math.max(box.right, box.top);
  return least >= CLEARANCE && most <= 1 - CLEARANCE;
}
