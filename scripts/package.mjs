// `npm run package`, and before every `npm pack`: what others install, in lib/. The modules are those of the page; under
// Node their `init()` reads the file beside them, which Node's fetch cannot.

import { copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { bundleElement } from "./element.mjs";
import { bundledIn, crates, packages, STANDARD_LIBRARY, textOf } from "./lib/licences.mjs";
import { main, root } from "./lib/process.mjs";
import { checkNode, ensurePackages } from "./lib/setup.mjs";
import { buildGpuWasm, buildSolidWasm, buildWasm } from "./wasm.mjs";

const OUT = join(root, "lib");

/** Which folder of the page becomes which of the package. */
const MODULES = [
  ["wasm", "."],
  ["wasm-solid", "solid"],
  ["wasm-gpu", "gpu"],
];

const FILES = ["thinshell.js", "thinshell.d.ts", "thinshell_bg.wasm", "settings.js", "settings.d.ts"];

/** What the command line carries. */
const CARRIED = ["@preact/signals", "clipper2-ts", "linkedom", "preact", "svgpath"];

const NODE = `import { readFileSync } from "node:fs";
import initialize, { initSync } from "./thinshell.js";
export * from "./thinshell.js";

export default async function init(source) {
  if (source !== undefined) return initialize(source);
  return initSync({ module: readFileSync(new URL("thinshell_bg.wasm", import.meta.url)) });
}
`;

export async function assemble() {
  await buildWasm();
  await buildSolidWasm();
  await buildGpuWasm();
  rmSync(OUT, { recursive: true, force: true });
  for (const [from, to] of MODULES) {
    mkdirSync(join(OUT, to), { recursive: true });
    for (const file of FILES) copyFileSync(join(root, "www", from, file), join(OUT, to, file));
    const types = join(OUT, to, "thinshell.d.ts");
    // The types say that a registration can be disposed of, a word that projects need not know.
    writeFileSync(types, `/// <reference lib="esnext.disposable" />\n${readFileSync(types, "utf8")}`);
    writeFileSync(join(OUT, to, "node.js"), NODE);
  }
  await bundleElement(join(OUT, "element"));
  const types = readFileSync(join(root, "www", "element", "thin-shell-match.d.ts"), "utf8");
  writeFileSync(join(OUT, "element", "thin-shell-match.d.ts"), types.replace("../wasm/", "../"));
  await bundleCommand();
  writeFileSync(join(OUT, "licences.txt"), textOf([...packages(CARRIED), ...crates(), STANDARD_LIBRARY]));
}

/** The command line as one file beside the solver. */
export async function bundleCommand() {
  // Not above: on a fresh clone there is no Vite before the packages are there.
  const { build } = await import("vite");
  /** @type {import("vite").Plugin} */
  const solver = {
    name: "thinshell-package",
    enforce: "pre",
    resolveId: (source) => (source.endsWith("/wasm/thinshell.js") ? { id: "./node.js", external: true } : null),
    generateBundle(_, bundle) {
      const known = packages(CARRIED).map(({ name }) => name);
      const missing = bundledIn(bundle).filter((name) => !known.includes(name));
      if (missing.length > 0)
        this.error(`the command would carry ${missing.join(", ")} without a licence: name it here.`);
    },
  };
  await build({
    root,
    configFile: false,
    logLevel: "warn",
    plugins: [solver],
    ssr: { noExternal: true },
    build: {
      ssr: "command/main.ts",
      outDir: OUT,
      emptyOutDir: false,
      copyPublicDir: false,
      target: "node20",
      minify: true,
      rolldownOptions: { output: { entryFileNames: "command.js", banner: "#!/usr/bin/env node" } },
    },
  });
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href)
  await main(async () => {
    checkNode();
    await ensurePackages();
    await assemble();
  });
