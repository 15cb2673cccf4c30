import { expect, test } from "vitest";
import { type Shape, signedArea } from "../geometry";
import type { Picture } from "./found";
import { otsu, pictureFrom } from "./ink";
import { traced, zeroSet } from "./trace";

const SIDE = 120;

/** An opaque picture, `light` from 0 to 255 at each pixel; y downwards. */
function picture(
  light: (x: number, y: number) => number,
  alpha: (x: number, y: number) => number = () => 255,
): Picture {
  const rgba = new Uint8ClampedArray(4 * SIDE * SIDE);
  for (let y = 0; y < SIDE; y += 1) {
    for (let x = 0; x < SIDE; x += 1) {
      const value = light(x, y);
      rgba.set([value, value, value, alpha(x, y)], 4 * (y * SIDE + x));
    }
  }
  return pictureFrom(rgba, SIDE, SIDE);
}

function outline(source: Picture, flipped = source.borderIsInk): Shape {
  return traced(source, source.threshold, flipped).loops;
}

function area(shape: Shape): number {
  return shape.reduce((sum, loop) => sum + signedArea(loop), 0);
}

const disc = (x: number, y: number, r: number) => (px: number, py: number) => Math.hypot(px - x, py - y) < r;

test("a disc is found where it is, to a tenth of a pixel, though its pixels are black or white", () => {
  const inside = disc(50, 40, 30);
  const [loop, ...others] = outline(picture((x, y) => (inside(x, y) ? 0 : 255)));
  expect(others).toEqual([]);
  let mean = 0;
  for (let i = 0; i < loop.length; i += 2) {
    // Row 40 from above is row 120 − 40 of the frame that runs upwards from 1.
    const r = Math.hypot(loop[i] - 51, loop[i + 1] - (SIDE - 40));
    expect(Math.abs(r - 30)).toBeLessThan(0.6);
    mean += r / (loop.length / 2);
  }
  expect(mean).toBeCloseTo(30, 0);
  expect(Math.abs(signedArea(loop) / (Math.PI * 30 ** 2) - 1)).toBeLessThan(0.01);
});

test("light on dark is turned round by itself", () => {
  const inside = disc(60, 60, 30);
  const source = picture((x, y) => (inside(x, y) ? 240 : 20));
  expect(source.borderIsInk).toBe(true);
  expect(area(outline(source)) / (Math.PI * 900)).toBeCloseTo(1, 1);
});

test("a ring has a body and a hole", () => {
  const [outer, inner] = [disc(60, 60, 40), disc(60, 60, 20)];
  const shape = outline(picture((x, y) => (outer(x, y) && !inner(x, y) ? 30 : 220)));
  expect(shape.map((loop) => Math.sign(signedArea(loop))).sort()).toEqual([-1, 1]);
  expect(area(shape) / (Math.PI * 1200)).toBeCloseTo(1, 1);
});

test("where a picture is transparent, its alpha counts and not its colour", () => {
  const inside = disc(60, 60, 25);
  const source = picture(
    () => 255,
    (x, y) => (inside(x, y) ? 255 : 0),
  );
  expect(area(outline(source)) / (Math.PI * 625)).toBeCloseTo(1, 1);
});

test("what reaches the edge is closed there and said to be cut", () => {
  const result = traced(
    picture((x) => (x < 40 ? 0 : 255)),
    128,
    false,
  );
  expect(result.cut).toBe(true);
  expect(area(result.loops) / (40 * SIDE)).toBeCloseTo(1, 1);
});

test("single pixels are noise", () => {
  const inside = disc(60, 60, 25);
  const source = picture((x, y) => (inside(x, y) || (x % 30 === 3 && y % 30 === 3) ? 0 : 255));
  expect(outline(source)).toHaveLength(1);
});

test("a picture of one colour is refused", () => {
  expect(() => picture(() => 130)).toThrow(/nearly uniform/);
});

test("Otsu's threshold separates two heaps, and sits in the middle of an empty gap", () => {
  const values = Uint8Array.from({ length: 1000 }, (_, i) => (i % 3 === 0 ? 200 : 40));
  expect(otsu(values)).toBeCloseTo(120, 0);
  const spread = Uint8Array.from({ length: 1000 }, (_, i) => (i % 2 === 0 ? 30 + (i % 40) : 180 + (i % 40)));
  expect(otsu(spread)).toBeGreaterThan(69);
  expect(otsu(spread)).toBeLessThan(181);
});

test("marching squares closes every loop, also through saddles", () => {
  const columns = 40;
  const level = new Float32Array(columns * columns).fill(-1);
  // A pseudo-random chequered field: saddles everywhere.
  let state = 7;
  for (let y = 1; y < columns - 1; y += 1) {
    for (let x = 1; x < columns - 1; x += 1) {
      state = (1103515245 * state + 12345) % 2 ** 31;
      level[y * columns + x] = state / 2 ** 30 - 1 || -1e-3;
    }
  }
  const loops = zeroSet(level, columns, columns);
  for (const loop of loops) {
    for (let i = 0, j = loop.length - 2; i < loop.length; j = i, i += 2) {
      expect(Math.hypot(loop[i] - loop[j], loop[i + 1] - loop[j + 1])).toBeLessThan(Math.SQRT2 + 1e-6);
    }
  }
  const crossed = level.reduce((sum, value, node) => {
    const right = node % columns < columns - 1 && value > 0 !== level[node + 1] > 0;
    const above = node + columns < level.length && value > 0 !== level[node + columns] > 0;
    return sum + Number(right) + Number(above);
  }, 0);
  expect(loops.reduce((sum, loop) => sum + loop.length / 2, 0)).toBe(crossed);
});
