import { expect, test } from "vitest";
import { cells, decimals } from "./numbers";

test.each([
  [0, "0"],
  [0.123456, "0.123"],
  [12.3456, "12.3"],
  [0.00012345, "0.000123"],
  [0.0000123, "1.2 × 10^-5"],
  [-3.25, "-3.25"],
])("%f reads %s", (value, text) => {
  expect(decimals(value)).toBe(text);
});

test.each([Number.NaN, Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY])("%f reads as words", (value) => {
  expect(decimals(value)).toMatch(/^[a-z ]+$/);
  expect(cells(value)).toBe("none: the grid does not see the curve");
});
