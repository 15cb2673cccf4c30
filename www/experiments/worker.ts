/**
 * Runs one experiment and ends with it. Experiments step the solver themselves, so they need it on their own thread;
 * the page for drawing goes through www/worker.ts instead.
 */

import init, { Registration } from "../wasm/thinshell.js";
import type { Block, Size } from "./experiment";
import { EXPERIMENTS } from "./index";

export type Request = { readonly module: WebAssembly.Module; readonly id: string; readonly size: Size };

export type Reply =
  | { readonly kind: "progress"; readonly done: number; readonly doing: string }
  | { readonly kind: "done"; readonly blocks: readonly Block[]; readonly millis: number }
  | { readonly kind: "failed"; readonly message: string };

self.onmessage = ({ data }: MessageEvent<Request>) => {
  run(data).catch((problem) => post({ kind: "failed", message: String(problem) }));
};

// A panic inside the solver's asynchronous part rejects no promise of ours, but arrives here.
self.addEventListener("error", (event) => post({ kind: "failed", message: event.message }));
self.addEventListener("unhandledrejection", (event) => post({ kind: "failed", message: String(event.reason) }));

async function run({ module, id, size }: Request): Promise<void> {
  const experiment = EXPERIMENTS.find((experiment) => experiment.id === id);
  if (!experiment) throw new Error(`there is no experiment "${id}"`);
  await init({ module_or_path: module });
  const start = performance.now();
  const blocks = await experiment.run(
    {
      solver: Registration,
      millis: () => performance.now(),
      progress: (done, doing) => post({ kind: "progress", done, doing }),
    },
    size,
  );
  post({ kind: "done", blocks, millis: performance.now() - start });
}

function post(reply: Reply): void {
  self.postMessage(reply);
}
