import { afterEach, beforeEach, expect, test, vi } from "vitest";
import type { Engine } from "./engine";
import type { FrameReply, Settings } from "./protocol";
import { PATIENCE_MILLIS, Solver } from "./solver";
import { puppetEngine } from "./testing/puppet";

const NOTHING = { kind: "curves" as const, loops: [] };
const MODULE = {} as WebAssembly.Module;

function stage(module: () => Promise<WebAssembly.Module> = () => Promise.resolve(MODULE)) {
  const { engine, puppets } = puppetEngine(module);
  const heard: string[] = [];
  const solver = new Solver(engine, {
    ready: () => heard.push("ready"),
    frame: () => heard.push("frame"),
    refused: (message) => heard.push(`refused: ${message}`),
    crashed: (message) => heard.push(`crashed: ${message}`),
    unavailable: (message) => heard.push(`unavailable: ${message}`),
  });
  const start = () => solver.start({ kind: "curves", loops: [] }, { kind: "curves", loops: [] }, {});
  return { solver, puppets, heard, start };
}

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

test("a worker that cannot start is tried once, and once more for each press of Match", async () => {
  const { puppets, heard, start } = stage();
  puppets[0].break();
  await vi.advanceTimersByTimeAsync(60_000);
  expect(puppets).toHaveLength(1);
  expect(heard).toEqual([expect.stringMatching(/^unavailable: The solver could not be started.*worker-src blob:/)]);
  start();
  expect(puppets).toHaveLength(2);
  puppets[1].say({ kind: "crashed", message: "no memory" });
  await vi.advanceTimersByTimeAsync(60_000);
  expect(puppets).toHaveLength(2);
  expect(heard[1]).toContain("no memory");
  // When it is possible at last, it works.
  start();
  await vi.advanceTimersByTimeAsync(0);
  expect(puppets[2].told.map(({ kind }) => kind)).toEqual(["start", "load"]);
});

test("a browser without workers is said, not thrown", async () => {
  const heard: string[] = [];
  const spawn = () => {
    throw new Error("SecurityError");
  };
  const events = { ready() {}, frame() {}, refused() {}, crashed() {} };
  new Solver(
    { module: () => Promise.resolve(MODULE), spawn },
    { ...events, unavailable: (message) => heard.push(message) },
  );
  await vi.advanceTimersByTimeAsync(0);
  expect(heard).toHaveLength(1);
});

test("a solver that could not be loaded is asked for again by the next start", async () => {
  let offline = true;
  const { puppets, heard, start } = stage(() =>
    offline ? Promise.reject(new Error("offline")) : Promise.resolve(MODULE),
  );
  await vi.advanceTimersByTimeAsync(0);
  expect(heard).toEqual(["unavailable: offline"]);
  start();
  await vi.advanceTimersByTimeAsync(0);
  expect(heard).toEqual(["unavailable: offline", "unavailable: offline"]);
  offline = false;
  start();
  await vi.advanceTimersByTimeAsync(0);
  expect(puppets).toHaveLength(3);
  expect(puppets.map(({ ended }) => ended)).toEqual([true, true, false]);
  expect(puppets[2].told.map(({ kind }) => kind)).toEqual(["start", "load"]);
});

test("a worker that crashes after it has run is replaced at once", () => {
  const { puppets, heard } = stage();
  puppets[0].say({ kind: "ready" });
  puppets[0].break("unreachable");
  expect(puppets).toHaveLength(2);
  expect(heard).toEqual(["ready", "crashed: unreachable"]);
});

test("a worker that hears of the end lives on", async () => {
  const { solver, puppets, start } = stage();
  puppets[0].say({ kind: "ready" });
  start();
  const run = puppets[0].lastRun;
  puppets[0].say({ kind: "heard", run });
  solver.cancel();
  puppets[0].say({ kind: "heard", run });
  await vi.advanceTimersByTimeAsync(10 * PATIENCE_MILLIS);
  expect(puppets).toHaveLength(1);
});

test("a worker that does not let go is ended, and its late words are dropped", async () => {
  const { solver, puppets, heard, start } = stage();
  puppets[0].say({ kind: "ready" });
  start();
  puppets[0].say({ kind: "heard", run: puppets[0].lastRun });
  solver.cancel();
  await vi.advanceTimersByTimeAsync(PATIENCE_MILLIS);
  expect(puppets.map(({ ended }) => ended)).toEqual([true, false]);
  puppets[0].say({ kind: "frame", run: puppets[0].lastRun } as FrameReply);
  // Nothing was wanted any more: the fresh worker only loads.
  await vi.advanceTimersByTimeAsync(0);
  expect(puppets[1].told.map(({ kind }) => kind)).toEqual(["load"]);
  expect(heard).toEqual(["ready"]);
});

