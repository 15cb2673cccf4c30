/**
 * Runs one experiment and ends with it, in a worker. Experiments step the solver themselves, so they need it on their own
 * thread; the page for drawing goes through www/worker.ts instead.
 */

import type { Block, Size, Solver, Study } from "./experiment";

export type Request = { readonly module: WebAssembly.Module; readonly id: string; readonly size: Size };

export type Reply =
  | { readonly kind: "progress"; readonly done: number; readonly doing: string }
  | { readonly kind: "done"; readonly blocks: readonly Block[]; readonly millis: number }
  | { readonly kind: "failed"; readonly message: string };

/** Of a package: what starts it, and its door. */
type Package = {
  readonly init: (options: { module_or_path: WebAssembly.Module }) => Promise<unknown>;
  readonly solver: Solver;
};

export function serve(studies: readonly Study[], { init, solver }: Package): void {
  const run = async ({ module, id, size }: Request) => {
    const study = studies.find((candidate) => candidate.id === id);
    if (!study) throw new Error(`there is no experiment "${id}"`);
    await init({ module_or_path: module });
    const start = performance.now();
    const blocks = await study.run(
      {
        solver,
        millis: () => performance.now(),
        progress: (done, doing) => post({ kind: "progress", done, doing }),
      },
      size,
    );
    post({ kind: "done", blocks, millis: performance.now() - start });
  };
  self.onmessage = ({ data }: MessageEvent<Request>) => {
    run(data).catch((problem) => post({ kind: "failed", message: String(problem) }));
  };
  // A panic inside the solver's asynchronous part rejects no promise of ours, but arrives here.
  self.addEventListener("error", (event) => post({ kind: "failed", message: event.message }));
  self.addEventListener("unhandledrejection", (event) => post({ kind: "failed", message: String(event.reason) }));
}

function post(reply: Reply): void {
  self.postMessage(reply);
}
