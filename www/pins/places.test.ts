import { describe, expect, test } from "vitest";
import { pulled, settled, withLoop } from "../shapes/edit";
import { about, fitted, nearestVertex, type Shape, shift, transformed } from "../shapes/geometry";
import { flat, type Pin, pinsFrom, type Shapes } from "../shapes/pins";
import { PRESETS } from "../shapes/presets";
import { nearest } from "../view/along";
import { carried, followed, similarityBetween, snapped, withEnd, without } from "./places";

function edited(shapes: Shapes, side: "reference" | "template", shape: Shape): Shapes {
  return { ...shapes, [side]: shape, pins: carried(shapes.pins, side, shapes[side], shape) };
}

const [{ reference, template }] = PRESETS;
const [loop] = reference;
const ON_CURVE = { x: (loop[0] + 3 * loop[2]) / 4, y: (loop[1] + 3 * loop[3]) / 4 };
const FREE = { x: 0.2, y: 0.9 };
const PINS: readonly Pin[] = [
  { reference: ON_CURVE, template: { x: 0.81, y: 0.5 } },
  { reference: FREE, template: { x: 0.1, y: 0.1 } },
];
const SHAPES: Shapes = { reference, template, pins: PINS };

function pinsAfter(shape: Shape): readonly Pin[] {
  return edited(SHAPES, "reference", shape).pins;
}

test("a list of numbers is the pins, and the pins are the list", () => {
  expect(pinsFrom(flat(PINS))).toEqual(PINS);
  expect([...flat(PINS)].slice(2, 4)).toEqual([0.81, 0.5]);
});

test("an end is replaced, a pin taken out, the others stay", () => {
  const moved = withEnd(PINS, 1, "template", FREE);
  expect(moved[1]).toEqual({ reference: FREE, template: FREE });
  expect(moved[0]).toBe(PINS[0]);
  expect(without(PINS, 0)).toEqual([PINS[1]]);
});

test("a point near the curve snaps to it, one in the open stays, and both stay in the box", () => {
  const near = snapped(reference, { x: ON_CURVE.x + 0.01, y: ON_CURVE.y }, 0.03);
  expect(Math.hypot(near.x - 0.5, near.y - 0.5)).toBeCloseTo(0.15, 4);
  expect(snapped(reference, FREE, 0.03)).toEqual(FREE);
  expect(snapped(reference, { x: 1.2, y: -0.1 }, 0.03)).toEqual({ x: 1, y: 0 });
  expect(snapped([], FREE, 0.03)).toEqual(FREE);
});

describe("when a shape changes, its ends of the pins", () => {
  test.each([
    ["moved", shift(0.05, -0.03)],
    ["turned and scaled", about({ x: 0.4, y: 0.6 }, 0.8, 0.3)],
  ])("are %s with it, and the other ends stay", (_, motion) => {
    const pins = pinsAfter(transformed(reference, motion));
    pins.forEach((pin, i) => {
      const [[x, y]] = transformed([flat(PINS).slice(4 * i, 4 * i + 2)], motion);
      expect(pin.reference.x).toBeCloseTo(x, 12);
      expect(pin.reference.y).toBeCloseTo(y, 12);
      expect(pin.template).toEqual(PINS[i].template);
    });
  });

  test("stay at their place along a curve that is pulled; those in the open stay", () => {
    const grip = nearestVertex(reference, ON_CURVE);
    if (!grip) throw new Error("the circle has points");
    const [on, free] = pinsAfter(pulled(reference, grip, 0.2, 0));
    expect(on.reference.x - ON_CURVE.x).toBeGreaterThan(0.19);
    expect(free.reference).toEqual(FREE);
  });

  test("stay on a curve whose points are spaced out anew", () => {
    const grip = nearestVertex(reference, ON_CURVE);
    if (!grip) throw new Error("the circle has points");
    const before = edited(SHAPES, "reference", pulled(reference, grip, 0.3, 0));
    const spaced = settled(before.reference);
    expect(spaced).not.toEqual(before.reference);
    const [on] = edited(before, "reference", spaced).pins;
    expect(nearest(spaced, on.reference.x, on.reference.y)?.distance).toBeLessThan(1e-9);
    expect(
      Math.hypot(on.reference.x - before.pins[0].reference.x, on.reference.y - before.pins[0].reference.y),
    ).toBeLessThan(0.01);
  });

  test("stay when a part is added", () => {
    expect(pinsAfter(withLoop(reference, template[0]))).toEqual(PINS);
  });

  test("go when it is cleared, or another is drawn in its place", () => {
    expect(pinsAfter([])).toEqual([]);
    expect(pinsAfter(template)).toEqual([]);
  });

  test("stay in the box", () => {
    const [, free] = pinsAfter(transformed(reference, shift(0, 0.3)));
    expect(free.reference.y).toBe(1);
  });
});

test("a similarity between two shapes is found, and where there is none, none", () => {
  const motion = about({ x: 0.4, y: 0.6 }, 1.3, -2);
  const found = similarityBetween(reference, transformed(reference, motion));
  for (const key of ["a", "b", "x", "y"] as const) expect(found?.[key]).toBeCloseTo(motion[key], 12);
  expect(similarityBetween(reference, fitted(reference))).not.toBeNull();
  expect(similarityBetween(reference, template)).toBeNull();
  expect(similarityBetween(reference, [])).toBeNull();
});

test("a pin on a curve whose points all move stays at its place along it, one beside it stays where it is", () => {
  const square = Float64Array.of(0.2, 0.2, 0.6, 0.2, 0.6, 0.6, 0.2, 0.6);
  const moved = square.map((value) => 1 - value);
  const pin = (x: number, y: number) => ({ reference: { x, y }, template: { x: 0.1, y: 0.1 } });
  const [on, beside] = followed([pin(0.3, 0.2), pin(0.4, 0.4)], "reference", [square], [moved]);
  expect(on.reference).toEqual({ x: expect.closeTo(0.7, 12), y: expect.closeTo(0.8, 12) });
  expect(beside.reference).toEqual({ x: 0.4, y: 0.4 });
});
