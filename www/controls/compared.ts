/** Two settings on the same shapes, solved one after the other in a worker of their own. */

import { signal } from "@preact/signals";
import type { Engine } from "../engine";
import type { FrameReply } from "../protocol";
import type { Chosen } from "../settings";
import { flat, type Shapes } from "../shapes/pins";
import { Solver } from "../solver";
import { en } from "../words/en";
import { later } from "../words/later";

export type Job = Shapes & { readonly settings: Chosen };

export type Outcome = Job & {
  readonly frame: FrameReply;
  /** From the start to the last frame. */
  readonly millis?: number;
};

export class Comparison {
  private readonly solver: Solver;
  private waiting: { readonly job: Job; readonly side: 0 | 1 }[] = [];
  private begun = 0;

  readonly outcomes = signal<readonly [Outcome | null, Outcome | null]>([null, null]);
  readonly busy = signal(false);

  constructor(engine: Engine, fail: (message: string) => void) {
    const failed = (message: string) => {
      this.stop();
      fail(en.solver.words(message));
    };
    this.solver = new Solver(engine, {
      ready: () => {},
      frame: (frame) => this.receive(frame),
      refused: failed,
      unavailable: failed,
      crashed: (message) => failed(later.compare.stopped(message)),
    });
  }

  /** One after the other: side by side they would slow each other down, and their times mean nothing. */
  run(jobs: readonly [Job, Job]): void {
    this.outcomes.value = [null, null];
    this.waiting = [
      { job: jobs[0], side: 0 },
      { job: jobs[1], side: 1 },
    ];
    this.busy.value = true;
    this.next();
  }

  /** What is there already stays. */
  stop(): void {
    this.waiting = [];
    this.busy.value = false;
    this.solver.cancel();
  }

  pause(): void {
    this.solver.pause();
  }

  resume(): void {
    this.solver.resume();
  }

  dispose(): void {
    this.solver.dispose();
  }

  private next(): void {
    const [first] = this.waiting;
    if (!first) {
      this.busy.value = false;
      return;
    }
    const { reference, template, pins, settings } = first.job;
    this.begun = performance.now();
    this.solver.start(
      { kind: "curves", loops: [...reference] },
      { kind: "curves", loops: [...template] },
      { ...settings, pins: flat(pins) },
    );
  }

  private receive(frame: FrameReply): void {
    const [first, ...others] = this.waiting;
    if (!first || !frame.status.finished) return;
    const outcome = { ...first.job, frame, millis: performance.now() - this.begun };
    const [a, b] = this.outcomes.value;
    this.outcomes.value = first.side === 0 ? [outcome, b] : [a, outcome];
    this.waiting = others;
    this.next();
  }
}
