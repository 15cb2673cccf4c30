/** The solver, inlined: whoever has this module has everything, wherever the file came from. */

import type { Engine } from "../engine";
import wasm from "../wasm/thinshell_bg.wasm?url";
import SolverWorker from "../worker?worker&inline";

/** One for all elements of a page. */
let module: Promise<WebAssembly.Module> | null = null;

export function engine(): Engine {
  return {
    module: () => {
      module ??= WebAssembly.compile(bytesOf(wasm));
      return module;
    },
    spawn: () => new SolverWorker({ name: "thinshell solver" }),
  };
}

/** Of a data: address, which a page's policy may not let anybody fetch. */
function bytesOf(address: string): Uint8Array<ArrayBuffer> {
  const binary = atob(address.slice(address.indexOf(",") + 1));
  return Uint8Array.from(binary, (letter) => letter.charCodeAt(0));
}
