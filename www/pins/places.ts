/** Where pins go, and with what. Fetched with all that is about pins. */

import { type Loop, type Point, type Shape, type Similarity, similarityTaking, transformed } from "../shapes/geometry";
import type { Pin } from "../shapes/pins";
import { type Nearest, nearest } from "../view/along";

type Side = "reference" | "template";

/** A pin nearer to its curve than this lies on it. Units: the box's side. */
const ON_CURVE = 1e-3;

/** The place of the shape nearest to the point if it is within `reach`, else the point; always in the box. */
export function snapped(shape: Shape, { x, y }: Point, reach: number): Point {
  const near = nearest(shape, x, y);
  return boxed(near && near.distance <= reach ? placeOf(shape, near) : { x, y });
}

function boxed({ x, y }: Point): Point {
  const inside = (value: number) => Math.min(1, Math.max(0, value));
  return { x: inside(x), y: inside(y) };
}

function placeOf(shape: Shape, { loop: l, edge, part }: Nearest): Point {
  const loop = shape[l];
  const [i, j] = [2 * edge, (2 * edge + 2) % loop.length];
  return { x: loop[i] + part * (loop[j] - loop[i]), y: loop[i + 1] + part * (loop[j + 1] - loop[i + 1]) };
}

export function withEnd(pins: readonly Pin[], index: number, side: Side, point: Point): Pin[] {
  return pins.map((pin, i) => (i === index ? { ...pin, [side]: point } : pin));
}

export function without(pins: readonly Pin[], index: number): Pin[] {
  return pins.filter((_, i) => i !== index);
}

/** The pins after one of the shapes has been changed. Its ends go along, and pins of a shape that is gone go with it. */
export function carried(pins: readonly Pin[], side: Side, before: Shape, after: Shape): readonly Pin[] {
  const motion = similarityBetween(before, after);
  if (!motion && !isSameChanged(before, after)) return [];
  return pins.map((pin) => ({ ...pin, [side]: motion ? moved(pin[side], motion) : along(pin[side], before, after) }));
}

/** The pins after the points of a curve have been moved, each for itself: what lies on the curve stays on it. */
export function followed(pins: readonly Pin[], side: Side, before: Shape, after: Shape): readonly Pin[] {
  return pins.map((pin) => {
    const near = nearest(before, pin[side].x, pin[side].y);
    if (!near || near.distance > ON_CURVE) return pin;
    const isSame = before[near.loop].length === after[near.loop]?.length;
    const to = isSame ? boxed(placeOf(after, near)) : snapped(after, pin[side], Number.POSITIVE_INFINITY);
    return { ...pin, [side]: to };
  });
}

function moved({ x, y }: Point, motion: Similarity): Point {
  const [[u, v]] = transformed([Float64Array.of(x, y)], motion);
  return boxed({ x: u, y: v });
}

/** A drawn curve and one drawn anew have no point in common; a pulled one keeps most, and one with a part more keeps all. */
function isSameChanged(before: Shape, after: Shape): boolean {
  return after.some((loop, l) =>
    before.some(
      (other, m) => other === loop || (l === m && other.some((x, i) => i % 2 === 0 && has(loop, i, x, other))),
    ),
  );
}

function has(loop: Loop, i: number, x: number, other: Loop): boolean {
  return loop[i] === x && loop[i + 1] === other[i + 1];
}

/** What lies on the curve stays at its place along it, the rest where it is. */
function along(point: Point, before: Shape, after: Shape): Point {
  const near = nearest(before, point.x, point.y);
  if (!near || near.distance > ON_CURVE) return point;
  const [loop, other] = [after[near.loop], before[near.loop]];
  // A pull leaves the curve's far side as it is, point by point; spaced out anew, the points are others.
  const far = (2 * near.edge + 2 * Math.floor(other.length / 4)) % other.length;
  const isPulled = loop?.length === other.length && has(loop, far, other[far], other);
  return isPulled ? boxed(placeOf(after, near)) : snapped(after, point, Number.POSITIVE_INFINITY);
}

/** Off by more than this, it is none. Units: the box's side. */
const EXACT = 1e-9;

/** The motion, turn and scaling that takes one shape to the other, point by point; null where none does. */
export function similarityBetween(before: Shape, after: Shape): Similarity | null {
  const isAlike = before.length === after.length && before.every((loop, l) => loop.length === after[l].length);
  const [from, to] = [before[0], after[0]];
  if (!isAlike || !from || from.length < 4) return null;
  // From the first point to one half round the loop.
  const far = Math.floor(from.length / 4);
  const motion = similarityTaking([pointOf(from, 0), pointOf(from, far)], [pointOf(to, 0), pointOf(to, far)]);
  if (!motion) return null;
  const moved = transformed(before, motion);
  return moved.every((loop, l) => loop.every((value, i) => Math.abs(value - after[l][i]) < EXACT)) ? motion : null;
}

function pointOf(loop: Loop, index: number): Point {
  return { x: loop[2 * index], y: loop[2 * index + 1] };
}
