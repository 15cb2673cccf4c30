/** Draws what the hand does with a shape: the stroke under way, the grip, the point that is pulled. */

import { type Frame, pixelX, pixelY, trace } from "./canvas";
import type { Theme } from "./palette";

type Point = { readonly x: number; readonly y: number };

export type Pen = {
  /** The stroke being drawn, open. */
  readonly stroke: readonly Point[];
  /** Where the shape can be taken to move it; null hides the grip. */
  readonly grip: Point | null;
  /** The point of the curve that a press would pull. */
  readonly pull: Point | null;
};

/** Radius of the grip in CSS pixels; the pointer's reach is at least this. */
export const GRIP_RADIUS = 11;

export function drawPen(
  context: CanvasRenderingContext2D,
  frame: Frame,
  colours: Theme,
  side: "reference" | "template",
  pen: Pen,
): void {
  const { ratio } = frame;
  const own = side === "reference" ? colours.reference : colours.template;
  if (pen.stroke.length > 1) {
    context.beginPath();
    trace(
      context,
      frame,
      pen.stroke.flatMap((p) => [p.x, p.y]),
      false,
    );
    context.strokeStyle = own;
    context.lineWidth = 2.5 * ratio;
    context.lineCap = "round";
    context.lineJoin = "round";
    context.stroke();
    // The closing line that lifting the pen would add.
    const first = pen.stroke[0];
    const last = pen.stroke[pen.stroke.length - 1];
    context.beginPath();
    trace(context, frame, [last.x, last.y, first.x, first.y], false);
    context.setLineDash([2 * ratio, 5 * ratio]);
    context.lineWidth = 1.5 * ratio;
    context.stroke();
    context.setLineDash([]);
  }
  if (pen.grip) drawGrip(context, frame, colours, pen.grip);
  if (pen.pull) {
    context.beginPath();
    context.arc(pixelX(frame, pen.pull.x), pixelY(frame, pen.pull.y), 5.5 * ratio, 0, 2 * Math.PI);
    context.fillStyle = colours.paper;
    context.fill();
    context.strokeStyle = colours.ink;
    context.lineWidth = 2 * ratio;
    context.stroke();
  }
}

/** A stroke that is no shape yet. */
export function drawFaulty(context: CanvasRenderingContext2D, frame: Frame, colours: Theme, loop: Float64Array): void {
  context.beginPath();
  trace(context, frame, loop, true);
  context.strokeStyle = colours.warning;
  context.lineWidth = 2.5 * frame.ratio;
  context.setLineDash([7 * frame.ratio, 5 * frame.ratio]);
  context.stroke();
  context.setLineDash([]);
}

/** A disc with four arrow heads. */
function drawGrip(context: CanvasRenderingContext2D, frame: Frame, colours: Theme, at: Point): void {
  const { ratio } = frame;
  const x = pixelX(frame, at.x);
  const y = pixelY(frame, at.y);
  context.beginPath();
  context.arc(x, y, GRIP_RADIUS * ratio, 0, 2 * Math.PI);
  context.fillStyle = colours.paper;
  context.fill();
  context.strokeStyle = colours.frame;
  context.lineWidth = ratio;
  context.stroke();
  context.strokeStyle = colours.muted;
  context.lineWidth = 1.5 * ratio;
  context.lineCap = "round";
  context.beginPath();
  for (const [dx, dy] of [
    [1, 0],
    [-1, 0],
    [0, 1],
    [0, -1],
  ]) {
    const tip = 6.5 * ratio;
    const back = 4.3 * ratio;
    const side = 2.2 * ratio;
    context.moveTo(x, y);
    context.lineTo(x + tip * dx, y + tip * dy);
    context.moveTo(x + back * dx + side * dy, y + back * dy + side * dx);
    context.lineTo(x + tip * dx, y + tip * dy);
    context.lineTo(x + back * dx - side * dy, y + back * dy - side * dx);
  }
  context.stroke();
}
