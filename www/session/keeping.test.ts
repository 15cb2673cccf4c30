import { signal } from "@preact/signals";
import { expect, test } from "vitest";
import type { Phase } from "../phase";
import type { Result } from "../run";
import { keepRuns } from "./keeping";

const RESULT = { settings: {} } as Result;

function stage(phase: Phase, { stale = false, live = false, result = RESULT as Result | null } = {}) {
  const kept: Result[] = [];
  const run = { phase: signal(phase), stale: signal(stale), result: signal(result) };
  const isLive = signal(live);
  keepRuns(run, isLive, { add: (one) => kept.push(one) });
  return { kept, run, isLive };
}

test("a match is kept when it is there, not on the way to it", () => {
  const { kept, run } = stage("solving");
  expect(kept).toEqual([]);
  run.phase.value = "matched";
  expect(kept).toEqual([RESULT]);
});

test("what is of other settings, follows the hand, or comes from a file is no run", () => {
  expect(stage("matched", { stale: true }).kept).toEqual([]);
  expect(stage("matched", { live: true }).kept).toEqual([]);
  expect(stage("restored").kept).toEqual([]);
  expect(stage("matched", { result: null }).kept).toEqual([]);
});
