import { expect, test } from "vitest";
import { isKept, KEPT_LEVEL, kept } from "./trail";
import { identity } from "./view/identity";
import { matchAt } from "./view/past";

const LOOP = Float64Array.of(0.31, 0.42, 0.63, 0.44, 0.52, 0.71);
const CURVES = { reference: [LOOP], template: [LOOP], matched: [LOOP] };

/** An affine map on a level: bilinear interpolation meets it wherever its nodes lie. */
function sheared(level: number): Float64Array {
  return identity(2 ** level).map((value, k, all) => (k % 2 === 0 ? 2 * value + all[k + 1] : value - 0.1));
}

test.each([3, KEPT_LEVEL, 8])(
  "of level %d no more nodes are kept than a picture shows, and the curve lies where it lay",
  (level) => {
    const compact = kept(sheared(level), level);
    expect(compact.length).toBe(2 * (2 ** Math.min(level, KEPT_LEVEL) + 1) ** 2);
    const match = matchAt({ level, kept: compact }, CURVES);
    const moved = match?.curves.matched[0] ?? new Float64Array(0);
    for (let i = 0; i < LOOP.length; i += 2) {
      expect(moved[i]).toBeCloseTo(2 * LOOP[i] + LOOP[i + 1], 5);
      expect(moved[i + 1]).toBeCloseTo(LOOP[i + 1] - 0.1, 5);
    }
  },
);

test("an iteration of which nothing was kept has no picture", () => {
  expect(matchAt({ level: 5 }, CURVES)).toBeNull();
});

test("the first iterations of a run are all kept, and of a long one so many that it stays small", () => {
  const runs = Array.from({ length: 10_000 }, (_, n) => isKept(n));
  expect(runs.slice(0, 1000).every(Boolean)).toBe(true);
  const bytes = runs.filter(Boolean).length * 8 * 33 ** 2;
  expect(bytes).toBeLessThan(20e6);
});
