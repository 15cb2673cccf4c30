import { expect, test } from "vitest";
import { CYCLES, oklabOnCycle, onCycle, rgbFromOklab } from "./palette";

function channels(colour: string): number[] {
  return (colour.match(/\d+/g) ?? []).map(Number);
}

/** sRGB bytes to OKLab: the inverse matrices of the same source. */
function oklab(colour: string): number[] {
  const [r, g, b] = channels(colour).map((byte) => {
    const c = byte / 255;
    return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
  });
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return [
    0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
    1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
    0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s,
  ];
}

test.each(["light", "dark"] as const)("the %s scale is cyclic and takes equal steps for the eye", (name) => {
  const colours = CYCLES[name];
  // Over thirty entries, as rounding to bytes makes single steps uneven.
  const steps = colours.map((colour, i) => {
    const a = oklab(colour);
    const b = oklab(colours[(i + 30) % colours.length]);
    return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  });
  const mean = steps.reduce((sum, step) => sum + step, 0) / steps.length;
  expect(Math.max(...steps) / mean).toBeLessThan(1.1);
  expect(Math.min(...steps) / mean).toBeGreaterThan(0.9);
});

test.each([
  ["light", 0.62],
  ["dark", 0.74],
] as const)("the %s scale stays inside sRGB", (_, middle) => {
  for (let t = 0; t < 6.3; t += 0.01) {
    for (const channel of rgbFromOklab(...oklabOnCycle(middle, t))) {
      expect(channel).toBeGreaterThanOrEqual(0);
      expect(channel).toBeLessThanOrEqual(1);
    }
  }
});

test("white is white", () => {
  for (const channel of rgbFromOklab(1, 0, 0)) expect(channel).toBeCloseTo(1, 4);
});

test("a whole turn comes back to the first colour", () => {
  const { light } = CYCLES;
  expect(onCycle(light, 1)).toBe(onCycle(light, 0));
  expect(onCycle(light, -0.25)).toBe(onCycle(light, 0.75));
});
