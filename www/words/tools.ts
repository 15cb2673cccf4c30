/** What the page says of the tools to draw with. */

import { page } from "./language";

export const words = page("tools", {
  group: "Tool",
  draw: { label: "Draw", help: "Draw, bend and move shapes" },
  circle: { label: "Circle", help: "Drag a circle from its middle" },
  polygon: { label: "Polygon", help: "Press corner after corner; with the keyboard too" },
  mirror: { label: "Mirror", help: "Draw one half, and get a shape that is its own mirror image" },
  points: { label: "Points", help: "Move, add and delete the points of a curve; with the keyboard too" },
  pin: { label: "Pin", help: "Tie a point of the reference to a point of the template" },
  drawFirst: "Draw a closed curve on either side.",
  drawOn: "Draw, pull a curve to bend it, or take its round grip to move it.",
});

const OTHER = { reference: "template", template: "reference" } as const;

/** What the two shapes do to each other. */
export const exchange = page("exchange", {
  name: "Swap or copy the shapes",
  swap: "Swap the shapes",
  copy: (from: keyof typeof OTHER) => `Copy the ${from} to the ${OTHER[from]}`,
  swapped: (pins: number) =>
    `Swapped: the reference is what the template was${pins > 0 ? ", and the pins lead back" : ""}.`,
  copied: (from: keyof typeof OTHER, pins: number) =>
    `The ${OTHER[from]} is what the ${from} is.${pins > 0 ? " The pins are deleted." : ""}`,
  pinsDropped: (side: keyof typeof OTHER, pins: number) =>
    `${pins === 1 ? "The pin is" : `All ${pins} pins are`} deleted, for the ${side} that ${pins === 1 ? "it led" : "they led"} to is gone. Undo brings both back.`,
});
