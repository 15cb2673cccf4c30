/** What the page says of pins. */

import type { Point } from "../shapes/geometry";
import { page } from "../words/language";
import { decimals } from "../words/numbers";
import { place } from "../words/place";
import { SIDES, type Side } from "../words/sides";

export const actions = page("pinActions", {
  first: "Press a point of the reference, then its partner on the target.",
  partner: (number: number, side: Side) =>
    `Now the partner of pin ${number}: press where it belongs on the ${SIDES[side]}.`,
  chosen: (index: number) => `Pin ${index + 1}: drag either end, or delete it.`,
  delete: (index: number) => `Delete pin ${index + 1}`,
  deleteAll: "Delete all pins",
});

/** Spoken, pins counted from 0. */
export const told = page("pinsTold", {
  begun: (index: number, side: Side, at: Point) => `Pin ${index + 1} begun on the ${SIDES[side]}: ${place(at)}.`,
  set: (index: number, from: Point, to: Point) => `Pin ${index + 1} set: ${place(from)} goes to ${place(to)}.`,
  moved: (index: number, at: Point) => `Pin ${index + 1} moved: ${place(at)}.`,
  chosen: (index: number, at: Point) => `Pin ${index + 1} chosen: ${place(at)}.`,
  takenUp: (index: number) => `Pin ${index + 1} taken up: arrow keys move it, Enter sets it down, Escape puts it back.`,
  deleted: (index: number) => `Pin ${index + 1} deleted.`,
  allDeleted: "All pins deleted.",
  putBack: "Put back.",
  givenUp: "The pin is given up.",
  full: (most: number) => `There are ${most} pins already: delete one first.`,
  onCurve: ", on the curve",
  atPin: (index: number) => `, at pin ${index + 1}`,
});

/** A pin that is not where it was to be; distances in cells. */
type Off = { readonly index: number; readonly cells: number };

export const reports = page("pinReports", {
  aside: ({ index, cells }: Off) =>
    `Pin ${index + 1} ties two points of which one lies ${decimals(cells)} cells farther from its curve: the match cannot both fit and follow it. Drag it to the curve, where it snaps.`,
  ignored: "The pins are ignored: their strength is 0.",
  off: (far: readonly Off[]) => {
    const [first, ...others] = far.map(({ index, cells }, k) =>
      k === 0
        ? `Pin ${index + 1} ends ${decimals(cells)} cells from its partner`
        : `pin ${index + 1} ${decimals(cells)} cells`,
    );
    const list = [first, ...others.slice(0, 3)].join(", ");
    const more = others.length > 3 ? `, and ${others.length - 3} more` : "";
    const remedy =
      far.length > 1
        ? "move them, or raise their strength in the settings"
        : "move it, or raise the strength of pins in the settings";
    return `${list}${more}: ${remedy}.`;
  },
});

/** Nearer to its partner than this, in cells, a pin holds. */
const FAR = 1;

/** Of pins that ask for what the fit forbids: how much farther from its curve one end lies than the other, in cells. */
export function pinsAside(distances: readonly number[]): string | null {
  const index = distances.findIndex((cells) => cells > FAR);
  return index < 0 ? null : reports.aside({ index, cells: distances[index] });
}

/** What is to be said of how far pins end from their partners; null where all hold. `distances` in cells. */
export function pinsOff(distances: readonly number[], strength: number): string | null {
  const far = distances.map((cells, index) => ({ cells, index })).filter(({ cells }) => cells > FAR);
  if (far.length === 0) return null;
  return strength === 0 ? reports.ignored : reports.off(far);
}
