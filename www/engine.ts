/** What the solver runs on: its compiled module and workers for it. */

export type Engine = {
  /** The compiled solver, which all workers share: after the load nothing needs the network. */
  module(): Promise<WebAssembly.Module>;
  spawn(): Worker;
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
    throw new Error("the solver could not be loaded; check the connection, then try again or reload the page");
  });
  if (!answer.ok) throw new Error(`the solver could not be loaded (${answer.status}); reload the page`);
  try {
    return await WebAssembly.compile(await answer.arrayBuffer());
  } catch (problem) {
    const why = problem instanceof Error ? problem.message : String(problem);
    throw new Error(
      `the solver could not be loaded, since this browser does not take its WebAssembly (${why}); use a current Firefox, Chrome or Safari, and let the page's security policy allow 'wasm-unsafe-eval'`,
    );
  }
}
