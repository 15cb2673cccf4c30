import { expect, test } from "vitest";
import { missedBy, unreached } from "./unreached";

const SQUARE = Float64Array.of(0.2, 0.2, 0.4, 0.2, 0.6, 0.2, 0.6, 0.6, 0.2, 0.6);

test("what the curve lies on is reached", () => {
  expect(unreached([SQUARE], [SQUARE], 5)).toEqual([]);
});

test("a loop that nothing comes near is drawn whole and closed", () => {
  const hole = Float64Array.of(0.8, 0.8, 0.9, 0.8, 0.9, 0.9);
  expect(unreached([SQUARE, hole], [SQUARE], 5)).toEqual([Float64Array.of(...hole, 0.8, 0.8)]);
});

test("a part that is left out begins and ends where the curve still is", () => {
  const notched = Float64Array.of(0.2, 0.2, 0.4, 0.4, 0.6, 0.2, 0.6, 0.6, 0.2, 0.6);
  expect(unreached([SQUARE], [notched], 5)).toEqual([Float64Array.of(0.2, 0.2, 0.4, 0.2, 0.6, 0.2)]);
});

test("without a curve nothing is reached", () => {
  expect(unreached([SQUARE], [], 5)).toHaveLength(1);
});

test("nothing is looked for while the match is on its way, nor where the solver says that all is covered", () => {
  const match = (finished: boolean, max: number) => ({
    status: { finished, level: 5, cover: { max } },
    curves: { template: [SQUARE], matched: [] },
  });
  expect([match(false, 9), match(true, 0.4), null].map((one) => missedBy(one).length)).toEqual([0, 0, 0]);
  expect(missedBy(match(true, 9))).toHaveLength(1);
});
