/** A curve and its knots. */

import { expect, test } from "vitest";
import { type Loop, type Point, signedArea } from "../shapes/geometry";
import { PRESETS } from "../shapes/presets";
import { added, keep, knotsOf, LEAST, loopOf, moved, nearestPlace, removed } from "./knots";
import { polygon } from "./polygon";

const SQUARE: readonly Point[] = [
  { x: 0.2, y: 0.2 },
  { x: 0.8, y: 0.2 },
  { x: 0.8, y: 0.8 },
  { x: 0.2, y: 0.8 },
];

const circle = (() => {
  const out = new Float64Array(400);
  for (let k = 0; k < 200; k += 1) {
    out[2 * k] = 0.5 + 0.3 * Math.cos((2 * Math.PI * k) / 200);
    out[2 * k + 1] = 0.5 + 0.3 * Math.sin((2 * Math.PI * k) / 200);
  }
  return out;
})();

function points(loop: Loop): Point[] {
  return Array.from({ length: loop.length / 2 }, (_, i) => ({ x: loop[2 * i], y: loop[2 * i + 1] }));
}

/** The largest distance of a point of the one to the other. */
function away(one: Loop, other: Loop): number {
  return Math.max(...points(one).map((point) => nearestPlace(knotsOf(other), point).distance));
}

test("the knots of a polygon are its corners", () => {
  const corners = knotsOf(polygon(SQUARE)).map(({ point }) => point);
  expect(corners).toHaveLength(4);
  expect(corners).toEqual(expect.arrayContaining([...SQUARE]));
});

test.each(
  PRESETS.flatMap(({ id, reference, template }) => [...reference, ...template].map((loop) => [id, loop] as const)),
)("the knots of a curve of “%s” are few and make it again, to the bit where none has moved", (_, loop) => {
  const knots = knotsOf(loop);
  expect(knots.length).toBeGreaterThanOrEqual(LEAST);
  expect(knots.length).toBeLessThanOrEqual(60);
  const again = points(loopOf(knots)).map(({ x, y }) => `${x} ${y}`);
  for (const { x, y } of points(loop)) expect(again).toContain(`${x} ${y}`);
  expect(signedArea(loopOf(knots))).toBeCloseTo(signedArea(loop), 12);
});

test("a moved corner takes its straight edges along, and leaves the others", () => {
  const loop = polygon(SQUARE);
  const index = knotsOf(loop).findIndex(({ point }) => point.x === 0.8 && point.y === 0.8);
  const bent = loopOf(moved(knotsOf(loop), index, { x: 0.9, y: 0.95 }));
  const expected = polygon(
    SQUARE.map((corner) => (corner.x === 0.8 && corner.y === 0.8 ? { x: 0.9, y: 0.95 } : corner)),
  );
  expect(away(bent, expected)).toBeLessThan(1e-12);
  expect(away(expected, bent)).toBeLessThan(1e-12);
});

test("what is bent between two knots stays as bent where both move alike", () => {
  const knots = knotsOf(circle);
  const shifted = knots
    .map((_, i) => i)
    .reduce((all, i) => moved(all, i, { x: all[i].point.x + 0.05, y: all[i].point.y }), knots);
  for (const { x, y } of points(loopOf(shifted))) expect(Math.hypot(x - 0.55, y - 0.5)).toBeCloseTo(0.3, 3);
});

test("a knot that is added does not change the curve, and then is one to be moved", () => {
  const place = nearestPlace(knotsOf(circle), { x: 0.5, y: 0.85 });
  expect(place.distance).toBeCloseTo(0.05, 3);
  const more = added(knotsOf(circle), place);
  expect(more).toHaveLength(knotsOf(circle).length + 1);
  expect(more[place.after + 1].point).toEqual(place.point);
  expect(signedArea(loopOf(more))).toBeCloseTo(signedArea(circle), 12);
  const pulled = loopOf(moved(more, place.after + 1, { x: 0.5, y: 0.95 }));
  expect(Math.max(...points(pulled).map(({ y }) => y))).toBeCloseTo(0.95, 12);
  expect(knotsOf(pulled)).toHaveLength(more.length);
});

test("a deleted corner leaves a straight line, and three stay", () => {
  const loop = polygon(SQUARE);
  const triangle = loopOf(removed(knotsOf(loop), 0));
  expect(Math.abs(signedArea(triangle))).toBeCloseTo(0.18, 12);
  expect(knotsOf(triangle)).toHaveLength(3);
  expect(removed(knotsOf(triangle), 1)).toBe(knotsOf(triangle));
});

test("a curve that has moved by its knots has no gaps: no edge is longer than twice the usual", () => {
  const far = loopOf(moved(knotsOf(circle), 0, { x: 0.98, y: 0.5 }));
  const all = points(far);
  const edges = all.map(({ x, y }, i) => Math.hypot(x - all[(i + 1) % all.length].x, y - all[(i + 1) % all.length].y));
  expect(Math.max(...edges)).toBeLessThan(0.03);
});

test("a curve keeps the knots that it was given", () => {
  const loop = polygon(SQUARE);
  const more = added(knotsOf(loop), nearestPlace(knotsOf(loop), { x: 0.5, y: 0.1 }));
  keep(loop, more);
  expect(knotsOf(loop)).toBe(more);
});
