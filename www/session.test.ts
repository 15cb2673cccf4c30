import { beforeEach, expect, test, vi } from "vitest";
import type { Reply, Request, Status } from "./protocol";
import { Session } from "./session";
import { FIELDS } from "./settings";
import { PRESETS } from "./shapes/presets";
import { open } from "./state";

/** A worker that notes what it is told, and answers a start by a finished frame when it is asked to. */
class Puppet {
  readonly told: Request[] = [];
  onmessage: ((event: { data: Reply }) => void) | null = null;
  onerror = null;

  postMessage(request: Request): void {
    this.told.push(request);
  }

  terminate(): void {}

  finish(): void {
    const start = this.told.findLast((request) => request.kind === "start");
    if (start?.kind !== "start") throw new Error("no run has been asked for");
    const status = { finished: true, level: 5, iteration: 1, mismatch: { max: 0.1, mean: 0 } } as Status;
    const curves = { reference: [], template: [], matched: [] };
    const deformation = new Float64Array(2);
    this.onmessage?.({ data: { kind: "frame", run: start.run, status, rest: null, deformation, curves, trail: [] } });
  }

  get starts(): Request[] {
    return this.told.filter(({ kind }) => kind === "start");
  }
}

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal("requestAnimationFrame", () => 1);
  vi.stubGlobal("cancelAnimationFrame", () => {});
  vi.stubGlobal("addEventListener", () => {});
  vi.stubGlobal("history", { replaceState: () => {} });
});

function stage(hash = "#v=1&preset=star&finest=5") {
  const puppet = new Puppet();
  const engine = {
    module: () => Promise.resolve({} as WebAssembly.Module),
    spawn: () => puppet as unknown as Worker,
  };
  return { puppet, session: new Session(engine, open(hash, null)) };
}

const BENDING = FIELDS.find(({ name }) => name === "bending");

test("a first look is taken at what a link shows, and none at nothing", () => {
  const { puppet, session } = stage();
  session.glance();
  expect(puppet.starts).toHaveLength(1);
  const empty = stage("#v=1&reference=&template=");
  empty.session.glance();
  expect(empty.puppet.starts).toHaveLength(0);
});

test("a link that leaves the match to a press starts nothing when it is opened over another", () => {
  const { puppet, session } = stage();
  session.openLink("#v=1&preset=leaf&match=later");
  expect(puppet.starts).toHaveLength(0);
  session.openLink("#v=1&preset=leaf");
  expect(puppet.starts).toHaveLength(1);
});

test("a shape that is taken away while it is matched ends the run without a complaint", () => {
  const { puppet, session } = stage();
  session.start();
  session.commitShape("template", []);
  expect(session.phase.value).toBe("idle");
  expect(session.problem.value).toBeNull();
  vi.advanceTimersByTime(1000);
  expect(puppet.starts).toHaveLength(1);
});

test("a term that is left out at the result is matched without at once", () => {
  const { puppet, session } = stage();
  if (!BENDING) throw new Error("bending is a setting of the page");
  session.start();
  puppet.finish();
  session.tryOut(BENDING, 0);
  expect(puppet.starts.at(-1)).toMatchObject({ settings: { bending: 0 } });
});

test("a finished run is kept, and shown again with its own shapes and settings", () => {
  const { puppet, session } = stage();
  if (!BENDING) throw new Error("bending is a setting of the page");
  session.start();
  puppet.finish();
  session.tryOut(BENDING, 0);
  puppet.finish();
  const [second, first] = session.runs.list.value;
  expect([first.settings.bending, second.settings.bending]).toEqual([undefined, 0]);
  const leaf = PRESETS.find(({ id }) => id === "leaf");
  if (!leaf) throw new Error("the leaf is an example");
  session.choosePreset(leaf);
  session.showAgain(first);
  expect(session.shapes.value.reference).toBe(first.reference);
  expect(session.settings.value).toEqual({ finest: 5 });
  expect([session.phase.value, session.stale.value]).toEqual(["restored", false]);
  session.undo();
  expect(session.shapes.value.reference).toBe(leaf.reference);
});

test("runs that only follow the hand are none to come back to", () => {
  const { puppet, session } = stage();
  session.setLive(true);
  puppet.finish();
  expect(session.runs.list.value).toHaveLength(0);
});
