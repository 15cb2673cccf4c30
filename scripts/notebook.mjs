// `npm run notebook`: the widget where notebooks are read, each in a headless browser; prints what they say. `npm run
// notebook -- marimo` runs only what is named of `jupyter marimo myst`. Nothing waits for a time: cells, kernels and matches
// tell when they are done.

import { pathToFileURL } from "node:url";
import { bundleElement } from "./element.mjs";
import { heading, main, Obstacle } from "./lib/process.mjs";
import { checkNode, ensurePackages } from "./lib/setup.mjs";
import { inCopy } from "./notebook/front.mjs";
import { jupyter } from "./notebook/jupyter.mjs";
import { marimo } from "./notebook/marimo.mjs";
import { myst } from "./notebook/myst.mjs";
import { buildWasm } from "./wasm.mjs";

/** @type {Record<string, { title: string, run: (place: import("./notebook/front.mjs").Place) => Promise<void> }>} */
const PLACES = {
  jupyter: { title: "JupyterLab: shapes go in, the report and φ at points come back, cell by cell", run: jupyter },
  marimo: { title: "marimo: a report computes cells anew, and a cell matches anew", run: marimo },
  myst: { title: "MyST: the directive, read by mystmd and shown by its theme's renderer", run: myst },
};

/** @param {readonly string[]} chosen */
async function notebooks(chosen) {
  const unknown = chosen.find((name) => !(name in PLACES));
  if (unknown !== undefined)
    throw new Obstacle(`There is no notebook in "${unknown}"; there are ${Object.keys(PLACES).join(", ")}.`);
  await bundleElement();
  for (const [name, { title, run }] of Object.entries(PLACES)) {
    if (chosen.length > 0 && !chosen.includes(name)) continue;
    heading(title);
    await inCopy(run);
  }
  console.log("\nThe notebooks have said what they should.");
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href)
  await main(async () => {
    checkNode();
    await ensurePackages();
    await buildWasm();
    await notebooks(process.argv.slice(2));
  });
