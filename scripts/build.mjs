// `npm run build`: the page, ready for any static server, in dist/.

import { pathToFileURL } from "node:url";
import { heading, main, must, root } from "./lib/process.mjs";
import { checkNode, ensurePackages } from "./lib/setup.mjs";
import { buildSolidWasm, buildWasm } from "./wasm.mjs";

export async function buildPage() {
  await buildWasm();
  await buildSolidWasm();
  heading("page");
  await must(process.execPath, [vite, "build"]);
}

/** Vite's command line, run through this very Node. */
export const vite = `${root}/node_modules/vite/bin/vite.js`;

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href)
  await main(async () => {
    checkNode();
    await ensurePackages();
    await buildPage();
  });
