import { expect, test } from "vitest";
import { curvature, curvatures, nearest, signedDistance, stretch } from "./along";

function circle(radius: number, count: number, uneven = 0): Float64Array {
  return Float64Array.from({ length: 2 * count }, (_, k) => {
    const i = k >> 1;
    const t = (2 * Math.PI * (i + uneven * Math.sin(2.7 * i))) / count;
    return 0.5 + radius * (k % 2 === 0 ? Math.cos(t) : Math.sin(t));
  });
}

const SQUARE = Float64Array.of(0, 0, 1, 0, 1, 1, 0, 1);

test("the curvature of a circle is one over its radius, however its points lie", () => {
  const loop = circle(0.2, 150, 0.3);
  for (const value of curvatures(loop, 0.03)) expect(Math.abs(value * 0.2 - 1)).toBeLessThan(0.02);
});

test("the error of the curvature falls with the square of the reach", () => {
  const loop = circle(0.25, 2000);
  const error = (reach: number) => Math.abs(4 - curvature(loop, 7, reach));
  expect(error(0.1) / error(0.05)).toBeGreaterThan(3.5);
});

test("a loop listed the other way has the same curvature", () => {
  const loop = circle(0.3, 80);
  const back = Float64Array.from({ length: 160 }, (_, k) => loop[k % 2 === 0 ? 158 - k : 160 - k]);
  expect(curvatures(back, 0.05)[5]).toBeCloseTo(curvatures(loop, 0.05)[5], 8);
});

test("a doubling stretches by two", () => {
  const loop = circle(0.1, 50);
  const moved = loop.map((value) => 2 * value);
  for (let i = 0; i < 50; i += 1) expect(stretch(loop, moved, i)).toBeCloseTo(2, 12);
});

test("distances are to edges, negative inside", () => {
  expect(signedDistance([SQUARE], 0.5, 0.25)).toBeCloseTo(-0.25);
  expect(signedDistance([SQUARE], 2, 2)).toBeCloseTo(Math.SQRT2);
  const hole = SQUARE.map((value) => 0.25 + value / 2);
  expect(signedDistance([SQUARE, hole], 0.5, 0.5)).toBeCloseTo(0.25);
});

test("the nearest place is the nearer end of the nearest edge", () => {
  expect(nearest([SQUARE], 0.9, 0.4)).toEqual({
    loop: 0,
    point: 1,
    edge: 1,
    part: 0.4,
    distance: expect.closeTo(0.1, 12),
  });
  expect(nearest([SQUARE], 0.1, 0.9)?.point).toBe(3);
  expect(nearest([], 0, 0)).toBeNull();
});
