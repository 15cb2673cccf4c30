/** The page's side of the solver: starts and stops runs, drops late frames, replaces a worker that has crashed. */

import type { FrameReply, Reply, Request, Settings, Shape } from "./protocol";
import SolverWorker from "./worker?worker&inline";

export type SolverEvents = {
  frame(frame: FrameReply): void;
  refused(message: string): void;
  /** Nothing of the page's is lost, and the next start finds a fresh worker. */
  crashed(message: string): void;
  /** The solver could not be loaded; no start will succeed. */
  unavailable(message: string): void;
};

export class Solver {
  private readonly module: Promise<WebAssembly.Module>;
  private readonly events: SolverEvents;
  private worker: Worker;
  private run = 0;

  /** `module` is compiled once by the page and shared by every worker: after the load nothing needs the network. */
  constructor(module: Promise<WebAssembly.Module>, events: SolverEvents) {
    this.module = module;
    this.events = events;
    this.worker = this.spawn();
  }

  /** Ends the current run, if any, and starts another. Settings left out have their defaults. */
  start(reference: Shape, template: Shape, settings: Partial<Settings>): void {
    this.run += 1;
    this.send({ kind: "start", run: this.run, reference, template, settings });
  }

  /** Goes on from the match there is with other shapes and settings, all of them given; ends the current run. */
  update(reference: Shape, template: Shape, settings: Settings): void {
    this.run += 1;
    this.send({ kind: "update", run: this.run, reference, template, settings });
  }

  pause(): void {
    this.send({ kind: "pause", run: this.run });
  }

  resume(): void {
    this.send({ kind: "resume", run: this.run });
  }

  /** Frames of the run that are still on their way are dropped. */
  cancel(): void {
    this.send({ kind: "cancel", run: this.run });
    this.run += 1;
  }

  dispose(): void {
    this.worker.terminate();
  }

  private send(request: Request): void {
    this.worker.postMessage(request);
  }

  private spawn(): Worker {
    const worker = new SolverWorker({ name: "thinshell solver" });
    worker.onmessage = ({ data }: MessageEvent<Reply>) => this.receive(data);
    worker.onerror = (event) => {
      event.preventDefault();
      this.replace(event.message);
    };
    this.module.then(
      (module) => {
        // Messages sent before this one wait in the worker's loop until the module is there.
        if (this.worker === worker) worker.postMessage({ kind: "load", module } satisfies Request);
      },
      (problem) => this.events.unavailable(problem instanceof Error ? problem.message : String(problem)),
    );
    return worker;
  }

  private receive(reply: Reply): void {
    if (reply.kind === "crashed") this.replace(reply.message);
    else if (reply.run !== this.run) return;
    else if (reply.kind === "refused") this.events.refused(reply.message);
    else {
      this.send({ kind: "taken", run: this.run });
      this.events.frame(reply);
    }
  }

  private replace(message: string): void {
    this.worker.onmessage = null;
    this.worker.onerror = null;
    this.worker.terminate();
    this.run += 1;
    this.worker = this.spawn();
    this.events.crashed(message);
  }
}
