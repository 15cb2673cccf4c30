import { expect, test } from "vitest";
import { decimals, power } from "./numbers";
import { cells } from "./said";

test.each([
  [0, "0"],
  [0.123456, "0.123"],
  [12.3456, "12.3"],
  [0.00012345, "0.000123"],
  [0.0000123, "1.2·10⁻⁵"],
  [-0.0000123, "−1.2·10⁻⁵"],
  [123456, "1.2·10⁵"],
  [-3.25, "−3.25"],
])("%f reads %s", (value, text) => {
  expect(decimals(value)).toBe(text);
});

test.each([Number.NaN, Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY])("%f reads as words", (value) => {
  expect(decimals(value)).toMatch(/^[a-z ]+$/);
  expect(cells(value)).toEqual({ text: "none: the grid does not see the curve", unit: "" });
});

test("only whole powers of ten are named by their exponent", () => {
  expect([1000, 1, 0.001, 20, 0, null].map(power)).toEqual(["10³", "10⁰", "10⁻³", null, null, null]);
});
