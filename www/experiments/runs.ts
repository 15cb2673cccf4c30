/** The page's runs: one at a time, each in a worker of its own, so that cancelling is ending the worker. */

import { type Signal, signal } from "@preact/signals";
import type { Engine } from "../engine";
import type { Block, Size } from "./experiment";
import type { Reply, Request } from "./serve";

export type Run =
  | { readonly kind: "idle" }
  | { readonly kind: "running"; readonly size: Size; readonly done: number; readonly doing: string }
  | { readonly kind: "done"; readonly size: Size; readonly blocks: readonly Block[]; readonly millis: number }
  | { readonly kind: "failed"; readonly message: string };

export class Runs {
  /** The experiment that is being computed. */
  readonly current = signal<string | null>(null);
  private readonly runs = new Map<string, Signal<Run>>();
  private end: () => void = () => {};

  of(id: string): Signal<Run> {
    const known = this.runs.get(id);
    if (known) return known;
    const fresh = signal<Run>({ kind: "idle" });
    this.runs.set(id, fresh);
    return fresh;
  }

  /** Ends what is being computed, if anything, and computes this one. */
  async start(id: string, size: Size, engine: Engine): Promise<void> {
    this.cancel();
    const run = this.of(id);
    this.current.value = id;
    run.value = { kind: "running", size, done: 0, doing: "starting" };
    let cancelled = false;
    const worker = engine.spawn();
    const finish = (state: Run) => {
      worker.terminate();
      this.end = () => {};
      this.current.value = null;
      run.value = state;
    };
    this.end = () => {
      cancelled = true;
      finish({ kind: "idle" });
    };
    worker.onmessage = ({ data }: MessageEvent<Reply>) => {
      if (data.kind === "progress") run.value = { kind: "running", size, done: data.done, doing: data.doing };
      else if (data.kind === "done") finish({ kind: "done", size, blocks: data.blocks, millis: data.millis });
      else finish({ kind: "failed", message: data.message });
    };
    worker.onerror = (event) =>
      finish({ kind: "failed", message: event.message || "the browser refuses the page's worker" });
    try {
      const request: Request = { module: await engine.module(), id, size };
      if (!cancelled) worker.postMessage(request);
    } catch (problem) {
      if (!cancelled) finish({ kind: "failed", message: problem instanceof Error ? problem.message : String(problem) });
    }
  }

  cancel(): void {
    this.end();
  }
}
