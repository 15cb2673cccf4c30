/** A canvas that shows a square of the plane: device pixels, one redraw a frame, redrawn when size or colours change. */

import { en } from "../words/en";
import type { Square } from "./framing";
import { type Theme, theme } from "./palette";

/** Domain units to device pixels, y up. */
export type Frame = {
  readonly left: number;
  readonly bottom: number;
  /** Device pixels a domain unit. */
  readonly scale: number;
  /** Height of the canvas in device pixels. */
  readonly height: number;
  readonly width: number;
  /** Device pixels a CSS pixel: the unit of line widths. */
  readonly ratio: number;
};

export type Draw = (context: CanvasRenderingContext2D, frame: Frame, colours: Theme) => void;

export class Surface {
  readonly canvas: HTMLCanvasElement;
  private readonly context: CanvasRenderingContext2D;
  private readonly draw: Draw;
  private readonly seen: () => Square;
  private readonly observer: ResizeObserver;
  private readonly listening = new AbortController();
  private pending = 0;
  private colours: Theme;

  /** Shows `seen` and calls `draw` on a cleared canvas. */
  constructor(canvas: HTMLCanvasElement, seen: () => Square, draw: Draw) {
    const context = canvas.getContext("2d");
    if (!context) throw new Error(en.solver.canvas);
    this.canvas = canvas;
    this.colours = theme(canvas);
    this.context = context;
    this.seen = seen;
    this.draw = draw;
    this.observer = new ResizeObserver((entries) => this.resize(entries[entries.length - 1]));
    this.observer.observe(canvas);
    matchMedia("(prefers-color-scheme: dark)").addEventListener(
      "change",
      () => {
        this.colours = theme(canvas);
        this.invalidate();
      },
      { signal: this.listening.signal },
    );
  }

  get frame(): Frame {
    const { width, height } = this.canvas;
    const { left, bottom, size } = this.seen();
    return { left, bottom, scale: Math.min(width, height) / size, width, height, ratio: devicePixelRatio };
  }

  /** Redraws before the browser's next frame; any number of calls until then cost one drawing. */
  invalidate(): void {
    if (this.pending) return;
    this.pending = requestAnimationFrame(() => {
      this.pending = 0;
      this.render();
    });
  }

  /** The domain point under a pointer event. */
  pointFrom(event: { clientX: number; clientY: number }): { x: number; y: number } {
    const box = this.canvas.getBoundingClientRect();
    const { left, bottom, size } = this.seen();
    const unit = Math.min(box.width, box.height) / size;
    return { x: left + (event.clientX - box.left) / unit, y: bottom + (box.bottom - event.clientY) / unit };
  }

  /** CSS pixels a domain unit. */
  get pixelsPerUnit(): number {
    const box = this.canvas.getBoundingClientRect();
    return Math.min(box.width, box.height) / this.seen().size;
  }

  dispose(): void {
    cancelAnimationFrame(this.pending);
    this.observer.disconnect();
    this.listening.abort();
  }

  private resize(entry: ResizeObserverEntry): void {
    const { width: cssWidth, height: cssHeight } = entry.contentRect;
    // The exact size knows how the browser rounds; Safari has none, and emulated screens report another screen's.
    const exact = entry.devicePixelContentBoxSize?.[0];
    const width = near(exact?.inlineSize, cssWidth * devicePixelRatio);
    const height = near(exact?.blockSize, cssHeight * devicePixelRatio);
    if (width === this.canvas.width && height === this.canvas.height) return;
    this.canvas.width = width;
    this.canvas.height = height;
    // Setting the size clears the canvas: draw at once, or it would flash empty.
    this.render();
  }

  private render(): void {
    if (this.canvas.width === 0) return;
    this.context.setTransform(1, 0, 0, 1, 0, 0);
    this.context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    this.draw(this.context, this.frame, this.colours);
  }
}

export function pixelX(frame: Frame, x: number): number {
  return (x - frame.left) * frame.scale;
}

export function pixelY(frame: Frame, y: number): number {
  return frame.height - (y - frame.bottom) * frame.scale;
}

/** Adds a polyline of interleaved points to the current path. */
export function trace(context: CanvasPath, frame: Frame, points: ArrayLike<number>, close: boolean): void {
  for (let i = 0; i + 1 < points.length; i += 2) {
    const x = pixelX(frame, points[i]);
    const y = pixelY(frame, points[i + 1]);
    if (i === 0) context.moveTo(x, y);
    else context.lineTo(x, y);
  }
  if (close && points.length > 0) context.closePath();
}

function near(exact: number | undefined, product: number): number {
  return exact !== undefined && Math.abs(exact - product) <= 1 ? exact : Math.round(product);
}
