/** What the page says of the tools to draw with. */

import { page } from "./language";
import { SIDES, type Side } from "./sides";

export const words = page("tools", {
  group: "Tool",
  draw: { label: "Draw", help: "Draw, bend and move shapes" },
  circle: { label: "Circle", help: "Drag a circle from its middle" },
  polygon: { label: "Polygon", help: "Press corner after corner; with the keyboard too" },
  mirror: { label: "Mirror", help: "Draw one half, and get a shape that is its own mirror image" },
  points: { label: "Points", help: "Move, add and delete the points of a curve; with the keyboard too" },
  pin: { label: "Pin", help: "Tie a point of the reference to a point of the target" },
  drawFirst: "Draw a closed curve on either side.",
  drawOn: "Draw, pull a curve to bend it, or take its round grip to move it.",
});

const OTHER = { reference: "template", template: "reference" } as const;

/** What the two shapes do to each other. */
export const exchange = page("exchange", {
  name: "Swap or copy the shapes",
  swap: "Swap the shapes",
  copy: (from: Side) => `Copy the ${SIDES[from]} to the ${SIDES[OTHER[from]]}`,
  swapped: (pins: number) =>
    `Swapped: the reference is what the target was${pins > 0 ? ", and the pins lead back" : ""}.`,
  copied: (from: Side, pins: number) =>
    `The ${SIDES[OTHER[from]]} is what the ${SIDES[from]} is.${pins > 0 ? " The pins are deleted." : ""}`,
  pinsDropped: (side: Side, pins: number) =>
    `${pins === 1 ? "The pin is" : `All ${pins} pins are`} deleted, for the ${SIDES[side]} that ${pins === 1 ? "it led" : "they led"} to is gone. Undo brings both back.`,
});
