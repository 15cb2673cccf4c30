/** Pins as they are drawn: numbered discs in the colour that the reference has at their place. */

import type { Point } from "../shapes/geometry";
import type { Pin, Shapes } from "../shapes/pins";
import { nearest } from "../view/along";
import { type Frame, pixelX, pixelY } from "../view/canvas";
import { arcLengthParts } from "../view/curve";
import { mapped } from "../view/field";
import { movedAt, wayOf } from "../view/morph";
import { onCycle, type Theme } from "../view/palette";
import type { Match } from "../view/result";
import { chosen } from "./kit";

/** Radius of a pin's disc in CSS pixels. */
export const PIN_RADIUS = 9;

/** One colour a pin: equal colours are points that belong together, for pins as for the curves. */
function pinColours(
  pins: readonly Pin[],
  reference: readonly Float64Array[],
  cycle: readonly string[],
): readonly string[] {
  if (pins.length === 0) return [];
  const parts = arcLengthParts(reference);
  return pins.map(({ reference: { x, y } }) => {
    const near = nearest(reference, x, y);
    return onCycle(cycle, near ? parts[near.loop][near.point] : 0);
  });
}

/** φ(p) of each pin, and how far it is from where the pin is tied. Domain units. */
export function pinEnds(pins: readonly Pin[], { level, deformation }: Pick<Match, "level" | "deformation">) {
  const map = { cells: 2 ** level, deformation };
  return pins.map(({ reference: p, template: q }) => {
    const [x, y] = mapped(map, p.x, p.y);
    return { x, y, off: Math.hypot(x - q.x, y - q.y) };
  });
}

/** Where a match shows its pins at the part `morph` of the way, and where they are tied. */
export type PinMark = { readonly at: Point; readonly aim: Point; readonly colour: string };

export function pinMarks(
  pins: readonly Pin[],
  match: Match | null,
  reference: readonly Float64Array[],
  morph: number,
  cycle: readonly string[],
): PinMark[] {
  const colours = pinColours(pins, reference, cycle);
  const from = pins.flatMap(({ reference: { x, y } }) => [x, y]);
  const to = match && Float64Array.from(pinEnds(pins, match).flatMap(({ x, y }) => [x, y]));
  const at = match && to ? movedAt(wayOf(match), from, to, morph) : from;
  return pins.map(({ template }, i) => ({ at: { x: at[2 * i], y: at[2 * i + 1] }, aim: template, colour: colours[i] }));
}

/** Each disc with a line to where it should be. */
export function drawPinMarks(
  context: CanvasRenderingContext2D,
  frame: Frame,
  colours: Theme,
  marks: readonly PinMark[],
): void {
  for (const { at, aim, colour } of marks) {
    for (const [width, stroke] of [
      [5, colours.paper],
      [2, colour],
    ] as const) {
      context.beginPath();
      context.moveTo(pixelX(frame, at.x), pixelY(frame, at.y));
      context.lineTo(pixelX(frame, aim.x), pixelY(frame, aim.y));
      context.lineWidth = width * frame.ratio;
      context.strokeStyle = stroke;
      context.stroke();
    }
    disc(context, frame, aim, 3, colour);
  }
  marks.forEach(({ at, colour }, i) => {
    drawPin(context, frame, colours, at, i, colour, false);
  });
}

/** One side's ends of the pins. */
export function drawPins(
  context: CanvasRenderingContext2D,
  frame: Frame,
  colours: Theme,
  { pins, reference }: Shapes,
  side: "reference" | "template",
): void {
  const own = pinColours(pins, reference, colours.cycle);
  pins.forEach((pin, i) => {
    drawPin(context, frame, colours, pin[side], i, own[i], chosen.peek() === i);
  });
}

/** `index` counts from 0, its number from 1. A chosen pin has one ring more. */
export function drawPin(
  context: CanvasRenderingContext2D,
  frame: Frame,
  colours: Theme,
  at: Point,
  index: number,
  colour: string,
  isChosen: boolean,
): void {
  if (isChosen) disc(context, frame, at, PIN_RADIUS + 4, colours.ink);
  disc(context, frame, at, PIN_RADIUS + (isChosen ? 2.5 : 1.5), colours.paper);
  disc(context, frame, at, PIN_RADIUS, colour);
  disc(context, frame, at, PIN_RADIUS - 2.5, colours.paper);
  context.fillStyle = colours.ink;
  context.font = `600 ${10 * frame.ratio}px system-ui, sans-serif`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillText(String(index + 1), pixelX(frame, at.x), pixelY(frame, at.y) + 0.5 * frame.ratio);
}

function disc(context: CanvasRenderingContext2D, frame: Frame, { x, y }: Point, radius: number, fill: string): void {
  context.beginPath();
  context.arc(pixelX(frame, x), pixelY(frame, y), radius * frame.ratio, 0, 2 * Math.PI);
  context.fillStyle = fill;
  context.fill();
}
