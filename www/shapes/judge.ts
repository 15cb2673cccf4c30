/**
 * What a stroke is worth when the hand lets go: a loop, or a sentence that says why it is none, with what can be made of
 * it. Domain units.
 */

import { loopFromStroke, SHORTEST_STROKE } from "./edit";
import {
  about,
  bounds,
  CLEARANCE,
  centroid,
  type Loop,
  type Point,
  perimeter,
  resampled,
  SAMPLES,
  shift,
  signedArea,
  transformed,
} from "./geometry";

/** What the finest grid asks of a shape. */
export type Limits = {
  /** The width of its cells. */
  readonly cell: number;
};

export type Fault = "crossing" | "flat" | "small" | "border";

export type Judgement =
  | { readonly kind: "tap" }
  | { readonly kind: "loop"; readonly loop: Loop }
  /** `mended` is what the way out makes of it; null where there is none. */
  | { readonly kind: Fault; readonly loop: Loop; readonly mended: Loop | null; readonly size: number };

/** A little more than the solver asks for, so that a hair's breadth does not matter. */
const BORDER_CELLS = CLEARANCE + 0.5;
/** Narrower than this, in cells, nothing is seen of a shape; enlarged it becomes so wide. */
const LEAST_CELLS = 4;
const ENLARGED_CELLS = 10;
/** A line there and back encloses less than this, in cells, across. */
const FLAT_CELLS = 0.75;
/** A knot shorter than this part of the curve is the hand's tremor. */
const KNOT_SHARE = 0.04;

export function judged(stroke: readonly Point[], limits: Limits, passes?: number): Judgement {
  const drawn = loopFromStroke(stroke, passes);
  return drawn ? judgedLoop(drawn, limits) : { kind: "tap" };
}

/** The same for a closed curve, however it was made. */
export function judgedLoop(drawn: Loop, { cell }: Limits): Judgement {
  const loop = withoutKnots(drawn, KNOT_SHARE);
  const box = bounds([loop]);
  if (!box || perimeter(loop) < SHORTEST_STROKE) return { kind: "tap" };
  const fault = (kind: Fault, mended: Loop | null, size: number): Judgement => ({ kind, loop, mended, size });
  if (firstCrossing(loop)) {
    const simple = withoutKnots(loop, 1);
    return fault("crossing", isFlat(simple, cell) ? null : simple, 0);
  }
  if (isFlat(loop, cell)) return fault("flat", null, 0);
  const extent = Math.max(box.right - box.left, box.top - box.bottom);
  if (extent < LEAST_CELLS * cell) {
    const [enlarged] = transformed([loop], about(centroid([loop]), (ENLARGED_CELLS * cell) / extent, 0));
    return fault("small", inside(enlarged, BORDER_CELLS * cell), extent / cell);
  }
  const margin = BORDER_CELLS * cell;
  const out = Math.max(margin - box.left, margin - box.bottom, box.right - 1 + margin, box.top - 1 + margin);
  return out > 0 ? fault("border", inside(loop, margin), out / cell) : { kind: "loop", loop };
}

/** Twice the area over the length: the mean width of what is long and thin. */
function isFlat(loop: Loop, cell: number): boolean {
  return (2 * Math.abs(signedArea(loop))) / perimeter(loop) < FLAT_CELLS * cell;
}

/** Moved into the box, and made smaller where it is too large for it. */
function inside(loop: Loop, margin: number): Loop {
  const room = 1 - 2 * margin;
  const box = bounds([loop]);
  if (!box) return loop;
  const extent = Math.max(box.right - box.left, box.top - box.bottom);
  const [fitting] = extent > room ? transformed([loop], about(centroid([loop]), (0.999 * room) / extent, 0)) : [loop];
  const now = bounds([fitting]) ?? box;
  const by = (low: number, high: number) => Math.max(0, margin - low) - Math.max(0, high - 1 + margin);
  return transformed([fitting], shift(by(now.left, now.right), by(now.bottom, now.top)))[0];
}

type Crossing = { readonly i: number; readonly j: number; readonly at: Point };

/** Cuts off, at each crossing, the shorter part of the curve, while that is not longer than `share` of it. */
export function withoutKnots(loop: Loop, share: number): Loop {
  let current = loop;
  for (let cut = 0; cut < MOST_KNOTS; cut += 1) {
    const crossing = firstCrossing(current);
    if (!crossing) break;
    const { i, j, at } = crossing;
    // From the crossing along i + 1 … j back to it, and the rest.
    const knot = Float64Array.of(at.x, at.y, ...current.subarray(2 * i + 2, 2 * j + 2));
    const rest = Float64Array.of(at.x, at.y, ...current.subarray(2 * j + 2), ...current.subarray(0, 2 * i + 2));
    const [short, long] = perimeter(knot) < perimeter(rest) ? [knot, rest] : [rest, knot];
    if (perimeter(short) > share * perimeter(current) || long.length < 6) break;
    current = long;
  }
  return current === loop ? loop : resampled(current, SAMPLES);
}

const MOST_KNOTS = 50;

/** The first two edges, not neighbours, that cross. */
function firstCrossing(loop: Loop): Crossing | null {
  const n = loop.length / 2;
  for (let i = 0; i < n - 2; i += 1) {
    for (let j = i + 2; j < n; j += 1) {
      if (i === 0 && j === n - 1) continue;
      const at = crossing(loop, i, j);
      if (at) return { i, j, at };
    }
  }
  return null;
}

function crossing(loop: Loop, i: number, j: number): Point | null {
  const point = (k: number) => [loop[(2 * k) % loop.length], loop[(2 * k + 1) % loop.length]] as const;
  const [[ax, ay], [bx, by], [cx, cy], [dx, dy]] = [point(i), point(i + 1), point(j), point(j + 1)];
  const [ux, uy, vx, vy] = [bx - ax, by - ay, dx - cx, dy - cy];
  const denominator = ux * vy - uy * vx;
  if (denominator === 0) return null;
  const s = ((cx - ax) * vy - (cy - ay) * vx) / denominator;
  const t = ((cx - ax) * uy - (cy - ay) * ux) / denominator;
  return s >= 0 && s < 1 && t >= 0 && t < 1 ? { x: ax + s * ux, y: ay + s * uy } : null;
}
