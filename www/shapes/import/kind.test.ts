import { expect, test } from "vitest";
import { isPathData } from "./kind";

test.each(["M0 0L10 0 10 10z", "m.5-.5 10,0\n h 3z", "M1e-3,2C1 2 3 4 5 6Z", "M 10 10 A 5 5 0 0 1 20 20 Z"])(
  "%s is path data",
  (text) => {
    expect(isPathData(text)).toBe(true);
  },
);

test.each(["", "M", "Mx 3", "Many points", "0 0 L 1 1", '{"M": 1}', 'M0 0"/><script>', "x,y\n1,2"])(
  "“%s” is no path data",
  (text) => {
    expect(isPathData(text)).toBe(false);
  },
);
