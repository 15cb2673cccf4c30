/**
 * The page's side of the solver: starts and stops runs, drops late frames, and replaces a worker that has crashed or
 * does not let go of what it is doing.
 */

import type { Engine } from "./engine";
import type { AnyFrame, FrameReply, Inspection, Reply, Request, Settings, Shape } from "./protocol";
import { en } from "./words/en";

export type SolverEvents<Frame extends AnyFrame = FrameReply> = {
  /** The worker has the solver. */
  ready(): void;
  frame(frame: Frame): void;
  refused(message: string): void;
  /** The answer to the last inquiry. */
  inspected?(inspection: Inspection | null): void;
  /** Nothing of the page's is lost, and the next start finds a fresh worker. */
  crashed(message: string): void;
  /** The solver could not be loaded or no worker started; the next start tries again. */
  unavailable(message: string): void;
};

/** How long a worker may go on with what it was doing after it has been told to do something else. */
export const PATIENCE_MILLIS = 400;

export class Solver<Frame extends AnyFrame = FrameReply> {
  private readonly first: Engine;
  /** What the worker is of: the first, or the one with a graphics card. */
  private engine: Engine;
  private readonly events: SolverEvents<Frame>;
  /** None after a start that has failed: the next run tries again, so that tries never outnumber the user's. */
  private worker: Worker | null = null;
  /** The worker has the solver: it can run here. */
  private ready = false;
  private run = 0;
  private inquiry = 0;
  /** The start that the worker has not taken up yet. */
  private waiting: Request | null = null;
  /** Whether the worker has yet to turn from an older run to a start or a cancel. */
  private unheard = false;
  /** Of the run; a start that waits for its engine is told when it goes out. */
  private paused = false;
  private patience: ReturnType<typeof setTimeout> | undefined;

  constructor(engine: Engine, events: SolverEvents<Frame>) {
    this.first = engine;
    this.engine = engine;
    this.events = events;
    this.spawn();
  }

  /** Ends the current run, if any, and starts another. Settings left out have their defaults. */
  start(reference: Shape, template: Shape, settings: Partial<Settings>): void {
    this.run += 1;
    this.paused = false;
    const request: Request = { kind: "start", run: this.run, reference, template, settings };
    const card = this.first.card?.(settings);
    if (!card) this.turnTo(this.first, request);
    else
      card.then(
        (engine) => request.run === this.run && this.turnTo(engine, request),
        (problem: Error) => request.run === this.run && this.events.refused(problem.message),
      );
  }

  /** A worker of another engine gives way. */
  private turnTo(engine: Engine, request: Request): void {
    if (engine !== this.engine) this.end();
    this.engine = engine;
    this.waiting = request;
    if (!this.worker) this.spawn();
    this.turn(request);
    if (this.paused) this.pause();
  }

  /** Goes on from the match there is with other shapes and settings, all of them given; ends the current run. */
  update(reference: Shape, template: Shape, settings: Partial<Settings>): void {
    this.run += 1;
    this.send({ kind: "update", run: this.run, reference, template, settings });
  }

  /** Asks whether the finest grid resolves two shapes. A worker that is replaced meanwhile gives no answer. */
  inspect(reference: Shape, template: Shape, settings: Partial<Settings>): void {
    this.inquiry += 1;
    this.send({ kind: "inspect", inquiry: this.inquiry, reference, template, settings });
  }

  pause(): void {
    this.paused = true;
    this.send({ kind: "pause", run: this.run });
  }

  resume(): void {
    this.paused = false;
    this.send({ kind: "resume", run: this.run });
  }

  /** Whatever the worker is doing comes to an end; frames of the run that are still on their way are dropped. */
  cancel(): void {
    this.waiting = null;
    if (this.ready) this.turn({ kind: "cancel", run: this.run });
    else if (this.worker) {
      // Whatever keeps it from being ready, another one costs nothing.
      this.end();
      this.spawn();
    }
    this.run += 1;
  }

  dispose(): void {
    this.end();
  }

  private send(request: Request): void {
    this.worker?.postMessage(request);
  }

  /** Sends what the worker is to turn to at once, or else be replaced. */
  private turn(request: Request): void {
    this.send(request);
    this.unheard = true;
    this.wait();
  }

  /** A worker that is still loading is not to blame. */
  private wait(): void {
    if (!this.ready || this.patience !== undefined) return;
    this.patience = setTimeout(() => {
      const { waiting } = this;
      this.end();
      this.spawn();
      if (waiting) this.turn(waiting);
    }, PATIENCE_MILLIS);
  }

  private heard(): void {
    clearTimeout(this.patience);
    this.patience = undefined;
    this.unheard = false;
    this.waiting = null;
  }

  private spawn(): void {
    let worker: Worker;
    try {
      worker = this.engine.spawn();
    } catch {
      // Not at once: whoever makes a solver is not yet ready to hear of it.
      queueMicrotask(() => this.events.unavailable(en.solver.refused));
      return;
    }
    this.worker = worker;
    worker.onmessage = ({ data }: MessageEvent<Reply<Frame>>) => this.receive(data);
    worker.onerror = (event) => {
      event.preventDefault();
      this.lost(event.message);
    };
    this.engine.module().then(
      (module) => {
        // Messages sent before this one wait in the worker's loop until the module is there.
        if (this.worker === worker) this.send({ kind: "load", module });
      },
      (problem) => {
        if (this.worker === worker) this.fail(problem instanceof Error ? problem.message : String(problem));
      },
    );
  }

  private receive(reply: Reply<Frame>): void {
    if (reply.kind === "crashed") this.lost(reply.message);
    else if (reply.kind === "ready") {
      this.ready = true;
      if (this.unheard) this.wait();
      this.events.ready();
    } else if (reply.kind === "heard") {
      // A cancel is heard under the number of its run, which has passed by then.
      if (reply.run === this.run || (reply.run === this.run - 1 && !this.waiting)) this.heard();
    } else if (reply.kind === "inspected") {
      if (reply.inquiry === this.inquiry) this.events.inspected?.(reply.inspection);
    } else if (reply.run !== this.run) return;
    else if (reply.kind === "refused") this.events.refused(reply.message);
    else {
      this.send({ kind: "taken", run: this.run });
      this.events.frame(reply);
    }
  }

  /** A worker that ran the solver gets a successor; one that never did would get an endless row of them. */
  private lost(message: string): void {
    if (!this.ready) {
      this.fail(message ? `${en.solver.refused} (${message})` : en.solver.refused);
      return;
    }
    this.end();
    this.run += 1;
    this.spawn();
    this.events.crashed(message);
  }

  private fail(message: string): void {
    this.end();
    this.run += 1;
    this.events.unavailable(message);
  }

  private end(): void {
    if (this.worker) {
      this.worker.onmessage = null;
      this.worker.onerror = null;
      this.worker.terminate();
    }
    this.worker = null;
    this.ready = false;
    this.heard();
  }
}
