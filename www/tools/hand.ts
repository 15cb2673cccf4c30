/** What a tool is to a sketch surface. A hand listens to the pointer itself, and is told of keys. */

import type { Point } from "../shapes/geometry";
import type { Frame } from "../view/canvas";
import type { Theme } from "../view/palette";

export interface Hand {
  /** Whether the key meant something to it. */
  key(event: KeyboardEvent): boolean;
  /** Puts back what an unfinished gesture has changed. */
  cancel(): void;
  dispose(): void;
  /** Draws what it holds, over the shape. */
  paint(context: CanvasRenderingContext2D, frame: Frame, colours: Theme): void;
}

/** The surface under a hand. */
export interface Ground {
  readonly canvas: HTMLCanvasElement;
  /** CSS pixels a domain unit. */
  readonly pixelsPerUnit: number;
  pointFrom(event: { clientX: number; clientY: number }): Point;
  repaint(): void;
}

/** Of what the pointer is to hit, in CSS pixels around it: a finger's target is 44 wide. */
export const TARGET = { mouse: 12, pen: 14, touch: 22 };

export function pointerKind(event: PointerEvent): keyof typeof TARGET {
  return event.pointerType === "touch" || event.pointerType === "pen" ? event.pointerType : "mouse";
}
