// `npm run build:element`: the element and the anywidget as one file, element/thin-shell-match.js.

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { gzipSync } from "node:zlib";
import { bundledIn, crates, packages, STANDARD_LIBRARY, textOf } from "./lib/licences.mjs";
import { heading, main, root } from "./lib/process.mjs";
import { checkNode, ensurePackages } from "./lib/setup.mjs";
import { buildWasm } from "./wasm.mjs";

const OUT = join(root, "element");
const FILE = "thin-shell-match.js";
/** What the file carries. */
const CARRIED = ["@preact/signals", "preact"];

/** With the solver built already. */
export async function bundleElement(out = OUT) {
  // Not above: on a fresh clone there is no Vite before the packages are there.
  const { build } = await import("vite");
  /** @type {import("vite").Plugin} */
  const licences = {
    name: "thinshell-element",
    generateBundle(_, bundle) {
      const known = packages(CARRIED).map(({ name }) => name);
      const missing = bundledIn(bundle).filter((name) => !known.includes(name));
      if (missing.length > 0)
        this.error(`the element would carry ${missing.join(", ")} without a licence: name it here.`);
      const source = textOf([...packages(CARRIED), ...crates(), STANDARD_LIBRARY]);
      this.emitFile({ type: "asset", fileName: "licences.txt", source });
    },
  };
  /** @type {import("vite").Plugin} */
  const slim = {
    name: "thinshell-element-slim",
    enforce: "pre",
    // The worker is given the solver, and need not carry it once more; the element speaks English.
    transform: (code, id) =>
      id.endsWith("/wasm/thinshell.js") ? code.replace(/new URL\([^)]*import\.meta\.url\)/, "undefined") : null,
    resolveId: (source) => (source === "./de" ? "\0no-german" : null),
    load: (id) => (id === "\0no-german" ? "export const de = null" : null),
  };
  await build({
    root,
    configFile: false,
    logLevel: "warn",
    plugins: [licences, slim],
    worker: { format: "es", plugins: () => [slim] },
    build: {
      lib: { entry: "www/element/index.ts", formats: ["es"], fileName: () => FILE },
      outDir: out,
      emptyOutDir: true,
      copyPublicDir: false,
      target: "es2022",
      minify: true,
      // Everything in it: nothing is beside a notebook's module.
      assetsInlineLimit: Number.MAX_SAFE_INTEGER,
      rolldownOptions: { output: { codeSplitting: false } },
    },
  });
  return join(out, FILE);
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href)
  await main(async () => {
    checkNode();
    await ensurePackages();
    await buildWasm();
    heading("element");
    const file = await bundleElement();
    const bytes = readFileSync(file);
    console.log(
      `${file}: ${(bytes.length / 1000).toFixed(0)} kB, ${(gzipSync(bytes).length / 1000).toFixed(0)} kB compressed`,
    );
  });
