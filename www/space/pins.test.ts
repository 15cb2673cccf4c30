import { expect, test } from "vitest";
import { surface } from "./gallery";
import { decode, encode } from "./link";
import { carried, farthestOff, flat, type Pin, pinsFrom, samePins, swapped, withEnd, without } from "./pins";
import { FIRST_LOOK } from "./session";

const PINS: readonly Pin[] = [
  { reference: [0.74, 0.5, 0.5], template: [0.5, 0.7, 0.5] },
  { reference: [0.5, 0.26, 0.5], template: [0.82, 0.5, 0.125] },
];

test("the solver's list of numbers is the pins, and the pins are the list", () => {
  expect([...flat(PINS)].slice(5, 9)).toEqual([0.5, 0.5, 0.26, 0.5]);
  expect(pinsFrom([...flat(PINS)])).toEqual(PINS);
  expect(flat([])).toHaveLength(0);
});

test("an end is replaced, a pin taken out, the roles exchanged; the others stay", () => {
  const moved = withEnd(PINS, 1, "template", [0.1, 0.2, 0.3]);
  expect(moved[1]).toEqual({ reference: PINS[1].reference, template: [0.1, 0.2, 0.3] });
  expect(moved[0]).toBe(PINS[0]);
  expect(without(PINS, 0)).toEqual([PINS[1]]);
  expect(swapped(swapped(PINS))).toEqual(PINS);
  expect(swapped(PINS)[0].reference).toEqual(PINS[0].template);
  expect(samePins(PINS, swapped(swapped(PINS)))).toBe(true);
  expect(samePins(PINS, moved)).toBe(false);
});

test("pins stand in the link; a link that ties a point to none, or to one outside of the box, is refused", () => {
  const solids = { reference: { id: "sphere" }, template: { id: "cube" }, settings: {} };
  const text = encode({ ...solids, pins: PINS }, FIRST_LOOK);
  expect(decode(text).pins).toEqual(PINS);
  expect(encode({ ...solids, pins: [] }, FIRST_LOOK)).not.toContain("pins");
  expect(decode("space=1").pins).toEqual([]);
  for (const pins of ["0.5,0.5,0.5", "0.5,0.5,0.5,0.5,0.5,1.5", "0.5,,0.5,0.5,0.5,0.5", "a"])
    expect(() => decode(`space=1&pins=${pins}`), pins).toThrow();
});

test("a pin goes with the surface around it, and what it is off is measured after the match", () => {
  const sphere = surface("sphere");
  if (!sphere) throw new Error("no sphere");
  const shifted = sphere.positions.map((x, k) => (k % 3 === 0 ? x + 0.1 : x));
  const [x, y, z] = carried([0.74, 0.5, 0.5], sphere.positions, shifted);
  expect([x, y, z]).toEqual([expect.closeTo(0.84, 12), 0.5, 0.5]);
  const pins: Pin[] = [
    { reference: [0.74, 0.5, 0.5], template: [0.84, 0.5, 0.5] },
    { reference: [0.5, 0.74, 0.5], template: [0.6, 0.74, 0.45] },
  ];
  expect(farthestOff(pins, sphere.positions, shifted)).toBeCloseTo(0.05, 12);
});
