/**
 * A closed curve by its knots: the few points that tell where it goes, to be moved, added and deleted. What lies between
 * two of them goes along: by the similarity that takes where they were to where they are, so that a straight edge stays
 * straight and a bent one bent.
 */

import {
  type Loop,
  nearestPart,
  type Point,
  perimeter,
  SAMPLES,
  similarityTaking,
  transformed,
} from "../shapes/geometry";
import { divided, tellingPoints } from "../shapes/thin";

export type Knot = {
  readonly point: Point;
  /** The curve from here to the next knot, without the ends, where these were at `from` and `to`. */
  readonly piece: { readonly points: Loop; readonly from: Point; readonly to: Point };
};

export type Knots = readonly Knot[];

/** What is left of the curve lies this close to the polygon of its knots: half a cell of the usual grid. */
const TOLERANCE = 1 / 256;
/** More could not be told apart on a phone. */
const MOST = 60;
/** A closed curve has three at least. */
export const LEAST = 3;

/** Curves that have been made of knots keep theirs. */
const known = new WeakMap<Loop, Knots>();

export function knotsOf(loop: Loop): Knots {
  const found = known.get(loop) ?? told(loop);
  known.set(loop, found);
  return found;
}

/** The same curve with one knot more, or as another choice of them has it. */
export function keep(loop: Loop, knots: Knots): void {
  known.set(loop, knots);
}

export function loopOf(knots: Knots): Loop {
  const bare = Float64Array.from(knots.flatMap(({ point: { x, y } }, i) => [x, y, ...between(knots, i)]));
  const loop = divided(bare, (1.5 * perimeter(bare)) / SAMPLES);
  known.set(loop, knots);
  return loop;
}

export function moved(knots: Knots, index: number, point: Point): Knots {
  return knots.map((knot, i) => (i === index ? { ...knot, point } : knot));
}

/** Its neighbours are joined by a straight line. Three stay in any case. */
export function removed(knots: Knots, index: number): Knots {
  if (knots.length <= LEAST) return knots;
  const before = (index + knots.length - 1) % knots.length;
  const [from, to] = [knots[before].point, next(knots, index).point];
  const straight = { ...knots[before], piece: { points: new Float64Array(0), from, to } };
  return knots.map((knot, i) => (i === before ? straight : knot)).filter((_, i) => i !== index);
}

/** A place on the curve: so many points of the piece after the knot come before it. */
export type Place = {
  readonly after: number;
  readonly passed: number;
  readonly point: Point;
  readonly distance: number;
};

export function nearestPlace(knots: Knots, at: Point): Place {
  let best: Place = { after: 0, passed: 0, point: at, distance: Number.POSITIVE_INFINITY };
  knots.forEach(({ point: from }, after) => {
    const to = next(knots, after).point;
    const way = [from.x, from.y, ...between(knots, after), to.x, to.y];
    for (let k = 0; k + 3 < way.length; k += 2) {
      const [x, y, dx, dy] = [way[k], way[k + 1], way[k + 2] - way[k], way[k + 3] - way[k + 1]];
      const part = nearestPart(dx, dy, at.x - x, at.y - y);
      const point = { x: x + part * dx, y: y + part * dy };
      const distance = Math.hypot(at.x - point.x, at.y - point.y);
      if (distance < best.distance) best = { after, passed: k / 2, point, distance };
    }
  });
  return best;
}

/** A knot more, right after the one that it follows; the curve stays where it is. */
export function added(knots: Knots, { after, passed, point }: Place): Knots {
  const way = Float64Array.from(between(knots, after));
  const [from, to] = [knots[after].point, next(knots, after).point];
  const first = { point: from, piece: { points: way.slice(0, 2 * passed), from, to: point } };
  const second = { point, piece: { points: way.slice(2 * passed), from: point, to } };
  return knots.flatMap((knot, i) => (i === after ? [first, second] : [knot]));
}

function told(loop: Loop): Knots {
  const { telling } = tellingPoints(loop, TOLERANCE, MOST);
  const n = loop.length / 2;
  const point = (i: number) => ({ x: loop[2 * (i % n)], y: loop[2 * (i % n) + 1] });
  return telling.map((index, k) => {
    const last = telling[k + 1] ?? telling[0] + n;
    const points = Array.from({ length: last - index - 1 }, (_, i) => point(index + 1 + i));
    const piece = {
      points: Float64Array.from(points.flatMap(({ x, y }) => [x, y])),
      from: point(index),
      to: point(last),
    };
    return { point: point(index), piece };
  });
}

function next(knots: Knots, index: number): Knot {
  return knots[(index + 1) % knots.length];
}

/** What lies between a knot and the next, where these are now. */
function between(knots: Knots, index: number): Iterable<number> {
  const { point, piece } = knots[index];
  const end = next(knots, index).point;
  if (piece.points.length === 0 || (same(point, piece.from) && same(end, piece.to))) return piece.points;
  const map = similarityTaking([piece.from, piece.to], [point, end]);
  return map ? transformed([piece.points], map)[0] : [];
}

function same(a: Point, b: Point): boolean {
  return a.x === b.x && a.y === b.y;
}
