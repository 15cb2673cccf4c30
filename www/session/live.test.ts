import { signal } from "@preact/signals";
import { expect, test } from "vitest";
import type { Phase } from "../phase";
import type { Shapes } from "../shapes/pins";
import { Live } from "./live";

const SQUARE = [Float64Array.of(0.4, 0.4, 0.6, 0.4, 0.6, 0.6, 0.4, 0.6)];

/** Notes what the run is told, in a state that the test gives. */
function stage({ phase = "idle" as Phase, empty = false, established = false, upToDate = false } = {}) {
  const told: string[] = [];
  const note = (name: string) => () => {
    told.push(name);
  };
  const run = {
    phase: signal(phase),
    established,
    upToDate,
    start: note("start"),
    drop: note("drop"),
    follow: note("follow"),
    settle: note("settle"),
    restartSoon: note("restartSoon"),
  };
  const shapes = signal<Shapes>({ reference: SQUARE, template: empty ? [] : SQUARE, pins: [] });
  const problem = signal<string | null>(null);
  return { told, problem, live: new Live(run, shapes, problem) };
}

test("without Live a change begins a run under way anew, and nothing follows the hand", () => {
  const { told, live } = stage({ phase: "solving" });
  live.moving(1);
  live.moved("shapes");
  live.changed("settings");
  expect(told).toEqual(["restartSoon", "restartSoon"]);
});

test("without Live a run that is paused or has lost a shape ends when the shapes change", () => {
  for (const state of [{ phase: "paused" as const }, { empty: true }]) {
    const { told, live } = stage(state);
    live.changed("shapes");
    expect(told).toEqual(["drop"]);
  }
});

test("with Live the match follows the hand, and settles when that has let go", () => {
  const { told, live } = stage({ upToDate: true, established: true });
  live.set(true);
  live.moving(1);
  live.moved("shapes");
  live.changed("shapes");
  expect(told).toEqual(["follow", "settle"]);
});

test("with Live, what was refused waits until the problem is gone", () => {
  const { told, problem, live } = stage({ upToDate: true });
  live.set(true);
  problem.value = "The reference crosses itself.";
  live.moving(1);
  expect(told).toEqual([]);
  problem.value = null;
  live.moving(2);
  expect(told).toEqual(["follow"]);
});

test("switched on, it begins with a match where there is none; switched off, it settles what followed", () => {
  const fresh = stage();
  fresh.live.set(true);
  expect(fresh.told).toEqual(["start"]);
  const empty = stage({ empty: true });
  empty.live.set(true);
  expect(empty.told).toEqual([]);
  const following = stage({ phase: "following", upToDate: true });
  following.live.set(false);
  expect(following.told).toEqual(["settle"]);
});
