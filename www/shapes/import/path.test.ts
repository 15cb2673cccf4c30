import { expect, test } from "vitest";
import { perimeter, signedArea } from "../geometry";
import { controlBounds, flattened, parsePath } from "./path";
import { IDENTITY, type Matrix } from "./transform";

function loop(data: string, tolerance = 1e-5, matrix: Matrix = IDENTITY) {
  const [only, ...others] = flattened(parsePath(data), matrix, tolerance);
  expect(others).toEqual([]);
  return only;
}

test("two half arcs are a circle", () => {
  const { points, closed } = loop("M0 1A1 1 0 0 1 2 1A1 1 0 0 1 0 1");
  expect(closed).toBe(true);
  // Arcs become cubics, 3e-4 of the radius off at most.
  for (let i = 0; i < points.length; i += 2) {
    expect(Math.hypot(points[i] - 1, points[i + 1] - 1)).toBeCloseTo(1, 3);
  }
  expect(signedArea(points)).toBeCloseTo(Math.PI, 2);
});

test.each([
  ["absolute", "M10 10H30V20L10 20Z"],
  ["relative", "m10 10h20v10l-20 0z"],
  ["without commands and with signs for commas", "M10 10 30+10,30,20 10 20z"],
])("lines %s", (_, data) => {
  expect([...loop(data).points]).toEqual([10, 10, 30, 10, 30, 20, 10, 20]);
});

test("smooth commands reflect the control point before them", () => {
  const plain = loop("M0 0C0 1 1 1 1 0C1 -1 2 -1 2 0Z");
  const short = loop("M0 0C0 1 1 1 1 0S2 -1 2 0Z");
  expect(short).toEqual(plain);
  const plainQuadratic = loop("M0 0Q1 2 2 0Q3 -2 4 0Z");
  const shortQuadratic = loop("M0 0Q1 2 2 0T4 0Z");
  expect(shortQuadratic).toEqual(plainQuadratic);
});

test("no point of a curve is further from its polyline than the tolerance", () => {
  const data = "M0 0C0 3 5 -2 4 1Z";
  const fine = loop(data, 1e-9).points;
  for (const tolerance of [0.1, 0.01, 0.001]) {
    const coarse = loop(data, tolerance).points;
    let worst = 0;
    for (let i = 0; i < fine.length; i += 2) worst = Math.max(worst, away(coarse, fine[i], fine[i + 1]));
    expect(worst).toBeLessThanOrEqual(tolerance);
    expect(worst).toBeGreaterThan(tolerance / 100);
  }
});

test("every subpath is found, and a new one begins where Z has gone back to", () => {
  const parts = flattened(parsePath("m0 0h2v2h-2zm4 4h1v1zM9 9h1v1"), IDENTITY, 1e-5);
  expect(parts.map(({ closed }) => closed)).toEqual([true, true, false]);
  expect([...parts[1].points.slice(0, 2)]).toEqual([4, 4]);
});

test("a matrix moves all points, and the box follows", () => {
  const matrix: Matrix = [0, 2, -1, 0, 5, 7];
  const { points } = loop("M0 0H1V1Z", 1e-5, matrix);
  expect([...points]).toEqual([5, 7, 5, 9, 4, 9]);
  expect(controlBounds(parsePath("M0 0H1V1Z"), matrix)).toEqual([4, 7, 5, 9]);
  expect(perimeter(points)).toBeCloseTo(3 + Math.sqrt(5));
});

test("broken data is refused", () => {
  expect(() => parsePath("M0 0L1,")).toThrow(/Path data cannot be read/);
});

function away(loop: Float64Array, x: number, y: number): number {
  let least = Infinity;
  for (let i = 0, j = loop.length - 2; i < loop.length; j = i, i += 2) {
    const [u, v] = [loop[i] - loop[j], loop[i + 1] - loop[j + 1]];
    const t = Math.min(1, Math.max(0, ((x - loop[j]) * u + (y - loop[j + 1]) * v) / (u * u + v * v)));
    least = Math.min(least, Math.hypot(x - loop[j] - t * u, y - loop[j + 1] - t * v));
  }
  return least;
}
