/** What the solver runs on: its compiled module and workers for it. */

import type { Settings } from "./protocol";
import { en } from "./words/en";

export type Engine = {
  /** The compiled solver, which all workers share: after the load nothing needs the network. */
  module(): Promise<WebAssembly.Module>;
  spawn(): Worker;
  /** The one that can compute on a graphics card, where the settings are such that it should; else nothing. */
  card?(settings: Partial<Settings>): Promise<Engine> | undefined;
};

/** Fetches and compiles the module when it is first asked for, and again after a failure. Rejects with a sentence. */
export function moduleAt(address: string): Engine["module"] {
  let module: Promise<WebAssembly.Module> | null = null;
  return () => {
    module ??= compiled(address).catch((problem) => {
      module = null;
      throw problem;
    });
    return module;
  };
}

async function compiled(address: string): Promise<WebAssembly.Module> {
  const answer = await fetch(address).catch(() => {
    throw new Error(en.solver.offline);
  });
  if (!answer.ok) throw new Error(en.solver.unanswered(answer.status));
  try {
    // While it arrives, and a browser may keep what it has compiled; where a server does not say what it sends, after that.
    const isNamed = answer.headers.get("Content-Type") === "application/wasm";
    return await (isNamed ? WebAssembly.compileStreaming(answer) : WebAssembly.compile(await answer.arrayBuffer()));
  } catch (problem) {
    const why = problem instanceof Error ? problem.message : String(problem);
    throw new Error(en.solver.untaken(why));
  }
}
