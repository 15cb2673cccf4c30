import { expect, test } from "vitest";
import {
  bandWeights,
  determinantAt,
  distances,
  type GridMap,
  logDeterminants,
  mapped,
  minDeterminant,
  mismatches,
  thinned,
  valueAt,
} from "./field";

function map(cells: number, f: (x: number, y: number) => readonly [number, number]): GridMap {
  const side = cells + 1;
  const deformation = new Float64Array(2 * side * side);
  for (let node = 0; node < side * side; node += 1) {
    deformation.set(f((node % side) / cells, Math.floor(node / side) / cells), 2 * node);
  }
  return { cells, deformation };
}

const SHEARED = map(8, (x, y) => [2 * x + y, 0.5 + 3 * y]);
const CIRCLE = Float64Array.from({ length: 400 }, (_, k) => {
  const t = (Math.PI * (k >> 1)) / 100;
  return 0.5 + 0.25 * (k % 2 === 0 ? Math.cos(t) : Math.sin(t));
});

test("an affine map is met everywhere, and its determinant is its own", () => {
  for (const [x, y] of [
    [0, 0],
    [0.31, 0.77],
    [1, 1],
  ]) {
    expect(mapped(SHEARED, x, y)).toEqual([expect.closeTo(2 * x + y, 12), expect.closeTo(0.5 + 3 * y, 12)]);
    expect(determinantAt(SHEARED, x, y)).toBeCloseTo(6, 10);
  }
  for (const value of logDeterminants(SHEARED)) expect(value).toBeCloseTo(Math.log2(6), 8);
});

test("the least determinant is that of an affine map, and negative where one node is turned over", () => {
  expect(minDeterminant(SHEARED)).toBeCloseTo(6, 10);
  const turned = { ...SHEARED, deformation: SHEARED.deformation.slice() };
  turned.deformation[2 * 40] += 1;
  expect(minDeterminant(turned)).toBeLessThan(0);
});

test("thinning keeps what nodes it keeps", () => {
  const coarse = thinned(SHEARED, 4);
  expect(coarse.cells).toBe(4);
  expect(mapped(coarse, 0.3, 0.6)).toEqual(mapped(SHEARED, 0.3, 0.6).map((value) => expect.closeTo(value, 12)));
});

test("the band weighs 1 on the curve and 0 at its edge", () => {
  expect([...bandWeights(Float64Array.of(0, 0.05, -0.1, 0.2), 0.1)]).toEqual([1, expect.closeTo(0.5625), 0, 0]);
});

test("a shift by a tenth misses by a tenth across it and matches along it", () => {
  const shifted = map(64, (x, y) => [x + 0.01, y]);
  const off = mismatches(shifted, [CIRCLE], distances([CIRCLE], 64), 0.05);
  expect(valueAt(off, 64, 0.75, 0.5)).toBeCloseTo(0.01, 3);
  expect(valueAt(off, 64, 0.5, 0.75)).toBeLessThan(0.002);
  expect(valueAt(off, 64, 0.5, 0.5)).toBeNaN();
});
