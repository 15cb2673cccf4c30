/** The page's side of a batch: a worker for it, begun again where it has failed. */

import type { BatchReply, BatchRequest } from "./batch.worker";
import BatchWorker from "./batch.worker?worker&inline";
import type { Matched, Plan } from "./match";
import type { Subject } from "./subject";

export class Matcher {
  private worker: Worker | null = null;

  constructor(private readonly module: WebAssembly.Module) {}

  /** Rejects with a sentence where there is no match, or with the signal's reason. */
  match(plan: Plan, target: Subject, onLevel: (level: number) => void, signal: AbortSignal): Promise<Matched> {
    const worker = this.worker ?? this.spawn();
    return new Promise((resolve, reject) => {
      const end = (problem: unknown) => {
        this.stop();
        reject(problem);
      };
      if (signal.aborted) return end(signal.reason);
      signal.addEventListener("abort", () => end(signal.reason), { once: true });
      worker.onmessage = ({ data }: MessageEvent<BatchReply>) => {
        if (data.kind === "level") onLevel(data.level);
        else if (data.kind === "matched") resolve(data.match);
        else reject(new Error(data.message));
      };
      worker.onerror = (event) => {
        event.preventDefault();
        end(new Error(event.message));
      };
      worker.postMessage({ kind: "match", plan, target } satisfies BatchRequest);
    });
  }

  stop(): void {
    this.worker?.terminate();
    this.worker = null;
  }

  private spawn(): Worker {
    const worker = new BatchWorker({ name: "thinshell batch" });
    worker.postMessage({ kind: "load", module: this.module } satisfies BatchRequest);
    this.worker = worker;
    return worker;
  }
}
