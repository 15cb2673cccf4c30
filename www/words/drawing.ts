/** What the page says of the tools that are fetched when they are first taken up. */

import type { Point } from "../shapes/geometry";
import { page } from "./language";
import { written } from "./numbers";
import { place } from "./place";
import { SIDES, type Side } from "./sides";

export const guides = page("guides", {
  circle: "Press where the middle is to be, and drag outwards.",
  polygon: "Press corner after corner; the first corner again closes the outline.",
  mirror: "Draw one half from the dashed line back to it: the other half is its mirror image.",
  points: "Drag a point, or press a curve where one is to be added.",
  /** While an outline is open. */
  open: (count: number, least: number) =>
    count < least
      ? `${points(count)}: go on with the next.`
      : `${points(count)}: press the first again, or Enter, to close.`,
  rim: "Arrow keys widen the circle, Enter sets it down.",
});

export const actions = page("outline", {
  close: "Close outline",
  back: "Delete last",
  giveUp: "Give up",
  rounding: "Smooth",
  roundness: (percent: number) => (percent === 0 ? "as drawn" : `${percent} %`),
  deleteCurve: "Delete curve",
  deletePoint: "Delete point",
});

/** Spoken; points counted from 0. */
export const told = page("told", {
  walk: (at: Point, index: number | null, count: number, closes: boolean) =>
    index === null
      ? `${place(at)}.`
      : `${place(at)}, at point ${index + 1} of ${count}${closes ? ": Enter closes the outline" : ""}.`,
  set: (index: number, at: Point) => `Point ${index + 1} set: ${place(at)}.`,
  chosen: (index: number, count: number, at: Point, closes: boolean) =>
    `Point ${index + 1} of ${count}: ${place(at)}. Space takes it up, Delete deletes it${closes ? ", Enter closes the outline" : ""}.`,
  takenUp: (index: number) => `Point ${index + 1} taken up: arrow keys move it, Space sets it down.`,
  moved: (index: number, at: Point) => `Point ${index + 1} moved: ${place(at)}.`,
  deleted: (index: number, count: number) =>
    count === 0 ? "The last point is deleted." : `Point ${index + 1} deleted; ${points(count)} left.`,
  tooFew: (count: number, least: number) => `${points(count)} so far: an outline needs ${least}.`,
  added: (index: number) => `Point ${index + 1} added: arrow keys move it, Space sets it down.`,
  noCurve: "There is no curve here: Page Down goes to the next point.",
  keepsThree: "A closed curve keeps three points.",
  putBack: "Put back.",
  givenUp: "The outline is given up.",
  centre: (at: Point) => `Middle set: ${place(at)}. Arrow keys widen the circle, Enter sets it down.`,
  rim: (at: Point, radius: number) => `${place(at)}: radius ${written(String(Number(radius.toFixed(3))))}.`,
  circleGivenUp: "The circle is given up.",
  rounded: (percent: number, side: Side) =>
    percent === 0
      ? `The curve of the ${SIDES[side]} is as it was drawn.`
      : `The curve of the ${SIDES[side]} is smoothed by ${percent} %.`,
  curveDeleted: (side: Side) => `Curve deleted from the ${SIDES[side]}.`,
});

function points(count: number): string {
  return count === 1 ? "1 point" : `${count} points`;
}
