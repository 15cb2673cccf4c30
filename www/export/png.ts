/** The result view as a picture, drawn anew at a resolution for print. */

import type { Frame } from "../view/canvas";
import type { Theme } from "../view/palette";
import type { ResultScene } from "../view/result";
import { files } from "../words/files";
import { drawLegend, type Legend } from "./legend";

/** Draws a scene in the view that is chosen. */
export type Draw = (context: CanvasRenderingContext2D, frame: Frame, colours: Theme, scene: ResultScene) => void;

/** Pixels a side: 20 cm at 300 dots per inch. */
const PRINT_SIDE = 2400;

/** Lines keep the proportion to the picture that they have in a view of this many CSS pixels. */
const VIEW_SIDE = 520;

/** φ leaves the box a little; this much around it is in the picture. */
export const MARGIN = 0.05;

export async function png(scene: ResultScene, colours: Theme, draw: Draw, legend: Legend | null): Promise<Blob> {
  const canvas = document.createElement("canvas");
  canvas.width = PRINT_SIDE;
  canvas.height = PRINT_SIDE;
  const context = paint(canvas, scene, colours, draw);
  const unit = PRINT_SIDE / (1 + 2 * MARGIN) / 1000;
  if (legend) drawLegend(context, legend, colours, unit, 1000 * MARGIN * unit, 1000 * MARGIN * unit);
  const blob = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, "image/png"));
  if (!blob) throw new Error(files.noPicture);
  return blob;
}

/** Draws the scene on the theme's paper, filling the canvas. */
export function paint(
  canvas: HTMLCanvasElement,
  scene: ResultScene,
  colours: Theme,
  draw: Draw,
): CanvasRenderingContext2D {
  const context = canvas.getContext("2d", { willReadFrequently: true });
  if (!context) throw new Error(files.noCanvas);
  const { width, height } = canvas;
  const frame: Frame = {
    left: -MARGIN,
    bottom: -MARGIN,
    scale: Math.min(width, height) / (1 + 2 * MARGIN),
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
