import { expect, test } from "vitest";
import { decimals } from "./numbers";

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
