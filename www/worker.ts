/**
 * The solver's thread. Steps until a frame's time has passed, posts what there is to see, lets the message queue run,
 * and goes on. The only importer of the wasm package; formulas and policies live in the solver.
 */

import type { Inspection, Iteration, Reply, Request, Status } from "./protocol";
import { isKept, kept } from "./trail";
import { identity } from "./view/identity";
import init, { inspect, Registration } from "./wasm/thinshell.js";

/** Solving between two looks at the message queue. */
const CHUNK_MILLIS = 30;
/** The same after an update: somebody's hand may already be further. */
const FOLLOWING_MILLIS = 2;

type Start = Extract<Request, { kind: "start" }>;
type Update = Extract<Request, { kind: "update" }>;
type Inquiry = Extract<Request, { kind: "inspect" }>;

/** What the page wants now. Messages only write here; the loop alone touches the solver. */
const wanted = {
  module: null as WebAssembly.Module | null,
  start: null as Start | null,
  /** The newest only: it stands for all before it. */
  update: null as Update | null,
  /** The newest, too. */
  inquiry: null as Inquiry | null,
  /** The run that is to end. */
  cancelled: null as number | null,
  paused: false,
};
let lastFrameTaken = true;
let wake: () => void = () => {};

self.onmessage = ({ data }: MessageEvent<Request>) => {
  const current = wanted.update?.run ?? wanted.start?.run ?? running.run;
  if (data.kind === "load") wanted.module = data.module;
  else if (data.kind === "inspect") wanted.inquiry = data;
  else if (data.kind === "start") {
    wanted.start = data;
    wanted.update = null;
    wanted.paused = false;
    wanted.cancelled = null;
  } else if (data.kind === "update") {
    wanted.update = data;
    wanted.paused = false;
  } else if (data.kind === "cancel") {
    wanted.start = null;
    wanted.update = null;
    wanted.cancelled = data.run;
  } else if (data.run !== current) return;
  else if (data.kind === "taken") lastFrameTaken = true;
  else wanted.paused = data.kind === "pause";
  wake();
};

const running = {
  run: -1,
  registration: null as Registration | null,
  finished: false,
  /** Whether this run goes on from another. */
  updated: false,
  iterations: 0,
  /** Iterations that no frame has shown yet. */
  trail: [] as Iteration[],
  /** The energies of the identity, of the last level that was asked. */
  rest: null as { readonly level: number; readonly energies: Status["energies"] } | null,
};

async function loop(): Promise<never> {
  while (!wanted.module) await asleep();
  await init({ module_or_path: wanted.module });
  post({ kind: "ready" });
  for (;;) {
    if (wanted.cancelled !== null) {
      drop();
      post({ kind: "heard", run: wanted.cancelled });
      wanted.cancelled = null;
    }
    if (wanted.start) await begin(wanted.start);
    if (wanted.update) await change(wanted.update);
    if (wanted.inquiry) answer(wanted.inquiry);
    if (!running.registration || running.finished || wanted.paused) await asleep();
    else {
      try {
        await solve(running.registration);
      } catch (problem) {
        drop();
        refuse(running.run, problem);
      }
      await queue();
    }
  }
}

async function begin(start: Start): Promise<void> {
  wanted.start = null;
  drop();
  post({ kind: "heard", run: start.run });
  running.run = start.run;
  running.finished = false;
  running.updated = false;
  running.trail = [];
  running.iterations = 0;
  running.rest = null;
  lastFrameTaken = true;
  try {
    running.registration = await Registration.create(start.reference, start.template, start.settings);
  } catch (problem) {
    refuse(start.run, problem);
  }
}

/** Takes a few milliseconds. */
function answer({ inquiry, reference, template, settings }: Inquiry): void {
  wanted.inquiry = null;
  let inspection: Inspection | null = null;
  try {
    inspection = inspect(reference, template, settings);
  } catch (problem) {
    if (problem instanceof WebAssembly.RuntimeError) throw problem;
  }
  post({ kind: "inspected", inquiry, inspection });
}

/** A refused update leaves the registration as it was; there is nothing to go on with until the next. */
async function change({ run, reference, template, settings }: Update): Promise<void> {
  wanted.update = null;
  running.run = run;
  running.trail = [];
  lastFrameTaken = true;
  try {
    if (!running.registration) throw new Error("There is no match to go on from; press Match.");
    await running.registration.update({ reference, template, settings });
    running.finished = false;
    running.updated = true;
  } catch (problem) {
    running.finished = true;
    refuse(run, problem);
  }
}

function refuse(run: number, problem: unknown): void {
  if (problem instanceof WebAssembly.RuntimeError) throw problem;
  post({ kind: "refused", run, message: problem instanceof Error ? problem.message : String(problem) });
}

function drop(): void {
  running.registration?.free();
  running.registration = null;
}

async function solve(registration: Registration): Promise<void> {
  const until = performance.now() + (running.updated ? FOLLOWING_MILLIS : CHUNK_MILLIS);
  let status: Status;
  do {
    status = await registration.step(1);
    const { level, iteration } = status;
    const picture =
      running.updated || !isKept(running.iterations) ? {} : { kept: kept(registration.deformation(), level) };
    running.iterations += 1;
    running.trail.push({ ...status.energies, level, iteration, ...picture });
  } while (!status.finished && performance.now() < until);
  running.finished = status.finished;
  // The last frame carries the result, so it always goes out.
  if (!lastFrameTaken && !status.finished) return;
  const deformation = registration.deformation();
  const curves = registration.curves();
  const rest = restOf(registration, status.level);
  const { trail } = running;
  running.trail = [];
  lastFrameTaken = false;
  post({ kind: "frame", run: running.run, status, rest, deformation, curves, trail }, [
    deformation.buffer as ArrayBuffer,
    ...[...curves.reference, ...curves.template, ...curves.matched].map((curve) => curve.buffer as ArrayBuffer),
    ...trail.flatMap((one) => (one.kept ? [one.kept.buffer as ArrayBuffer] : [])),
  ]);
}

/** Once a level; while the match goes after a hand, what was known before is near enough. */
function restOf(registration: Registration, level: number): Status["energies"] | null {
  if (running.rest?.level !== level && !running.updated) {
    const nodes = identity(2 ** level);
    running.rest = { level, energies: registration.evaluate(nodes).energies };
  }
  return running.rest?.level === level ? running.rest.energies : null;
}

function post(reply: Reply, transfer: Transferable[] = []): void {
  self.postMessage(reply, { transfer });
}

function asleep(): Promise<void> {
  return new Promise((resolve) => {
    wake = resolve;
  });
}

const channel = new MessageChannel();
let turn: () => void = () => {};
channel.port1.onmessage = () => turn();

/** Resolves after the messages that are waiting. A timer would cost four milliseconds a turn. */
function queue(): Promise<void> {
  return new Promise((resolve) => {
    turn = resolve;
    channel.port2.postMessage(null);
  });
}

// A panic inside the solver's asynchronous part rejects no promise of ours, but arrives here.
self.addEventListener("error", (event) => post({ kind: "crashed", message: event.message }));
self.addEventListener("unhandledrejection", (event) => post({ kind: "crashed", message: String(event.reason) }));
loop().catch((problem) => post({ kind: "crashed", message: String(problem) }));
