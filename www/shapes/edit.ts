/** What a hand does to a shape: a stroke becomes a loop, a pulled point takes its neighbourhood along. */

import {
  about,
  centroid,
  contains,
  type Loop,
  type Nearest,
  type Point,
  perimeter,
  resampled,
  reversed,
  SAMPLES,
  type Shape,
  shift,
  signedArea,
  smoothed,
  transformed,
} from "./geometry";

/** A stroke shorter than this is a tap and draws nothing. Units: the box's side. */
export const SHORTEST_STROKE = 0.03;

/** Half the length of curve that follows a pulled point, as a part of the loop's perimeter. */
export const PULL_REACH = 0.09;

const SMOOTHING_PASSES = 3;

/** Overshoot is looked for in this first and last part of a stroke. */
const OVERSHOOT_SHARE = 0.25;

/** Closes, smooths and resamples a freehand stroke. Null when it is only a tap. */
export function loopFromStroke(stroke: readonly Point[], passes = SMOOTHING_PASSES): Loop | null {
  let length = 0;
  for (let i = 1; i < stroke.length; i += 1) {
    length += Math.hypot(stroke[i].x - stroke[i - 1].x, stroke[i].y - stroke[i - 1].y);
  }
  if (stroke.length < 3 || length < SHORTEST_STROKE) return null;
  const closed = withoutOvershoot(stroke);
  const flat = Float64Array.from(closed.flatMap((p) => [p.x, p.y]));
  return smoothed(resampled(flat, SAMPLES), passes);
}

/** Cuts the tails where the stroke's end crosses its beginning: people close a curve by drawing past its start. */
function withoutOvershoot(stroke: readonly Point[]): readonly Point[] {
  const share = Math.floor(stroke.length * OVERSHOOT_SHARE);
  for (let i = 0; i < share; i += 1) {
    for (let j = stroke.length - 2; j >= stroke.length - 1 - share && j > i + 1; j -= 1) {
      const cut = crossing(stroke[i], stroke[i + 1], stroke[j], stroke[j + 1]);
      if (cut) return [cut, ...stroke.slice(i + 1, j + 1)];
    }
  }
  return stroke;
}

/** Where the segments a–b and c–d cross; null for parallel or separate ones. */
function crossing(a: Point, b: Point, c: Point, d: Point): Point | null {
  const ux = b.x - a.x;
  const uy = b.y - a.y;
  const vx = d.x - c.x;
  const vy = d.y - c.y;
  const denominator = ux * vy - uy * vx;
  if (denominator === 0) return null;
  const s = ((c.x - a.x) * vy - (c.y - a.y) * vx) / denominator;
  const t = ((c.x - a.x) * uy - (c.y - a.y) * ux) / denominator;
  return s >= 0 && s <= 1 && t >= 0 && t <= 1 ? { x: a.x + s * ux, y: a.y + s * uy } : null;
}

/**
 * The shape with one more loop. A loop that lies inside the shape cuts a hole, any other adds a part: it is turned to
 * run against, or with, what is already there.
 */
export function withLoop(shape: Shape, loop: Loop): Shape {
  let inside = 0;
  for (let i = 0; i < loop.length; i += 2) {
    if (contains(shape, { x: loop[i], y: loop[i + 1] })) inside += 1;
  }
  const hole = inside > 0.9 * (loop.length / 2);
  return [...shape, signedArea(loop) > 0 === hole ? reversed(loop) : loop];
}

/**
 * Moves one vertex by (x, y) and its neighbours along the curve by less and less: weight cos²(π s / 2 r) at arc length
 * s from it, nothing beyond the reach r. `reach` is a part of the perimeter.
 */
export function pulled(shape: Shape, grip: Nearest, x: number, y: number, reach = PULL_REACH): Shape {
  return shape.map((loop, l) => {
    if (l !== grip.loop) return loop;
    const out = loop.slice();
    const n = loop.length / 2;
    const radius = reach * perimeter(loop);
    for (const direction of [1, -1]) {
      let travelled = 0;
      for (let k = direction === 1 ? 0 : 1; k < n && travelled < radius; k += 1) {
        const i = (((grip.vertex + direction * k) % n) + n) % n;
        if (k > 0) {
          const before = (((grip.vertex + direction * (k - 1)) % n) + n) % n;
          travelled += Math.hypot(loop[2 * i] - loop[2 * before], loop[2 * i + 1] - loop[2 * before + 1]);
          if (travelled >= radius) break;
        }
        const weight = Math.cos((Math.PI * travelled) / (2 * radius)) ** 2;
        out[2 * i] = loop[2 * i] + weight * x;
        out[2 * i + 1] = loop[2 * i + 1] + weight * y;
      }
    }
    return out;
  });
}

/** Spaces out again the loops whose points a pull has torn apart; others stay as they are, to the bit. */
export function settled(shape: Shape): Shape {
  return shape.map((loop) => {
    const mean = perimeter(loop) / (loop.length / 2);
    let longest = 0;
    for (let i = 0, j = loop.length - 2; i < loop.length; j = i, i += 2) {
      longest = Math.max(longest, Math.hypot(loop[i] - loop[j], loop[i + 1] - loop[j + 1]));
    }
    return longest > 2.5 * mean ? resampled(loop, SAMPLES) : loop;
  });
}

const STEP = 0.01;
const FINE_STEP = 0.002;

/** What a key does to a shape; null for keys that do nothing to it. `fine` is the Shift key. */
export function keyed(shape: Shape, key: string, fine: boolean): Shape | null {
  const step = fine ? FINE_STEP : STEP;
  switch (key) {
    case "ArrowLeft":
      return transformed(shape, shift(-step, 0));
    case "ArrowRight":
      return transformed(shape, shift(step, 0));
    case "ArrowUp":
      return transformed(shape, shift(0, step));
    case "ArrowDown":
      return transformed(shape, shift(0, -step));
    case "+":
    case "=":
      return transformed(shape, about(centroid(shape), 1 + 2 * STEP, 0));
    case "-":
    case "_":
      return transformed(shape, about(centroid(shape), 1 / (1 + 2 * STEP), 0));
    case "[":
    case "{":
      return transformed(shape, about(centroid(shape), 1, 5 * step));
    case "]":
    case "}":
      return transformed(shape, about(centroid(shape), 1, -5 * step));
    case "Delete":
    case "Backspace":
      return [];
    default:
      return null;
  }
}
