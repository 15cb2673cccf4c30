/** The result view as a picture, drawn anew at a resolution for print. */

import type { Frame } from "../view/canvas";
import type { Square } from "../view/framing";
import type { Theme } from "../view/palette";
import type { ResultScene } from "../view/result";
import { files } from "../words/files";
import { ACROSS, drawLegend, EDGE, type Legend } from "./legend";

/** Draws a scene in the view that is chosen. */
export type Draw = (context: CanvasRenderingContext2D, frame: Frame, colours: Theme, scene: ResultScene) => void;

/** Pixels a side: 20 cm at 300 dots per inch. */
const PRINT_SIDE = 2400;

/** Lines keep the proportion to the picture that they have in a view of this many CSS pixels. */
const VIEW_SIDE = 520;

export async function png(
  scene: ResultScene,
  square: Square,
  colours: Theme,
  draw: Draw,
  legend: Legend | null,
): Promise<Blob> {
  const canvas = document.createElement("canvas");
  canvas.width = PRINT_SIDE;
  canvas.height = PRINT_SIDE;
  const context = paint(canvas, square, scene, colours, draw);
  const unit = PRINT_SIDE / ACROSS;
  if (legend) drawLegend(context, legend, colours, unit, EDGE * unit, EDGE * unit);
  const blob = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, "image/png"));
  if (!blob) throw new Error(files.noPicture);
  return blob;
}

/** Draws what the square holds of the scene on the theme's paper, filling the canvas. */
export function paint(
  canvas: HTMLCanvasElement,
  square: Square,
  scene: ResultScene,
  colours: Theme,
  draw: Draw,
): CanvasRenderingContext2D {
  const context = canvas.getContext("2d", { willReadFrequently: true });
  if (!context) throw new Error(files.noCanvas);
  const { width, height } = canvas;
  const frame: Frame = {
    left: square.left,
    bottom: square.bottom,
    scale: Math.min(width, height) / square.size,
    width,
    height,
    ratio: width / VIEW_SIDE,
  };
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.globalAlpha = 1;
  context.fillStyle = colours.paper;
  context.fillRect(0, 0, width, height);
  draw(context, frame, colours, scene);
  return context;
}
