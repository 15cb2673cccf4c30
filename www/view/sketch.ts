/** Draws a sketch surface: the shape, what can be gripped, the stroke under way. */

import { type Frame, pixelX, pixelY, trace } from "./canvas";
import { type ColouredLoop, strokeColoured } from "./curve";
import type { Theme } from "./palette";
import { drawMark } from "./probe";

type Point = { readonly x: number; readonly y: number };

export type SketchScene = {
  readonly side: "reference" | "template";
  readonly shape: readonly Float64Array[];
  /** The shape coloured by correspondence, when a match of exactly this shape is known. */
  readonly coloured: readonly ColouredLoop[] | null;
  /** The distance from the border that the shape should keep and does not; null when all is well. */
  readonly tooClose: number | null;
  /** The point whose partner is shown, or that partner. */
  readonly mark: Point | null;
};

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

export function drawSketch(context: CanvasRenderingContext2D, frame: Frame, colours: Theme, scene: SketchScene): void {
  const { ratio } = frame;
  const own = scene.side === "reference" ? colours.reference : colours.template;
  if (scene.tooClose !== null) drawLimit(context, frame, colours, scene.tooClose);

  context.beginPath();
  for (const loop of scene.shape) trace(context, frame, loop, true);
  context.fillStyle = own;
  context.globalAlpha = 0.13;
  context.fill("nonzero");
  context.globalAlpha = 1;
  if (scene.coloured) {
    strokeColoured(context, frame, scene.coloured, colours.cycle, 3 * ratio);
  } else {
    context.strokeStyle = own;
    context.lineWidth = 2.25 * ratio;
    context.lineJoin = "round";
    context.stroke();
  }
  if (scene.mark) drawMark(context, frame, colours, scene.mark, own);
}

export function drawPen(
  context: CanvasRenderingContext2D,
  frame: Frame,
  colours: Theme,
  side: SketchScene["side"],
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

/** The line that the shape has crossed. */
function drawLimit(context: CanvasRenderingContext2D, frame: Frame, colours: Theme, width: number): void {
  context.beginPath();
  trace(context, frame, [width, width, 1 - width, width, 1 - width, 1 - width, width, 1 - width], true);
  context.strokeStyle = colours.warning;
  context.lineWidth = 1.5 * frame.ratio;
  context.setLineDash([4 * frame.ratio, 4 * frame.ratio]);
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
