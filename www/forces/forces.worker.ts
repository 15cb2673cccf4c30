/** Computes one match's forces and ends. */

import init, { Registration } from "../wasm/thinshell.js";
import { forcesOf, type Job } from "./terms";

self.onmessage = async ({ data }: MessageEvent<Job & { readonly module: WebAssembly.Module }>) => {
  try {
    await init({ module_or_path: data.module });
    self.postMessage({ forces: await forcesOf(Registration, data) });
  } catch (problem) {
    self.postMessage({ problem: problem instanceof Error ? problem.message : String(problem) });
  }
};
