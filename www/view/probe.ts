/** One point of the reference: what the pointer means, and the mark that shows it. */

import { nearest } from "./along";
import { type Frame, pixelX, pixelY } from "./canvas";
import type { Theme } from "./palette";

/** A place on the reference: kept as such, so that it stays when the match, and with it the points, changes. */
export type Probe = { readonly x: number; readonly y: number };

/**
 * What a pointer at (x, y) means, within `reach`: the nearest point of the reference, or the one whose image among
 * `moved` (the reference's loops, moved) is nearer still. Null for nothing near.
 */
export function probeAt(
  reference: readonly Float64Array[],
  moved: readonly Float64Array[],
  x: number,
  y: number,
  reach: number,
): Probe | null {
  const own = nearest(reference, x, y);
  const image = nearest(moved, x, y);
  const best = own && image && own.distance < image.distance ? own : (image ?? own);
  if (!best || best.distance > reach) return null;
  return pointOf(reference, best.loop, best.point);
}

/** The probe so many points further along its loop; the first point where there is none. */
export function stepped(reference: readonly Float64Array[], probe: Probe | null, steps: number): Probe | null {
  const at = probe && nearest(reference, probe.x, probe.y);
  if (!at) return reference.length > 0 ? pointOf(reference, 0, 0) : null;
  const count = reference[at.loop].length / 2;
  return pointOf(reference, at.loop, (((at.point + steps) % count) + count) % count);
}

function pointOf(reference: readonly Float64Array[], loop: number, point: number): Probe {
  return { x: reference[loop][2 * point], y: reference[loop][2 * point + 1] };
}

/** A disc ringed twice, seen on any ground. */
export function drawMark(
  context: CanvasRenderingContext2D,
  frame: Frame,
  colours: Theme,
  { x, y }: Probe,
  fill: string,
): void {
  for (const [radius, colour] of [
    [8, colours.paper],
    [6.5, colours.ink],
    [4.5, fill],
  ] as const) {
    context.beginPath();
    context.arc(pixelX(frame, x), pixelY(frame, y), radius * frame.ratio, 0, 2 * Math.PI);
    context.fillStyle = colour;
    context.fill();
  }
}
