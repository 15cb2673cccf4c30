import { expect, test } from "vitest";
import { PLAYS, partAt, REST_MILLIS, WAY_MILLIS } from "./playing";

const LEG = WAY_MILLIS + REST_MILLIS;

test("once goes from one end to the other and is over", () => {
  expect(partAt("once", 0)).toBe(0);
  expect(partAt("once", WAY_MILLIS / 2)).toBeCloseTo(0.5, 12);
  expect(partAt("once", WAY_MILLIS)).toBeNull();
});

test("a loop rests at the match and begins again, for ever", () => {
  expect(partAt("loop", WAY_MILLIS + 1)).toBe(1);
  expect(partAt("loop", LEG)).toBe(0);
  expect(partAt("loop", 100 * LEG + WAY_MILLIS / 2)).toBeCloseTo(0.5, 9);
});

test("to and fro never jumps", () => {
  for (let millis = 0; millis < 3 * LEG; millis += 10) {
    const [before, after] = [partAt("swing", millis) ?? Number.NaN, partAt("swing", millis + 10) ?? Number.NaN];
    expect(Math.abs(after - before)).toBeLessThan(0.01);
  }
  expect(partAt("swing", LEG + WAY_MILLIS)).toBeCloseTo(0, 12);
});

test("no way of playing leaves the way", () => {
  for (const play of PLAYS) {
    for (let millis = 0; millis < 3 * LEG; millis += 37) {
      const part = partAt(play, millis) ?? 1;
      expect(part).toBeGreaterThanOrEqual(0);
      expect(part).toBeLessThanOrEqual(1);
    }
  }
});
