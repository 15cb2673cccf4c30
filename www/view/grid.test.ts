import { expect, test } from "vitest";
import { gridLines, LINES } from "./grid";

test("of a small grid every line is drawn, along x and along y, the four of its border marked", () => {
  const lines = gridLines(1);
  expect(lines.map(({ first, step }) => [0, 1, 2].map((k) => first + k * step))).toEqual([
    [0, 1, 2],
    [0, 3, 6],
    [3, 4, 5],
    [1, 4, 7],
    [6, 7, 8],
    [2, 5, 8],
  ]);
  expect(lines.map(({ isBorder }) => isBorder)).toEqual([true, true, false, false, true, true]);
});

test("of a fine grid as many lines are drawn as of one that has no more, and the border is among them", () => {
  for (const level of [5, 7, 9]) {
    const lines = gridLines(level);
    expect(lines).toHaveLength(2 * (LINES + 1));
    expect(lines.filter(({ isBorder }) => isBorder)).toHaveLength(4);
  }
  expect(gridLines(7, 8)).toHaveLength(18);
});
