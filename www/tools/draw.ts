import { type Frame, trace } from "../view/canvas";
import type { Theme } from "../view/palette";

/** A halo around the curve that is smoothed or deleted. */
export function drawChosen(
  context: CanvasRenderingContext2D,
  frame: Frame,
  colours: Theme,
  side: "reference" | "template",
  loop: Float64Array,
): void {
  context.beginPath();
  trace(context, frame, loop, true);
  context.strokeStyle = side === "reference" ? colours.reference : colours.template;
  context.lineWidth = 10 * frame.ratio;
  context.lineJoin = "round";
  context.globalAlpha = 0.22;
  context.stroke();
  context.globalAlpha = 1;
}
