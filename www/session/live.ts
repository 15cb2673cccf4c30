/** What a change does to the run: with Live the match goes after it, without it a run under way begins anew. */

import { type ReadonlySignal, signal } from "@preact/signals";
import { isFollowing, isPaused } from "../phase";
import type { Run } from "../run";
import type { Shapes } from "../shapes/pins";

type Runner = Pick<Run, "phase" | "established" | "upToDate" | "start" | "drop" | "follow" | "settle" | "restartSoon">;

export class Live {
  private readonly run: Runner;
  private readonly shapes: ReadonlySignal<Shapes>;
  private readonly problem: ReadonlySignal<string | null>;

  /** Whether the match follows the hand. */
  readonly on = signal(false);

  constructor(run: Runner, shapes: ReadonlySignal<Shapes>, problem: ReadonlySignal<string | null>) {
    this.run = run;
    this.shapes = shapes;
    this.problem = problem;
  }

  /** Nothing can be matched with nothing. */
  get empty(): boolean {
    const { reference, template } = this.shapes.value;
    return reference.length === 0 || template.length === 0;
  }

  /** Switching on begins with a full match, unless there is one to go on from. */
  set(on: boolean): void {
    this.on.value = on;
    if (!on && isFollowing(this.run.phase.value)) this.settle();
    if (!on || this.empty || this.run.upToDate) return;
    this.run.start();
  }

  /**
   * Something moves under the hand, since the event of this time. To be called before the page is drawn anew: then the
   * solver works while the page draws. What has just been refused waits until the problem is gone.
   */
  moving(at: number): void {
    if (this.on.value && (this.run.established || !this.problem.value)) this.run.follow(at);
  }

  /** What moved has moved: without Live that is a change like any other. */
  moved(what: "shapes" | "settings"): void {
    if (!this.on.value) this.changed(what);
  }

  /** A step has been done or undone. */
  changed(what: "shapes" | "settings"): void {
    if (this.on.value) this.settle();
    else if (what === "shapes" && (this.empty || isPaused(this.run.phase.value))) this.run.drop();
    else this.run.restartSoon();
  }

  private settle(): void {
    if (this.empty) this.run.drop();
    else this.run.settle();
  }
}
