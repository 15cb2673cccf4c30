/**
 * The loop of the solver's thread. Steps until a frame's time has passed, posts what there is to see, lets the message
 * queue run, and goes on. Which package solves, and what there is to see, is told by whoever starts it.
 */

import type { AnyFrame, Inspection, Iteration, Reply, Request, Status } from "./protocol";
import { isKept } from "./trail";
import type * as Package from "./wasm/thinshell.js";

type Registration = Package.Registration;

export type Kit<Picture extends object> = {
  readonly solver: Pick<typeof Package, "default" | "inspect" | "Registration">;
  /** What a frame shows, and the buffers that are handed over with it. */
  picture(
    registration: Registration,
    shapes: Pick<Start, "reference" | "template">,
    finished: boolean,
  ): readonly [Picture, readonly ArrayBufferLike[]];
  /** φ of an iteration, to be looked at again. */
  kept?(registration: Registration, level: number): Float32Array;
  /** The energies of a level's identity. */
  rest?(registration: Registration, level: number): Status["energies"];
};

/** Solving between two looks at the message queue. */
const CHUNK_MILLIS = 30;
/** The same after an update: somebody's hand may already be further. */
const FOLLOWING_MILLIS = 2;
/** How long an inquiry lets a match go first, which most finish within it. */
const YIELDING_MILLIS = 500;

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
  answerBy: 0,
  /** The run that is to end. */
  cancelled: null as number | null,
  paused: false,
};
let lastFrameTaken = true;
let wake: () => void = () => {};

function hear({ data }: MessageEvent<Request>): void {
  const current = wanted.update?.run ?? wanted.start?.run ?? running.run;
  if (data.kind === "load") wanted.module = data.module;
  else if (data.kind === "inspect") {
    wanted.inquiry = data;
    wanted.answerBy = performance.now() + YIELDING_MILLIS;
  } else if (data.kind === "start") {
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
}

const running = {
  run: -1,
  /** As they were last accepted. */
  shapes: null as Pick<Start, "reference" | "template"> | null,
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

async function loop<Picture extends object>(kit: Kit<Picture>): Promise<never> {
  while (!wanted.module) await asleep();
  await kit.solver.default({ module_or_path: wanted.module });
  post({ kind: "ready" });
  for (;;) {
    if (wanted.cancelled !== null) {
      drop();
      post({ kind: "heard", run: wanted.cancelled });
      wanted.cancelled = null;
    }
    if (wanted.start) await begin(kit, wanted.start);
    if (wanted.update) await change(wanted.update);
    const matching = running.finished || wanted.paused ? null : running.registration;
    if (wanted.inquiry && (!matching || performance.now() > wanted.answerBy)) answer(kit, wanted.inquiry);
    if (!matching) await asleep();
    else {
      try {
        await solve(kit, matching);
      } catch (problem) {
        drop();
        refuse(running.run, problem);
      }
      await queue();
    }
  }
}

async function begin({ solver }: Kit<object>, start: Start): Promise<void> {
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
    running.registration = await solver.Registration.create(start.reference, start.template, start.settings);
    running.shapes = start;
  } catch (problem) {
    refuse(start.run, problem);
  }
}

/** Takes a few milliseconds. */
function answer({ solver }: Kit<object>, { inquiry, reference, template, settings }: Inquiry): void {
  wanted.inquiry = null;
  let inspection: Inspection | null = null;
  try {
    inspection = solver.inspect(reference, template, settings);
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
    running.shapes = { reference, template };
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

async function solve<Picture extends object>(kit: Kit<Picture>, registration: Registration): Promise<void> {
  const until = performance.now() + (running.updated ? FOLLOWING_MILLIS : CHUNK_MILLIS);
  let status: Status;
  do {
    status = await registration.step(1);
    const { level, iteration } = status;
    const kept = running.updated || !isKept(running.iterations) ? undefined : kit.kept?.(registration, level);
    running.iterations += 1;
    running.trail.push({ ...status.energies, level, iteration, ...(kept && { kept }) });
  } while (!status.finished && performance.now() < until);
  running.finished = status.finished;
  // The last frame carries the result, so it always goes out.
  if (!lastFrameTaken && !status.finished) return;
  const { run, shapes, trail } = running;
  if (!shapes) throw new Error("a registration that steps has been made of shapes");
  const [picture, buffers] = kit.picture(registration, shapes, status.finished);
  const rest = restOf(kit, registration, status.level);
  running.trail = [];
  lastFrameTaken = false;
  post<Picture & AnyFrame>({ kind: "frame", run, status, rest, trail, ...picture }, [
    ...(buffers as ArrayBuffer[]),
    ...trail.flatMap((one) => (one.kept ? [one.kept.buffer as ArrayBuffer] : [])),
  ]);
}

/** Once a level; while the match goes after a hand, what was known before is near enough. */
function restOf(kit: Kit<object>, registration: Registration, level: number): Status["energies"] | null {
  if (running.rest?.level !== level && !running.updated && kit.rest)
    running.rest = { level, energies: kit.rest(registration, level) };
  return running.rest?.level === level ? running.rest.energies : null;
}

function post<Frame extends AnyFrame = AnyFrame>(reply: Reply<Frame>, transfer: Transferable[] = []): void {
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

/** To be called once, at the start of the worker. */
export function pump<Picture extends object>(kit: Kit<Picture>): void {
  self.onmessage = hear;
  // A panic inside the solver's asynchronous part rejects no promise of ours, but arrives here.
  self.addEventListener("error", (event) => post({ kind: "crashed", message: event.message }));
  self.addEventListener("unhandledrejection", (event) => post({ kind: "crashed", message: String(event.reason) }));
  loop(kit).catch((problem) => post({ kind: "crashed", message: String(problem) }));
}
