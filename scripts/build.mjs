// `npm run build`: the page, ready for any static server, in dist/.

import { copyFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { bundleElement } from "./element.mjs";
import { heading, main, must, root } from "./lib/process.mjs";
import { checkNode, ensurePackages } from "./lib/setup.mjs";
import { buildGpuWasm, buildSolidWasm, buildWasm } from "./wasm.mjs";

export async function buildPage() {
  await buildWasm();
  await buildSolidWasm();
  await buildGpuWasm();
  heading("page");
  await must(process.execPath, [vite, "build"]);
  // For other pages and the demos: no part of the page, so it comes after the list of what is kept in the browser.
  copyFileSync(await bundleElement(), join(root, "dist", "demos", "thin-shell-match.js"));
}

/** Vite's command line, run through this very Node. */
export const vite = `${root}/node_modules/vite/bin/vite.js`;

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href)
  await main(async () => {
    checkNode();
    await ensurePackages();
    await buildPage();
  });
