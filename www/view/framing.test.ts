import { expect, test } from "vitest";
import { framing } from "./framing";

function square(left: number, bottom: number, side: number): Float64Array {
  return Float64Array.of(left, bottom, left + side, bottom, left + side, bottom + side, left, bottom + side);
}

test("without shapes the whole box is shown, with what the plane leaves it by", () => {
  expect(framing([])).toEqual({ left: -0.05, bottom: -0.05, size: 1.1 });
});

test("small shapes are shown large, in the middle", () => {
  const { left, bottom, size } = framing([square(0.4, 0.4, 0.1), square(0.5, 0.5, 0.1)]);
  expect(size).toBeCloseTo(0.3, 10);
  expect([left + size / 2, bottom + size / 2]).toEqual([expect.closeTo(0.5, 10), expect.closeTo(0.5, 10)]);
});

test.each([[square(0.05, 0.05, 0.9)], [square(0, 0, 0.3)], [square(0.7, 0.1, 0.3)]])(
  "whatever the shape, it is in the picture, and nothing far beyond the box is",
  (shape) => {
    const { left, bottom, size } = framing([shape]);
    for (const low of [left, bottom]) expect(low).toBeGreaterThanOrEqual(-0.05 - 1e-12);
    for (const high of [left + size, bottom + size]) expect(high).toBeLessThanOrEqual(1.05 + 1e-12);
    shape.forEach((value, i) => {
      const low = i % 2 === 0 ? left : bottom;
      expect(value).toBeGreaterThan(low);
      expect(value).toBeLessThan(low + size);
    });
  },
);

test("the picture stays where it is while the shapes fit into it, and follows when they leave it or shrink", () => {
  const first = framing([square(0.3, 0.3, 0.4)]);
  expect(framing([square(0.33, 0.3, 0.4)], first)).toBe(first);
  expect(framing([square(0.5, 0.3, 0.4)], first)).not.toBe(first);
  expect(framing([square(0.4, 0.4, 0.1)], first).size).toBeLessThan(first.size);
});

test("what comes to an empty picture is framed as if it had always been there", () => {
  const shape = [square(0.2, 0.3, 0.6)];
  expect(framing(shape, framing([]))).toEqual(framing(shape));
});

test("with a legend there is more room below the shapes than above", () => {
  const { bottom, size } = framing([square(0.2, 0.2, 0.6)], null, { legend: true });
  expect((0.2 - bottom) / size).toBeGreaterThan(0.2);
  expect(bottom + size).toBeGreaterThan(0.8 + 0.1);
});
