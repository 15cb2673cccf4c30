import { expect, test } from "vitest";
import { perimeter } from "../shapes/geometry";
import { centroidSize, procrustesDistance } from "./configuration";
import { evenPoints, onOutline } from "./semilandmarks";
import { strains } from "./strain";

const SCALENE = Float64Array.of(0, 0, 4, 0, 1, 3);

const moved = (points: Float64Array, [a, b, c, d]: readonly number[], x = 0, y = 0) =>
  points.map((v, i) => (i % 2 === 0 ? a * v + b * points[i + 1] + x : c * points[i - 1] + d * v + y));

test("the centroid size of a square of side 2 is √8, and grows with the shape", () => {
  const square = Float64Array.of(0, 0, 2, 0, 2, 2, 0, 2);
  expect(centroidSize(square)).toBeCloseTo(Math.sqrt(8), 14);
  expect(centroidSize(moved(square, [0, -3, 3, 0], 7, 8))).toBeCloseTo(3 * Math.sqrt(8), 13);
});

test("the Procrustes distance of a similar shape is 0, and of a mirror image is not", () => {
  const [cos, sin] = [Math.cos(1), Math.sin(1)];
  expect(procrustesDistance(SCALENE, moved(SCALENE, [5 * cos, -5 * sin, 5 * sin, 5 * cos], 2, 3))).toBeLessThan(1e-14);
  expect(procrustesDistance(SCALENE, moved(SCALENE, [-1, 0, 0, 1]))).toBeGreaterThan(0.3);
});

test("triangles lie on Kendall's sphere: equilateral ones of both orientations are opposite, at distance √2", () => {
  const half = Math.sqrt(3) / 2;
  const equilateral = Float64Array.of(1, 0, -0.5, half, -0.5, -half);
  const mirrored = moved(equilateral, [1, 0, 0, -1]);
  expect(procrustesDistance(equilateral, mirrored)).toBeCloseTo(Math.SQRT2, 14);
  // Three points on a line lie on the equator: ρ = π/4 from either pole, d² = 2 − 2 cos ρ.
  const line = Float64Array.of(-1, 0, 0, 0, 1, 0);
  expect(procrustesDistance(equilateral, line)).toBeCloseTo(Math.sqrt(2 - Math.SQRT2), 14);
});

test("points lie evenly along each loop, as many on each as its length asks for", () => {
  const square = (a: number) => Float64Array.of(0, 0, a, 0, a, a, 0, a);
  const points = evenPoints([square(3), square(1)], 40);
  expect(points).toHaveLength(80);
  // Lengths 12 and 4: 30 and 10 of 40.
  expect([...points.subarray(60, 64)]).toEqual([0, 0, expect.closeTo(0.4, 14), 0]);
  expect(perimeter(points.subarray(0, 60))).toBeGreaterThan(11.5);
  expect(() => evenPoints([square(3), square(1)], 5)).toThrow(/6 points at least/);
});

test("a point beside the outline goes to the nearest place of it", () => {
  const square = Float64Array.of(0, 0, 1, 0, 1, 1, 0, 1);
  expect([...onOutline(Float64Array.of(0.3, -0.2, 1.1, 1.4, -0.1, 0.5), [square])]).toEqual([0.3, 0, 1, 1, 0, 0.5]);
});

/** φ(x) = A x on (cells + 1)² nodes. */
function linear(cells: number, matrix: readonly number[]): Float64Array {
  const side = cells + 1;
  const nodes = Float64Array.from({ length: 2 * side * side }, (_, k) => {
    const node = k >> 1;
    return (k % 2 === 0 ? node % side : Math.floor(node / side)) / cells;
  });
  return moved(nodes, matrix);
}

test("a similarity strains nothing once size is taken out", () => {
  const { first, second, expansion, cells } = strains(
    linear(
      4,
      [0.6, -0.8, 0.8, 0.6].map((v) => 3 * v),
    ),
    1 / 3,
  );
  expect(cells).toBe(4);
  for (let at = 0; at < 16; at += 1) {
    expect([first[at], second[at]]).toEqual([expect.closeTo(0, 7), expect.closeTo(0, 7)]);
    expect(expansion[at]).toBeCloseTo(1, 13);
  }
});

test("stretched by 1.5 along 30° and by 0.8 across, then turned, every cell tells just that", () => {
  const [c, s] = [Math.cos(Math.PI / 6), Math.sin(Math.PI / 6)];
  const stretch = [1.5 * c * c + 0.8 * s * s, 0.7 * c * s, 0.7 * c * s, 1.5 * s * s + 0.8 * c * c];
  const [a, b, d, e] = stretch;
  // Turned by a right angle afterwards: strains are of the reference.
  const { first, second, angle, expansion } = strains(linear(8, [-d, -e, a, b]), 1);
  for (let at = 0; at < 64; at += 1) {
    expect(first[at]).toBeCloseTo(0.5, 12);
    expect(second[at]).toBeCloseTo(-0.2, 12);
    expect(angle[at]).toBeCloseTo(Math.PI / 6, 12);
    expect(expansion[at]).toBeCloseTo(1.2, 12);
  }
});

test("a simple shear keeps areas, and its principal stretches are inverse to each other", () => {
  const gamma = 0.4;
  const { first, second, expansion } = strains(linear(4, [1, gamma, 0, 1]), 1);
  const most = gamma / 2 + Math.sqrt(1 + (gamma / 2) ** 2);
  expect(first[5]).toBeCloseTo(most - 1, 13);
  expect(second[5]).toBeCloseTo(1 / most - 1, 13);
  expect(expansion[5]).toBeCloseTo(1, 13);
});
