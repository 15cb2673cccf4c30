import { expect, test } from "vitest";
import { amounts, type Colour, clipped, DIVERGING, factors, quantile, roundUp, SEQUENTIAL, signed } from "./scales";

/** OKLab lightness of sRGB bytes: the inverse matrices of palette.ts. */
function lightness([red, green, blue]: Colour): number {
  const [r, g, b] = [red, green, blue].map((byte) => {
    const c = byte / 255;
    return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
  });
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return 0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s;
}

/** Over 16 entries, as rounding to bytes makes single steps uneven. */
function steps(colours: readonly Colour[]): number[] {
  return colours.slice(16).map((colour, i) => lightness(colour) - lightness(colours[i]));
}

test("the sequential scale grows evenly lighter", () => {
  const all = steps(SEQUENTIAL);
  const mean = all.reduce((sum, step) => sum + step, 0) / all.length;
  expect(Math.min(...all) / mean).toBeGreaterThan(0.85);
  expect(Math.max(...all) / mean).toBeLessThan(1.15);
});

test.each([
  ["light", 1],
  ["dark", -1],
] as const)("the %s diverging scale turns once, in its middle", (name, up) => {
  const colours = DIVERGING[name];
  for (const step of steps(colours.slice(0, 128))) expect(up * step).toBeGreaterThan(0);
  for (const step of steps(colours.slice(128))) expect(up * step).toBeLessThan(0);
  const [red, green, blue] = colours[127];
  expect(Math.max(red, green, blue) - Math.min(red, green, blue)).toBeLessThan(6);
});

test("scales put their ends and middles where their ticks say", () => {
  expect([0, 2, 4].map(amounts("", "", 4).part)).toEqual([0, 0.5, 1]);
  expect([0.25, 1, 4].map(factors("", false, 2).part)).toEqual([0, 0.5, 1]);
  expect([-3, 0, 3].map(signed("", "", false, 3).part)).toEqual([0, 0.5, 1]);
  expect(factors("", true, 2).ticks.map(({ text }) => text)).toEqual(["0.25", "1", "4"]);
});

test("scales end at round numbers", () => {
  expect([0.3, 1, 1.1, 7, 0.05, 0].map(roundUp)).toEqual([0.5, 1, 2, 10, 0.05, 1]);
  expect(quantile([3, Number.NaN, 1, 2], 0.5)).toBe(2);
  expect(quantile([], 0.5)).toBe(0);
});

test("an end is marked where a value lies beyond it, and only there", () => {
  const texts = (least: number, most: number) =>
    clipped(signed("", "", false, 4), least, most).ticks.map(({ text }) => text);
  expect(texts(0, 1)).toEqual(["−4", "0", "4"]);
  expect(texts(-0.2, 1)).toEqual(["≤ −4", "0", "4"]);
  expect(texts(0.4, 3)).toEqual(["−4", "0", "≥ 4"]);
});
