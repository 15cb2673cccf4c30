import { expect, test } from "vitest";
import { localNumbers } from "./local";
import { probeAt, stepped } from "./probe";
import type { Match } from "./result";

const COUNT = 120;

function circle(radius: number): Float64Array {
  return Float64Array.from({ length: 2 * COUNT }, (_, k) => {
    const t = (2 * Math.PI * (k >> 1)) / COUNT;
    return 0.5 + radius * (k % 2 === 0 ? Math.cos(t) : Math.sin(t));
  });
}

/** A circle doubled about the middle of the box. */
function doubling(): Match {
  const side = 65;
  const deformation = Float64Array.from({ length: 2 * side * side }, (_, k) => {
    const node = k >> 1;
    return 2 * ((k % 2 === 0 ? node % side : Math.floor(node / side)) / 64) - 0.5;
  });
  return {
    level: 6,
    deformation,
    curves: { reference: [circle(0.2)], template: [circle(0.4)], matched: [circle(0.4)] },
  };
}

test("the numbers at a point of a doubled circle are those of a doubling", () => {
  const numbers = localNumbers(doubling(), { x: 0.7, y: 0.5 });
  expect(numbers).toEqual({
    x: expect.closeTo(0.7, 12),
    y: expect.closeTo(0.5, 12),
    partnerX: expect.closeTo(0.9, 12),
    partnerY: expect.closeTo(0.5, 12),
    stretch: expect.closeTo(2, 10),
    determinant: expect.closeTo(4, 10),
    curvature: expect.closeTo(5, 0),
    partnerCurvature: expect.closeTo(2.5, 1),
    distance: expect.closeTo(0, 10),
  });
});

test("a pointer finds the reference's point from the point or from its image, and nothing far from both", () => {
  const { reference, matched } = doubling().curves;
  expect(probeAt(reference, matched, 0.71, 0.5, 0.05)).toEqual({ x: 0.7, y: 0.5 });
  expect(probeAt(reference, matched, 0.89, 0.5, 0.05)).toEqual({ x: 0.7, y: 0.5 });
  expect(probeAt(reference, matched, 0.8, 0.5, 0.05)).toBeNull();
});

test("keys walk round the loop and back", () => {
  const { reference } = doubling().curves;
  const first = stepped(reference, null, 1);
  expect(first).toEqual({ x: 0.7, y: 0.5 });
  expect(stepped(reference, stepped(reference, first, -1), 1)).toEqual(first);
  expect(stepped(reference, first, COUNT)).toEqual(first);
  expect(stepped([], null, 1)).toBeNull();
});
