import { expect, test } from "vitest";
import { applied, compose, parseTransform, pixels } from "./transform";

test.each([
  ["translate(3)", 4, 2],
  ["translate(3, 4)", 4, 6],
  ["translateY(4px)", 1, 6],
  ["scale(2)", 2, 4],
  ["scale(2 -1)", 2, -2],
  ["rotate(90)", -2, 1],
  ["rotate(0.25turn)", -2, 1],
  ["rotate(90 1 1)", 0, 1],
  ["skewX(45)", 3, 2],
  ["skewY(45deg)", 1, 3],
  ["matrix(1 2 3 4 5 6)", 12, 16],
  ["matrix(1-2 3 4.5.5-6)", 7.5, 1],
  ["none", 1, 2],
])("%s takes (1, 2) to (%d, %d)", (text, x, y) => {
  const [u, v] = applied(parseTransform(text), 1, 2);
  expect(u).toBeCloseTo(x, 12);
  expect(v).toBeCloseTo(y, 12);
});

test("the last of a list acts first", () => {
  const list = parseTransform("translate(10 0) rotate(90), scale(2)");
  const steps = compose(
    parseTransform("translate(10 0)"),
    compose(parseTransform("rotate(90)"), parseTransform("scale(2)")),
  );
  expect(applied(list, 1, 0)).toEqual(applied(steps, 1, 0));
  expect(applied(list, 1, 0)[1]).toBeCloseTo(2);
});

test.each(["spin(3)", "translate(1 2 3)", "scale(two)", "rotate(10em)", "rotate(30"])("%s is refused", (text) => {
  expect(() => parseTransform(text)).toThrow(/transform “.*” cannot be read/);
});

test("lengths have the units of CSS", () => {
  expect(pixels("1in")).toBe(96);
  expect(pixels("25.4mm")).toBeCloseTo(96);
  expect(pixels(" -.5e1px ")).toBe(-5);
  expect(pixels("50%")).toBeNull();
  expect(pixels("auto")).toBeNull();
});

test.each([
  ["letters", "a".repeat(1_000_000)],
  ["spaces", `${" ".repeat(1_000_000)}x`],
  ["digits", `scale(${"1".repeat(1_000_000)})`],
  ["words without an end", "rotate(30 ".repeat(100_000)],
])("a million %s are refused after one look at each", (_, text) => {
  // Looked at anew from every letter, they would take the rest of the day: the test would not end.
  expect(() => parseTransform(text)).toThrow(/transform “.{1,61}” cannot be read/s);
});
