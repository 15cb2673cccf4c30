/** What the page says of strokes that are no shapes, and of the ways out. */

import type { Fault } from "../shapes/judge";
import { decimals } from "./numbers";

/** `size` in cells of the grid: how wide a curve is, or how far it is out. */
export function faultWords(fault: Fault, size: number): string {
  switch (fault) {
    case "crossing":
      return "This line crosses itself, so it does not say what is inside.";
    case "flat":
      return "This line encloses nothing: draw all the way round what is to be inside.";
    case "small":
      return `This curve is ${decimals(size)} cells wide, and the grid sees nothing below four.`;
    case "border":
      return "This curve crosses the border of the box, or comes too close to it.";
  }
}

export const WAYS: Readonly<Record<Fault, string>> = {
  crossing: "Keep its larger part",
  flat: "",
  small: "Enlarge it",
  border: "Move it inside",
};

/** Spoken when a shape has another number of curves than before, or is another one. */
export function changeWords(side: "reference" | "template", before: number, after: number): string {
  if (after === before) return `The ${side} has changed.`;
  if (after === 0) return `The ${side} is empty now.`;
  return after === 1 ? `The ${side} is one closed curve now.` : `The ${side} has ${after} closed curves now.`;
}
