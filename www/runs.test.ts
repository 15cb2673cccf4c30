import { expect, test } from "vitest";
import type { FrameReply } from "./protocol";
import type { Result } from "./run";
import { choiceWords, Runs } from "./runs";

function result(numbers = 2): Result {
  const frame = { deformation: new Float64Array(numbers) } as FrameReply;
  return { reference: [], template: [], pins: [], settings: {}, frame };
}

test("the newest is first, and the oldest are let go", () => {
  const runs = new Runs();
  for (let i = 0; i < 20; i += 1) runs.add(result());
  expect(runs.list.value.map(({ id }) => id)).toEqual([20, 19, 18, 17, 16, 15, 14, 13, 12, 11, 10, 9]);
});

test("one that is shown again is not added again", () => {
  const runs = new Runs();
  const one = result();
  runs.add(one);
  runs.add({ ...one });
  expect(runs.list.value).toHaveLength(1);
});

test("a pinned run outlives the others, until it is let go", () => {
  const runs = new Runs();
  runs.add(result());
  runs.pin(1);
  for (let i = 0; i < 20; i += 1) runs.add(result());
  expect(runs.of(1)).not.toBeNull();
  runs.pin(1);
  expect(runs.pinned.value).toBeNull();
  runs.add(result());
  expect(runs.of(1)).toBeNull();
});

test("of runs on large grids fewer are kept, but always the newest", () => {
  const runs = new Runs();
  for (let i = 0; i < 5; i += 1) runs.add(result(1.5e6));
  expect(runs.list.value.map(({ id }) => id)).toEqual([5, 4]);
  runs.add(result(5e6));
  expect(runs.list.value.map(({ id }) => id)).toEqual([6]);
});

test("a choice is told by what differs from the other", () => {
  expect(choiceWords({ bending: 0, finest: 6 }, {})).toEqual(["Bending 0", "Finest grid 65 × 65"]);
  expect(choiceWords({}, { bending: 0 })).toEqual(["Bending 0.03"]);
  expect(choiceWords({ bending: 0 }, { bending: 0 })).toEqual([]);
});
