import { expect, test } from "vitest";
import { arcLengthParts } from "./curve";

const SQUARE = Float64Array.of(0.8, 0.2, 0.8, 0.4, 0.6, 0.4, 0.6, 0.2);

test("arc length runs evenly from the rightmost point", () => {
  expect([...arcLengthParts([SQUARE])[0]]).toEqual([0, 0.25, 0.5, 0.75].map((part) => expect.closeTo(part, 12)));
});

test("a point keeps its part whichever way and from wherever the loop is listed", () => {
  const circle = Array.from({ length: 40 }, (_, i) => [
    0.5 + 0.3 * Math.cos((Math.PI * i) / 20),
    0.5 + 0.2 * Math.sin((Math.PI * i) / 20),
  ]);
  const parts = new Map(circle.map((point, i) => [point, arcLengthParts([Float64Array.from(circle.flat())])[0][i]]));
  const other = [...circle.slice(7), ...circle.slice(0, 7)].reverse();
  const again = arcLengthParts([Float64Array.from(other.flat())])[0];
  other.forEach((point, i) => {
    expect(again[i]).toBeCloseTo(parts.get(point) ?? Number.NaN, 12);
  });
});

test("loops follow one another, longer ones first, and share the whole by length", () => {
  const small = SQUARE.map((value) => value / 3);
  const [a, b] = arcLengthParts([small, SQUARE]);
  expect(b[0]).toBe(0);
  expect(a[0]).toBeCloseTo(0.75, 12);
});

test("loops of equal length keep their colours, whatever a grid makes of their lengths", () => {
  const circle = (x: number, y: number, radius: number, count: number) =>
    Float64Array.from({ length: 2 * count }, (_, k) => {
      const t = (2 * Math.PI * (k >> 1)) / count;
      return k % 2 === 0 ? x + radius * Math.cos(t) : y + radius * Math.sin(t);
    });
  for (const [u, v] of [
    [0.7, 0.5],
    [0.3, 0.8],
  ]) {
    const [first] = arcLengthParts([circle(0.3, 0.5, 0.1, 100), circle(u, v, 0.1, 100)]);
    const [, found] = arcLengthParts([circle(u, v, 0.1005, 64), circle(0.3, 0.5, 0.0995, 64)]);
    expect(found[0]).toBeCloseTo(first[0], 2);
    expect(Math.max(...found)).toBeLessThan(0.51);
  }
});
