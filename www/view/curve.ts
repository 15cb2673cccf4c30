/** Curves coloured by the reference's arc length: equal colours are matched points. */

import { en } from "../words/en";
import { type Frame, pixelX, pixelY, trace } from "./canvas";
import { onCycle } from "./palette";

/** Colours along a curve: more could not be told apart, and each costs a stroke. */
const PIECES = 128;

/** A closed polyline with, at each point, the part 0…1 of the reference's whole length reached there. */
export type ColouredLoop = { readonly points: Float64Array; readonly parts: Float64Array };

/**
 * Arc length along the closed polylines `reference` as parts 0…1 of the whole length: one array a loop, one value a
 * point. Every loop counts counter-clockwise from its rightmost point; longer loops come first, and of loops as good as
 * equally long those to the left. So a curve keeps its colours whichever way and from wherever its points are listed.
 */
export function arcLengthParts(reference: readonly Float64Array[]): Float64Array[] {
  const lengths = reference.map((loop) => {
    let length = 0;
    for (let i = 0; i < loop.length / 2; i += 1) length += edge(loop, i);
    return length;
  });
  const whole = lengths.reduce((sum, length) => sum + length, 0);
  const parts = reference.map((loop) => new Float64Array(loop.length / 2));
  const order = inOrder(reference, lengths);
  let before = 0;
  for (const l of order) {
    const loop = reference[l];
    const count = parts[l].length;
    let start = 0;
    let twiceArea = 0;
    for (let i = 0; i < count; i += 1) {
      const j = (i + 1) % count;
      twiceArea += loop[2 * i] * loop[2 * j + 1] - loop[2 * j] * loop[2 * i + 1];
      if (loop[2 * i] > loop[2 * start]) start = i;
    }
    let travelled = 0;
    for (let k = 0; k < count; k += 1) {
      const i = twiceArea >= 0 ? (start + k) % count : (start - k + count) % count;
      parts[l][i] = whole > 0 ? (before + travelled) / whole : 0;
      travelled += edge(loop, twiceArea >= 0 ? i : (i - 1 + count) % count);
    }
    before += lengths[l];
  }
  return parts;
}

/** Lines from points of the reference to their partners. */
const TICKS = 36;

/** Where they stand: at each point from which the arc length passes a multiple, whichever way the points are listed. */
export function ticksOf(parts: Float64Array): readonly number[] {
  const points: number[] = [];
  for (let i = 0; i < parts.length; i += 1) {
    const next = parts[(i + 1) % parts.length];
    if (Math.floor(parts[i] * TICKS) !== Math.floor(next * TICKS)) points.push(i);
  }
  return points;
}

/** Lengths that differ by no more than this part are taken for equal: a curve and what a grid makes of it differ so. */
const EQUAL = 0.03;

function inOrder(loops: readonly Float64Array[], lengths: readonly number[]): number[] {
  const left = (l: number) => loops[l].reduce((least, x, i) => (i % 2 === 0 && x < least ? x : least), Infinity);
  const lowest = (l: number) => loops[l].reduce((least, y, i) => (i % 2 === 1 && y < least ? y : least), Infinity);
  const order = loops.map((_, l) => l).sort((a, b) => lengths[b] - lengths[a]);
  const out: number[] = [];
  while (order.length > 0) {
    const equal = order.filter((l) => lengths[l] >= (1 - EQUAL) * lengths[order[0]]);
    // Side by side, or one above the other.
    const beside = (a: number, b: number) => left(a) - left(b);
    equal.sort((a, b) => (Math.abs(beside(a, b)) > EQUAL ? beside(a, b) : lowest(a) - lowest(b)));
    out.push(...equal);
    order.splice(0, equal.length);
  }
  return out;
}

/** Length from point i to the next. */
function edge(loop: Float64Array, i: number): number {
  const j = (i + 1) % (loop.length / 2);
  return Math.hypot(loop[2 * j] - loop[2 * i], loop[2 * j + 1] - loop[2 * i + 1]);
}

/**
 * Strokes the loops in the colours of their points. Width in device pixels; the context's opacity holds for all.
 *
 * Short coloured pieces one after another would show their joints, where two soft edges overlap. So the whole line is
 * drawn once, and its colours are laid into it from wider pieces.
 */
export function strokeColoured(
  context: CanvasRenderingContext2D,
  frame: Frame,
  loops: readonly ColouredLoop[],
  colours: readonly string[],
  width: number,
): void {
  const layer = layerOf(frame);
  // Only the part with the curve on it: clearing and copying all of a large canvas would cost more than the strokes.
  const [left, top, across, down] = extent(frame, loops, width);
  if (across <= 0 || down <= 0) return;
  layer.globalCompositeOperation = "source-over";
  layer.clearRect(left, top, across, down);
  layer.lineJoin = "round";
  layer.lineCap = "round";
  layer.lineWidth = width;
  // It shines through where soft ends of pieces meet, and must not be what another drawing has left.
  layer.strokeStyle = colours[0];
  layer.beginPath();
  for (const loop of loops) trace(layer, frame, loop.points, true);
  layer.stroke();
  layer.globalCompositeOperation = "source-atop";
  layer.lineWidth = width + 2;
  for (const loop of loops) layColours(layer, frame, loop, colours);
  context.drawImage(layer.canvas, left, top, across, down, left, top, across, down);
}

/** Left, top, width and height of what the loops' strokes cover of the canvas, whole device pixels. */
function extent(frame: Frame, loops: readonly ColouredLoop[], stroke: number): [number, number, number, number] {
  let [left, top, right, bottom] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const { points } of loops) {
    for (let i = 0; i < points.length; i += 2) {
      const x = pixelX(frame, points[i]);
      const y = pixelY(frame, points[i + 1]);
      if (x < left) left = x;
      if (x > right) right = x;
      if (y < top) top = y;
      if (y > bottom) bottom = y;
    }
  }
  const around = stroke + 2;
  left = Math.max(0, Math.floor(left - around));
  top = Math.max(0, Math.floor(top - around));
  return [
    left,
    top,
    Math.min(frame.width, Math.ceil(right + around)) - left,
    Math.min(frame.height, Math.ceil(bottom + around)) - top,
  ];
}

function layColours(
  layer: OffscreenCanvasRenderingContext2D,
  frame: Frame,
  loop: ColouredLoop,
  colours: readonly string[],
): void {
  const count = loop.parts.length;
  let colour = "";
  for (let i = 0; i < count; i += 1) {
    const next = onCycle(colours, Math.floor(loop.parts[i] * PIECES) / PIECES);
    if (next !== colour) {
      if (colour) layer.stroke();
      colour = next;
      layer.strokeStyle = colour;
      layer.beginPath();
      layer.moveTo(pixelX(frame, loop.points[2 * i]), pixelY(frame, loop.points[2 * i + 1]));
    }
    const j = (i + 1) % count;
    layer.lineTo(pixelX(frame, loop.points[2 * j]), pixelY(frame, loop.points[2 * j + 1]));
  }
  if (colour) layer.stroke();
}

let scratch: OffscreenCanvasRenderingContext2D | null = null;

/** One layer for all canvases, as large as the largest so far: a new one for each drawing would cost more than it. */
function layerOf({ width, height }: Frame): OffscreenCanvasRenderingContext2D {
  const before = scratch?.canvas ?? { width: 0, height: 0 };
  if (!scratch || before.width < width || before.height < height) {
    const size = [Math.max(width, before.width), Math.max(height, before.height)] as const;
    scratch = new OffscreenCanvas(...size).getContext("2d");
  }
  if (!scratch) throw new Error(en.solver.canvas);
  return scratch;
}
