/** A place on a surface that the arrow keys move: the pointer of those who draw with the keyboard. */

import type { Point } from "../shapes/geometry";
import { type Frame, pixelX, pixelY } from "../view/canvas";
import type { Theme } from "../view/palette";

const STEP = 0.02;
const FINE_STEP = 0.002;

const WAYS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowDown: [0, -1],
  ArrowUp: [0, 1],
};

/** Where the key takes the cursor; null for other keys. With Shift by a tenth. */
export function stepped(at: Point, event: Pick<KeyboardEvent, "key" | "shiftKey">): Point | null {
  const way = WAYS[event.key];
  if (!way) return null;
  const step = event.shiftKey ? FINE_STEP : STEP;
  const within = (value: number) => Math.round(1000 * Math.min(1, Math.max(0, value))) / 1000;
  return { x: within(at.x + step * way[0]), y: within(at.y + step * way[1]) };
}

/** Cross hairs, seen on any ground. */
export function drawCursor(context: CanvasRenderingContext2D, frame: Frame, colours: Theme, at: Point): void {
  const [x, y, r] = [pixelX(frame, at.x), pixelY(frame, at.y), frame.ratio];
  for (const [width, colour] of [
    [5, colours.paper],
    [2, colours.ink],
  ] as const) {
    context.beginPath();
    for (const [dx, dy] of Object.values(WAYS)) {
      context.moveTo(x + 4 * r * dx, y + 4 * r * dy);
      context.lineTo(x + 15 * r * dx, y + 15 * r * dy);
    }
    context.lineWidth = width * r;
    context.strokeStyle = colour;
    context.stroke();
  }
}
