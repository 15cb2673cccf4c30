/** Draws a sketch surface: the shape, where it is too close to the border, and the place that is pointed at. */

import { type Frame, trace } from "./canvas";
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