test("a start that is not taken up goes to a fresh worker", async () => {
  const { solver, puppets, heard, start } = stage();
  puppets[0].say({ kind: "ready" });
  start();
  puppets[0].say({ kind: "heard", run: puppets[0].lastRun });
  // Pressed in a row: the patience is counted from the first.
  start();
  await vi.advanceTimersByTimeAsync(PATIENCE_MILLIS / 2);
  solver.cancel();
  start();
  await vi.advanceTimersByTimeAsync(PATIENCE_MILLIS / 2);
  expect(puppets.map(({ ended }) => ended)).toEqual([true, false]);
  expect(puppets[1].told.map(({ kind }) => kind)).toEqual(["start", "load"]);
  puppets[1].say({ kind: "ready" });
  const run = puppets[1].lastRun;
  puppets[1].say({ kind: "heard", run });
  puppets[1].say({ kind: "frame", run } as FrameReply);
  expect(heard).toEqual(["ready", "ready", "frame"]);
});

test("a worker that is still loading is waited for until somebody cancels", async () => {
  const { solver, puppets, start } = stage();
  start();
  await vi.advanceTimersByTimeAsync(100 * PATIENCE_MILLIS);
  expect(puppets).toHaveLength(1);
  solver.cancel();
  await vi.advanceTimersByTimeAsync(100 * PATIENCE_MILLIS);
  expect(puppets.map(({ ended }) => ended)).toEqual([true, false]);
});

test("a run that a graphics card may compute goes to the other engine's worker, and the next one back", async () => {
  const [first, card] = [puppetEngine(), puppetEngine()];
  const engine = {
    ...first.engine,
    card: ({ backend }: Partial<Settings>) => (backend === "gpu" ? Promise.resolve(card.engine) : undefined),
  };
  const solver = new Solver(engine, { ready() {}, frame() {}, refused() {}, crashed() {}, unavailable() {} });
  const start = (backend: Settings["backend"]) => solver.start(NOTHING, NOTHING, { backend });
  start("gpu");
  solver.pause();
  await vi.advanceTimersByTimeAsync(0);
  expect(first.puppets.map(({ ended }) => ended)).toEqual([true]);
  expect(first.puppets[0].starts).toEqual([]);
  expect(card.puppets[0].told.map(({ kind }) => kind)).toEqual(["start", "pause", "load"]);
  start("gpu");
  await vi.advanceTimersByTimeAsync(0);
  expect(card.puppets).toHaveLength(1);
  start("cpu");
  await vi.advanceTimersByTimeAsync(0);
  expect(card.puppets[0].ended).toBe(true);
  expect(first.puppets[1].told.map(({ kind }) => kind)).toEqual(["start", "load"]);
});

test("who changes his mind while the other engine comes is not given it", async () => {
  const [first, card] = [puppetEngine(), puppetEngine()];
  let come: (engine: Engine) => void = () => {};
  const coming = new Promise<Engine>((resolve) => {
    come = resolve;
  });
  const engine = {
    ...first.engine,
    card: ({ backend }: Partial<Settings>) => (backend === "gpu" ? coming : undefined),
  };
  const solver = new Solver(engine, { ready() {}, frame() {}, refused() {}, crashed() {}, unavailable() {} });
  solver.start(NOTHING, NOTHING, { backend: "gpu" });
  solver.cancel();
  solver.start(NOTHING, NOTHING, {});
  come(card.engine);
  await vi.advanceTimersByTimeAsync(0);
  expect(card.puppets).toEqual([]);
  expect(first.puppets.at(-1)?.starts).toHaveLength(1);
});

test("an engine that does not come is a refusal", async () => {
  const { engine } = puppetEngine();
  const heard: string[] = [];
  const events = { ready() {}, frame() {}, crashed() {}, unavailable() {} };
  const card = () => Promise.reject(new Error("it could not be loaded"));
  const solver = new Solver({ ...engine, card }, { ...events, refused: (why) => heard.push(why) });
  solver.start(NOTHING, NOTHING, { backend: "gpu" });
  await vi.advanceTimersByTimeAsync(0);
  expect(heard).toEqual(["it could not be loaded"]);
});
