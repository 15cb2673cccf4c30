import { expect, test, vi } from "vitest";
import { puppetEngine } from "../testing/puppet";
import { surface } from "./gallery";
import { type SolidFrame, SpaceSession } from "./session";
import { SPACE_FIELDS } from "./settings";
import type { Solid } from "./solid";

function made(id: string): Solid {
  const solid = surface(id);
  if (!solid) throw new Error(`no ${id}`);
  return solid;
}

const STEP = { reference: made("sphere"), template: made("ellipsoid"), pins: [], settings: {} };

function begun() {
  const { engine, puppets } = puppetEngine();
  const session = new SpaceSession(engine, STEP);
  const [puppet] = puppets;
  const frame = (finished: boolean) => {
    const status = { finished, level: 5, iteration: 1 };
    const picture = { matched: made("ellipsoid").positions, deformation: new Float64Array(3), partners: null };
    const all = {
      kind: "frame",
      run: puppet.lastRun,
      rest: null,
      trail: [],
      status,
      ...picture,
    } as unknown as SolidFrame;
    puppet.say(all as never);
  };
  return { session, puppet, frame };
}

function field(name: string) {
  const found = SPACE_FIELDS.find((candidate) => candidate.name === name);
  if (!found) throw new Error(`no ${name}`);
  return found;
}

test("both surfaces go to the solver as meshes, and the end of the run is the match", () => {
  const { session, puppet, frame } = begun();
  session.start();
  const [start] = puppet.starts;
  expect(start).toMatchObject({ reference: { kind: "mesh" }, template: { kind: "mesh" }, settings: {} });
  expect(session.phase.value).toBe("preparing");
  frame(false);
  expect(session.phase.value).toBe("solving");
  frame(true);
  expect(session.phase.value).toBe("matched");
  expect(session.result.value?.template).toBe(STEP.template);
});

test("other settings make the match stale, other surfaces take it away, and undo brings both back", () => {
  const { session, frame } = begun();
  session.start();
  frame(true);
  session.changeSetting(field("finest"), 4);
  expect(session.stale.value).toBe(true);
  session.undo();
  expect(session.stale.value).toBe(false);
  session.commit({ template: made("cube") });
  expect(session.result.value).toBeNull();
  session.undo();
  expect(session.result.value).not.toBeNull();
  expect(session.canRedo.value).toBe(true);
});

test("the default of the finest level is 5, and choosing it changes nothing", () => {
  const { session } = begun();
  session.changeSetting(field("finest"), 5);
  expect(session.canUndo.value).toBe(false);
  expect(field("finest").initial).toBe(5);
});

test("a pause stops, what is chosen meanwhile starts anew, and a cancel ends", () => {
  const { session, puppet, frame } = begun();
  session.start();
  frame(false);
  session.pause();
  expect(puppet.told.at(-1)?.kind).toBe("pause");
  session.resume();
  expect(puppet.told.at(-1)?.kind).toBe("resume");
  session.pause();
  session.commit({ template: made("cube") });
  session.resume();
  expect(puppet.starts).toHaveLength(2);
  session.cancel();
  expect(session.phase.value).toBe("cancelled");
  expect(session.result.value).toBeNull();
});

test("two presses, one on each surface, are a pin, which can be undone; other surfaces take it away", () => {
  const { session, puppet, frame } = begun();
  session.start();
  frame(true);
  session.setPin("template", [0.5, 0.7, 0.5]);
  expect(session.step.value.pins).toEqual([]);
  // Another press on the same side is another place for the same end.
  session.setPin("template", [0.5, 0.3, 0.5]);
  session.setPin("reference", [0.74, 0.5, 0.5]);
  const pin = { reference: [0.74, 0.5, 0.5], template: [0.5, 0.3, 0.5] };
  expect(session.step.value.pins).toEqual([pin]);
  expect(session.begun.value).toBeNull();
  expect(session.stale.value).toBe(true);
  session.start();
  const pins = Float64Array.of(0.74, 0.5, 0.5, 0.5, 0.3, 0.5);
  expect(puppet.starts.at(-1)).toMatchObject({ settings: { pins } });
  session.undo();
  expect(session.step.value.pins).toEqual([]);
  session.redo();
  session.commit({ template: made("cube") });
  expect(session.step.value.pins).toEqual([]);
  session.undo();
  expect(session.step.value.pins).toEqual([pin]);
});

test("with Live a match begins with every change, a moment later, and none while it is off or paused", () => {
  vi.useFakeTimers();
  const { session, puppet, frame } = begun();
  session.setLive(true);
  expect(puppet.starts).toHaveLength(1);
  frame(true);
  session.changeSetting(field("membrane"), 3);
  session.changeSetting(field("membrane"), 2);
  expect(puppet.starts).toHaveLength(1);
  vi.runAllTimers();
  expect(puppet.starts).toHaveLength(2);
  expect(puppet.starts.at(-1)).toMatchObject({ settings: { membrane: 2 } });
  frame(true);
  session.undo();
  vi.runAllTimers();
  expect(puppet.starts).toHaveLength(3);
  frame(false);
  session.pause();
  session.commit({ template: made("cube") });
  vi.runAllTimers();
  expect(puppet.starts).toHaveLength(3);
  session.cancel();
  session.setLive(false);
  session.commit({ template: made("ellipsoid") });
  vi.runAllTimers();
  expect(puppet.starts).toHaveLength(3);
  vi.useRealTimers();
});

test("switching Live on begins nothing where there is a match of what is chosen", () => {
  const { session, puppet, frame } = begun();
  session.start();
  frame(true);
  session.setLive(true);
  expect(puppet.starts).toHaveLength(1);
});

test("a refusal is said as a sentence and ends the run", () => {
  const { session, puppet } = begun();
  session.start();
  puppet.refuse("the reference is open: 3 edges belong to one triangle only");
  expect(session.problem.value).toBe("The reference is open: 3 edges belong to one triangle only.");
  expect(session.phase.value).toBe("idle");
});
