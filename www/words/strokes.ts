/** What the page says of strokes that are no shapes, and of the ways out. */

import type { Fault } from "../shapes/judge";
import { page } from "./language";
import { decimals } from "./numbers";
import { SIDES, type Side } from "./sides";

export const strokes = page("strokes", {
  faults: {
    crossing: (): string => "This line crosses itself, so it does not say what is inside.",
    flat: (): string => "This line encloses nothing: draw all the way round what is to be inside.",
    small: (size: string) => `This curve is ${size} cells wide, and the grid sees nothing below four.`,
    border: (): string => "This curve crosses the border of the box, or comes too close to it.",
  },
  ways: {
    crossing: "Keep its larger part",
    flat: "",
    small: "Enlarge it",
    border: "Move it inside",
  },
  /** Spoken when a shape is another one, or has another number of curves than before. */
  changed: (side: Side) => `The ${SIDES[side]} has changed.`,
  curves: (side: Side, count: number) => {
    if (count === 0) return `The ${SIDES[side]} is empty now.`;
    return count === 1
      ? `The ${SIDES[side]} is one closed curve now.`
      : `The ${SIDES[side]} has ${count} closed curves now.`;
  },
});

/** `size` in cells of the grid: how wide a curve is, or how far it is out. */
export function faultWords(fault: Fault, size: number): string {
  return strokes.faults[fault](decimals(size));
}

export function changeWords(side: Side, before: number, after: number): string {
  return after === before ? strokes.changed(side) : strokes.curves(side, after);
}
