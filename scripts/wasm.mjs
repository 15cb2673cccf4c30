// `npm run build:wasm`: the crate as www/wasm/{thinshell.js, thinshell.d.ts, thinshell_bg.wasm}.

import { createHash } from "node:crypto";
import { existsSync, mkdirSync, readdirSync, readFileSync, renameSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { withShortImports } from "./lib/imports.mjs";
import { heading, main, must, root } from "./lib/process.mjs";
import { OFFERED_TYPES, offeredModule, settingsModule, settingsTypes } from "./lib/settings.mjs";
import { checkNode, ensureBindgen, ensurePackages, ensureRust } from "./lib/setup.mjs";

// What every browser with SIMD has and what rustc takes for granted on this target, plus SIMD itself. wasm-opt refuses
// a module that uses anything else, and must not itself use anything else: `--all-features` makes modules that
// browsers refuse.
const FEATURES = [
  "--enable-bulk-memory",
  "--enable-bulk-memory-opt",
  "--enable-call-indirect-overlong",
  "--enable-multivalue",
  "--enable-mutable-globals",
  "--enable-nontrapping-float-to-int",
  "--enable-reference-types",
  "--enable-sign-ext",
  "--enable-simd",
];

// Loops whose numbers of rounds are known only when they run are not unrolled, and functions are inlined only where they
// are small or say so themselves, as the kernels do: a match takes as long, and the module is 7 kB smaller, compressed.
// Nor are loops vectorised that do not say so: 5 kB less for 4 % of a match.
const CODE = [
  "-Cno-vectorize-loops",
  "-Cllvm-args=-unroll-runtime=false",
  "-Cllvm-args=-unroll-allow-partial=false",
  "-Cllvm-args=-inline-threshold=50",
];

/** Builds the solver for the page; with nothing changed it takes a fraction of a second. */
export async function buildWasm() {
  await packageWasm("thinshell", "thinshell", join(root, "www", "wasm"), writeSettings);
  // Types are checked without waiting for the other packages: their names are the same.
  for (const other of ["wasm-solid", "wasm-gpu"]) {
    const types = join(root, "www", other, "thinshell.d.ts");
    if (existsSync(types)) continue;
    mkdirSync(dirname(types), { recursive: true });
    writeFileSync(types, 'export * from "../wasm/thinshell.js";\n');
  }
}

/** Builds the solver with surfaces: the same names, loaded on demand. */
export async function buildSolidWasm() {
  await packageWasm("thinshell", "thinshell", join(root, "www", "wasm-solid"), writeSettings, [
    "--features",
    "surfaces",
  ]);
}

/** Builds the solver that can compute on a graphics card, curves and surfaces: the same names, loaded on demand. */
export async function buildGpuWasm() {
  await packageWasm("thinshell", "thinshell", join(root, "www", "wasm-gpu"), writeSettings, [
    "--features",
    "surfaces,gpu",
  ]);
}

/** Builds the kernels of `npm run bench`, a module of their own. */
export async function buildBenchWasm() {
  await packageWasm("thinshell-bench", "bench", join(root, "target", "bench-wasm"));
}

/**
 * The settings as plain data and as a type, for those who need them without the solver.
 * @param {string} folder with the package
 */
async function writeSettings(folder) {
  const { initSync, describeSettings } = await import(pathToFileURL(join(folder, "thinshell.js")).href);
  initSync({ module: readFileSync(join(folder, "thinshell_bg.wasm")) });
  const settings = describeSettings();
  writeFileSync(join(folder, "settings.js"), settingsModule(settings));
  writeFileSync(join(folder, "settings.d.ts"), settingsTypes(settings));
  writeFileSync(join(folder, "offered.js"), offeredModule(settings));
  writeFileSync(join(folder, "offered.d.ts"), OFFERED_TYPES);
}

/**
 * Compiles a crate of the workspace and packages it as `{name}.js`, `{name}.d.ts` and `{name}_bg.wasm`.
 * @param {string} crate @param {string} name @param {string} out
 * @param {(folder: string) => Promise<void>} [complete] adds to the package
 * @param {string[]} [options] cargo's
 */
async function packageWasm(crate, name, out, complete, options = []) {
  await ensureRust();
  const bindgen = await ensureBindgen();
  const wanted = ["--target", "wasm32-unknown-unknown", "--lib", "--package", crate, ...options];
  await must("cargo", ["rustc", "--release", "--locked", ...wanted, "--", ...CODE]);

  const target = resolve(root, process.env.CARGO_TARGET_DIR ?? "target");
  const compiled = join(target, "wasm32-unknown-unknown", "release", `${crate.replace("-", "_")}.wasm`);
  const stamp = join(out, ".stamp");
  const key = createHash("sha256")
    .update(readFileSync(compiled))
    .update(readFileSync(new URL(import.meta.url)))
    .update(readFileSync(new URL("./lib/settings.mjs", import.meta.url)))
    .update(readFileSync(new URL("./lib/imports.mjs", import.meta.url)))
    .update(readFileSync(join(root, "Cargo.lock")))
    .digest("hex");
  if (existsSync(stamp) && readFileSync(stamp, "utf8") === key) return;

  heading("wasm-bindgen and wasm-opt");
  // Made beside the old files and moved over them, so that whoever reads them never sees half a package.
  const fresh = join(root, "target", `wasm-package-${process.pid}`);
  await must(bindgen, ["--target", "web", "--out-dir", fresh, "--out-name", name, compiled]);
  const module = join(fresh, `${name}_bg.wasm`);
  const before = readFileSync(module).length;
  const optimizer = join(root, "node_modules", "binaryen", "bin", "wasm-opt");
  await must(process.execPath, [optimizer, "-O3", ...FEATURES, module, "-o", module]);
  const glue = join(fresh, `${name}.js`);
  const short = withShortImports(readFileSync(module), readFileSync(glue, "utf8"));
  writeFileSync(module, short.module);
  writeFileSync(glue, short.glue);
  console.log(
    `${name}_bg.wasm: ${kilobytes(before)} from wasm-bindgen, ${kilobytes(readFileSync(module).length)} after wasm-opt`,
  );

  await complete?.(fresh);
  mkdirSync(out, { recursive: true });
  rmSync(stamp, { force: true });
  for (const file of readdirSync(fresh)) renameSync(join(fresh, file), join(out, file));
  rmSync(fresh, { recursive: true });
  writeFileSync(stamp, key);
}

/** @param {number} bytes */
function kilobytes(bytes) {
  return `${(bytes / 1000).toFixed(1)} kB`;
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href)
  await main(async () => {
    checkNode();
    await ensurePackages();
    const build = process.argv.includes("--gpu")
      ? buildGpuWasm
      : process.argv.includes("--solid")
        ? buildSolidWasm
        : buildWasm;
    await build();
  });
