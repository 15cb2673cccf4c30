import { expect, test } from "vitest";
import { type Loop, reversed, type Shape, signedArea, winding } from "../geometry";
import { chosenParts } from "./parts";
import { united } from "./region";

function box(x: number, y: number, size: number): Loop {
  return Float64Array.from([x, y, x + size, y, x + size, y + size, x, y + size]);
}

function area(shape: Shape): number {
  return shape.reduce((sum, loop) => sum + signedArea(loop), 0);
}

/** A five-pointed star drawn in one stroke. */
const PENTAGRAM = Float64Array.from(
  Array.from({ length: 5 }, (_, k) => (4 * Math.PI * k) / 5).flatMap((t) => [Math.cos(t), Math.sin(t)]),
);

test("the rules differ in the middle of a pentagram", () => {
  const filled = united([{ loops: [PENTAGRAM], rule: "nonzero" }]);
  const hollow = united([{ loops: [PENTAGRAM], rule: "evenodd" }]);
  expect(winding(filled, { x: 0, y: 0 })).toBe(1);
  expect(winding(hollow, { x: 0, y: 0 })).toBe(0);
  // The inner pentagon has the radius cos 72° / cos 36°.
  const inner = Math.cos((2 * Math.PI) / 5) / Math.cos(Math.PI / 5);
  const pentagon = (5 / 2) * inner ** 2 * Math.sin((2 * Math.PI) / 5);
  expect(area(filled) - area(hollow)).toBeCloseTo(pentagon, 5);
});

test("a loop that runs the same way inside another is a hole under evenodd alone", () => {
  const nested = [box(0, 0, 4), box(1, 1, 2)];
  expect(area(united([{ loops: nested, rule: "nonzero" }]))).toBeCloseTo(16, 5);
  expect(area(united([{ loops: nested, rule: "evenodd" }]))).toBeCloseTo(12, 5);
  expect(area(united([{ loops: [nested[0], reversed(nested[1])], rule: "nonzero" }]))).toBeCloseTo(12, 5);
});

test("bodies run counter-clockwise and holes clockwise, however they were drawn", () => {
  for (const turn of [(loop: Loop) => loop, reversed]) {
    const shape = united([{ loops: [turn(box(0, 0, 4)), turn(box(1, 1, 2))], rule: "evenodd" }]);
    expect(shape.map((loop) => Math.sign(signedArea(loop))).sort()).toEqual([-1, 1]);
  }
});

test("regions that overlap unite, whatever their rules", () => {
  const shape = united([
    { loops: [box(0, 0, 2)], rule: "evenodd" },
    { loops: [reversed(box(1, 1, 2))], rule: "nonzero" },
  ]);
  expect(shape).toHaveLength(1);
  expect(area(shape)).toBeCloseTo(7, 5);
});

test("what encloses nothing is nothing", () => {
  expect(united([{ loops: [Float64Array.of(0, 0, 1, 1, 2, 2)], rule: "nonzero" }])).toEqual([]);
  expect(united([])).toEqual([]);
});

test("parts and holes are chosen", () => {
  const island = box(4, 4, 1);
  const shape = united([
    { loops: [box(0, 0, 10), box(3, 3, 4), island, box(20, 0, 3), box(21, 1, 1)], rule: "evenodd" },
  ]);
  expect(area(shape)).toBeCloseTo(100 - 16 + 1 + 9 - 1, 4);
  expect(area(chosenParts(shape, "largest", "keep"))).toBeCloseTo(100 - 16, 4);
  expect(area(chosenParts(shape, "all", "fill"))).toBeCloseTo(109, 4);
  expect(area(chosenParts(shape, "largest", "fill"))).toBeCloseTo(100, 4);
});
