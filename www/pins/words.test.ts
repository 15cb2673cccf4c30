import { expect, test } from "vitest";
import { place } from "../words/place";
import { pinsAside, pinsOff } from "./words";

test("pins within a cell of their partners are not worth a word", () => {
  expect(pinsOff([], 1)).toBeNull();
  expect(pinsOff([0.2, 1], 0)).toBeNull();
});

test("a far-off pin says so, by its number, with a remedy", () => {
  expect(pinsOff([0.1, 3.1418], 1)).toBe(
    "Pin 2 ends 3.14 cells from its partner: move it, or raise the strength of pins in the settings.",
  );
});

test("of many far-off pins four are named", () => {
  expect(pinsOff([9, 8, 7, 6, 5, 4], 1)).toBe(
    "Pin 1 ends 9 cells from its partner, pin 2 8 cells, pin 3 7 cells, pin 4 6 cells, and 2 more: move them, or raise their strength in the settings.",
  );
});

test("pins without strength are said to be ignored", () => {
  expect(pinsOff([4], 0)).toContain("their strength is 0");
});

test("a pin from a curve to the open says that it contradicts the fit", () => {
  expect(pinsAside([0.9, 0])).toBeNull();
  expect(pinsAside([0.9, 9.5])).toContain("Pin 2 ties two points of which one lies 9.5 cells farther from its curve");
});

test("a place is told in parts of the box", () => {
  expect(place({ x: 0.42004, y: 1 })).toBe("0.42 across, 1 up");
});
