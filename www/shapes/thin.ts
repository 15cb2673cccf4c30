/** Fewer points that tell the same of a closed curve, and more along its edges. */

import { type Loop, nearestPart } from "./geometry";

type Span = { readonly from: number; readonly to: number; readonly far: number; readonly off: number };

/** The loop without the points that tell least of it; `tolerance` of the result says how far off these are. */
export function thinned(
  loop: Loop,
  tolerance: number,
  most?: number,
): { readonly points: Loop; readonly tolerance: number } {
  const { telling, off } = tellingPoints(loop, tolerance, most);
  const points = Float64Array.from(telling.flatMap((i) => [loop[2 * i], loop[2 * i + 1]]));
  return { points, tolerance: Math.max(tolerance, off) };
}

/**
 * Douglas–Peucker on the closed loop: takes points, the furthest from the chords so far first, until all others lie
 * within `tolerance` of one, or `most` are taken. `off` says how far the furthest of the others is.
 */
export function tellingPoints(
  loop: Loop,
  tolerance: number,
  most = Number.POSITIVE_INFINITY,
): { readonly telling: readonly number[]; readonly off: number } {
  const n = loop.length / 2;
  if (n <= 4) return { telling: Array.from({ length: n }, (_, i) => i), off: 0 };
  const keep = new Uint8Array(n);
  // Two points that surely stay cut the loop open: one at an extreme, and the one furthest from it.
  let first = 0;
  for (let i = 1; i < n; i += 1) if (loop[2 * i] > loop[2 * first]) first = i;
  let second = first;
  let reach = -1;
  for (let i = 0; i < n; i += 1) {
    const distance = Math.hypot(loop[2 * i] - loop[2 * first], loop[2 * i + 1] - loop[2 * first + 1]);
    if (distance > reach) {
      reach = distance;
      second = i;
    }
  }
  keep[first] = 1;
  keep[second] = 1;
  let kept = 2;
  const middle = second > first ? second : second + n;
  const open = [spanned(loop, first, middle), spanned(loop, middle, first + n)];
  // A closed curve has three points at least, however near they are.
  while (kept < most) {
    let worst = 0;
    for (let k = 1; k < open.length; k += 1) if (open[k].off > open[worst].off) worst = k;
    const { from, to, far, off } = open[worst];
    if (far < 0 || (off <= tolerance && kept >= 3)) break;
    keep[far % n] = 1;
    kept += 1;
    open.splice(worst, 1, spanned(loop, from, far), spanned(loop, far, to));
  }
  const telling = Array.from({ length: n }, (_, i) => i).filter((i) => keep[i]);
  return { telling, off: Math.max(0, ...open.map(({ off }) => off)) };
}

/** The points from one index to another, counted on beyond the end, with the one furthest from the chord. */
function spanned(loop: Loop, from: number, to: number): Span {
  const n = loop.length / 2;
  let far = -1;
  let off = -1;
  for (let k = from + 1; k < to; k += 1) {
    const distance = fromChord(loop, k % n, from % n, to % n);
    if (distance > off) {
      off = distance;
      far = k;
    }
  }
  return { from, to, far, off };
}

function fromChord(loop: Loop, k: number, a: number, b: number): number {
  const [x, y] = [loop[2 * k] - loop[2 * a], loop[2 * k + 1] - loop[2 * a + 1]];
  const [u, v] = [loop[2 * b] - loop[2 * a], loop[2 * b + 1] - loop[2 * a + 1]];
  const t = nearestPart(u, v, x, y);
  return Math.hypot(x - t * u, y - t * v);
}

/** The same polygon with no edge longer than `longest`. */
export function divided(loop: Loop, longest: number): Loop {
  const out: number[] = [];
  const n = loop.length / 2;
  for (let i = 0; i < n; i += 1) {
    const j = (i + 1) % n;
    const [x, y] = [loop[2 * i], loop[2 * i + 1]];
    const [dx, dy] = [loop[2 * j] - x, loop[2 * j + 1] - y];
    const pieces = Math.max(1, Math.ceil(Math.hypot(dx, dy) / longest - 1e-9));
    for (let k = 0; k < pieces; k += 1) out.push(x + (k / pieces) * dx, y + (k / pieces) * dy);
  }
  return Float64Array.from(out);
}
