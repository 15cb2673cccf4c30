import { expect, test } from "vitest";
import { perimeter, signedArea } from "../shapes/geometry";
import { PRESETS } from "../shapes/presets";
import { whole } from "./mirror";
import { polygon } from "./polygon";
import { rounded } from "./rounding";

const STAR = (PRESETS.find(({ id }) => id === "star") ?? PRESETS[0]).reference[0];

function ellipse(a: number, b: number): Float64Array {
  return polygon(
    Array.from({ length: 400 }, (_, k) => ({
      x: 0.5 + a * Math.cos((Math.PI * k) / 200),
      y: 0.5 + b * Math.sin((Math.PI * k) / 200),
    })),
  );
}

/** 4π area over length²: 1 for a circle, less for all else. */
function roundness(loop: Float64Array): number {
  return (4 * Math.PI * Math.abs(signedArea(loop))) / perimeter(loop) ** 2;
}

test("smoothing makes a star rounder and rounder, and a circle of it at last", () => {
  const series = [0, 0.25, 0.5, 0.75, 1].map((part) => roundness(rounded(STAR, part)));
  for (let k = 1; k < series.length; k += 1) expect(series[k]).toBeGreaterThan(series[k - 1]);
  expect(series[4]).toBeGreaterThan(0.98);
});

test("smoothing by nothing gives the same curve, to the bit", () => {
  expect(rounded(STAR, 0)).toBe(STAR);
});

test("a circle stays as it is, however much it is smoothed", () => {
  const circle = ellipse(0.3, 0.3);
  expect(signedArea(rounded(circle, 1)) / signedArea(circle)).toBeCloseTo(1, 3);
});

test("the smoothed curve runs the same way round, about the same middle", () => {
  const turned = STAR.slice();
  for (let i = 0; i < STAR.length; i += 2) turned.set([STAR[STAR.length - 2 - i], STAR[STAR.length - 1 - i]], i);
  expect(Math.sign(signedArea(rounded(STAR, 0.6)))).toBe(Math.sign(signedArea(STAR)));
  expect(Math.sign(signedArea(rounded(turned, 0.6)))).toBe(-Math.sign(signedArea(STAR)));
});

test("a polygon keeps every corner and has points along its edges", () => {
  const corners = [
    { x: 0.2, y: 0.2 },
    { x: 0.8, y: 0.2 },
    { x: 0.8, y: 0.21 },
    { x: 0.2, y: 0.7 },
  ];
  const loop = polygon(corners);
  for (const { x, y } of corners) {
    expect(Array.from({ length: loop.length / 2 }, (_, i) => [loop[2 * i], loop[2 * i + 1]])).toContainEqual([x, y]);
  }
  expect(loop.length / 2).toBeGreaterThan(190);
  expect(perimeter(loop)).toBeCloseTo(0.6 + 0.01 + Math.hypot(0.6, 0.49) + 0.5, 10);
});

test("a mirrored half is its own image, its ends cut off where they cross the axis", () => {
  const half = [
    { x: 0.45, y: 0.9 },
    { x: 0.55, y: 0.8 },
    { x: 0.7, y: 0.5 },
    { x: 0.55, y: 0.2 },
    { x: 0.45, y: 0.1 },
  ];
  const all = whole(half);
  expect(all.map(({ x, y }) => [x, y])).toEqual(
    [
      [0.5, 0.85],
      [0.55, 0.8],
      [0.7, 0.5],
      [0.55, 0.2],
      [0.5, 0.15],
      [0.45, 0.2],
      [0.3, 0.5],
      [0.45, 0.8],
    ].map((point) => point.map((value) => expect.closeTo(value, 12))),
  );
});

test("a half that stays beside the axis is joined to its image by straight lines", () => {
  const all = whole([
    { x: 0.2, y: 0.8 },
    { x: 0.3, y: 0.2 },
  ]);
  expect(all.map(({ x, y }) => [x, y])).toEqual([
    [0.2, 0.8],
    [0.3, 0.2],
    [0.7, 0.2],
    [0.8, 0.8],
  ]);
});
