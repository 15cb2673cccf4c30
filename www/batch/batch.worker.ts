/** Matches target after target, away from the page. Ending the worker ends what it does. */

import init, { Registration } from "../wasm/thinshell.js";
import { type Matched, matched, type Plan } from "./match";
import type { Subject } from "./subject";

export type BatchRequest =
  | { readonly kind: "load"; readonly module: WebAssembly.Module }
  | { readonly kind: "match"; readonly plan: Plan; readonly target: Subject };

export type BatchReply =
  | { readonly kind: "level"; readonly level: number }
  | { readonly kind: "matched"; readonly match: Matched }
  | { readonly kind: "refused"; readonly message: string };

let loading: Promise<unknown> = Promise.resolve();

self.onmessage = async ({ data }: MessageEvent<BatchRequest>) => {
  if (data.kind === "load") {
    loading = init({ module_or_path: data.module });
    return;
  }
  try {
    await loading;
    let last = -1;
    const match = await matched({ Registration }, data.plan, data.target, ({ level }) => {
      if (level !== last) post({ kind: "level", level });
      last = level;
    });
    post({ kind: "matched", match });
  } catch (error) {
    // A solver that has failed is of no more use.
    if (error instanceof WebAssembly.RuntimeError) throw error;
    post({ kind: "refused", message: error instanceof Error ? error.message : String(error) });
  }
};

function post(reply: BatchReply): void {
  self.postMessage(reply);
}
