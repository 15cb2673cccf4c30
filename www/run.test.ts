import { signal } from "@preact/signals";
import { beforeAll, expect, test, vi } from "vitest";
import { Run } from "./run";
import type { Chosen } from "./settings";
import type { Shapes } from "./shapes/pins";
import { puppetEngine } from "./testing/puppet";

beforeAll(() => {
  vi.stubGlobal("requestAnimationFrame", () => 1);
  vi.stubGlobal("cancelAnimationFrame", () => {});
});

const SQUARE = [Float64Array.of(0.4, 0.4, 0.6, 0.4, 0.6, 0.6, 0.4, 0.6)];
const OTHER = [Float64Array.of(0.3, 0.4, 0.6, 0.4, 0.6, 0.6, 0.4, 0.6)];

function stage() {
  const { engine, puppets } = puppetEngine();
  const shapes = signal<Shapes>({ reference: SQUARE, template: SQUARE, pins: [] });
  const settings = signal<Chosen>({ bending: 0.5 });
  const said: (string | null)[] = [];
  const subject = { shapes, settings, followsHand: () => false, say: (what: string | null) => said.push(what) };
  const run = new Run(engine, subject);
  return { puppet: puppets[0], shapes, settings, said, run };
}

test("a result carries the shapes and settings that it was computed from", () => {
  const { puppet, shapes, settings, run } = stage();
  run.start();
  puppet.frame(true);
  settings.value = { bending: 0 };
  expect(run.result.value).toMatchObject({ ...shapes.value, settings: { bending: 0.5 } });
});

test("a setting that differs makes the result stale, and one set back makes it fresh again", () => {
  const { puppet, settings, run } = stage();
  run.start();
  puppet.frame(true);
  expect([run.stale.value, run.upToDate]).toEqual([false, true]);
  settings.value = { bending: 0 };
  expect([run.stale.value, run.upToDate]).toEqual([true, false]);
  settings.value = { bending: 0.5 };
  expect([run.stale.value, run.upToDate]).toEqual([false, true]);
});

test("other pins make the result stale, and the solver is told of them", () => {
  const { puppet, shapes, run } = stage();
  const before = shapes.value;
  run.start();
  puppet.frame(true);
  shapes.value = { ...before, pins: [] };
  expect(run.outdated.value).toBeNull();
  shapes.value = { ...before, pins: [{ reference: { x: 0.5, y: 0.4 }, template: { x: 0.6, y: 0.5 } }] };
  expect([run.outdated.value, run.upToDate]).toEqual(["pins", false]);
  run.start();
  expect(puppet.told.at(-1)).toMatchObject({ kind: "start", settings: { pins: Float64Array.of(0.5, 0.4, 0.6, 0.5) } });
  puppet.frame(true);
  expect(run.outdated.value).toBeNull();
  shapes.value = before;
  run.settle();
  expect(puppet.told.at(-1)).toMatchObject({ kind: "update", settings: { pins: new Float64Array(0) } });
});

test("a shape that differs takes the result away, and undone it is there again", () => {
  const { puppet, shapes, run } = stage();
  const before = shapes.value;
  run.start();
  puppet.frame(true);
  shapes.value = { ...before, template: OTHER };
  expect(run.result.value).toBeNull();
  shapes.value = { ...before };
  expect(run.result.value).not.toBeNull();
});

test("until a new run has a frame, the old picture keeps its own inputs", () => {
  const { puppet, shapes, settings, run } = stage();
  run.start();
  puppet.frame(true);
  shapes.value = { reference: OTHER, template: OTHER, pins: [] };
  settings.value = { bending: 2 };
  run.start();
  expect(run.result.value).toMatchObject({ reference: SQUARE, settings: { bending: 0.5 } });
  puppet.frame(false);
  expect(run.result.value).toMatchObject({ reference: OTHER, settings: { bending: 2 } });
});

test("what follows the hand on a coarse grid is not taken for a result of the finest", () => {
  const { puppet, settings, run } = stage();
  settings.value = { finest: 7 };
  run.start();
  puppet.frame(true);
  run.settle();
  expect(run.phase.value).toBe("refining");
  puppet.frame(true);
  expect([run.phase.value, run.stale.value]).toEqual(["matched", false]);
});

test("a first look is at a quick grid, and goes on by itself to the finest", () => {
  const { puppet, settings, run } = stage();
  settings.value = { finest: 9 };
  run.glance();
  expect(puppet.told.at(-1)).toMatchObject({ kind: "start", settings: { finest: 7 } });
  puppet.frame(true);
  expect(run.phase.value).toBe("refining");
  expect(puppet.told.at(-1)).toMatchObject({ kind: "update", settings: { finest: 9 } });
  puppet.frame(true);
  expect([run.phase.value, run.stale.value]).toEqual(["matched", false]);
});

test("a first look at a grid that is quick is all there is to do", () => {
  const { puppet, run } = stage();
  run.glance();
  puppet.frame(true);
  expect([run.phase.value, run.stale.value, puppet.starts.length]).toEqual(["matched", false, 1]);
});

test("a run that was paused while a setting changed begins anew", () => {
  const { puppet, settings, run } = stage();
  run.start();
  puppet.frame(false);
  run.pause();
  run.resume();
  expect(puppet.starts).toHaveLength(1);
  run.pause();
  settings.value = { bending: 0 };
  expect(run.stale.value).toBe(true);
  run.resume();
  expect(puppet.starts).toHaveLength(2);
});
