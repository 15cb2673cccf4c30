// `npm test`: every check, the cheap ones first, each closed by a line that counts. `npm test -- rust page` runs only
// the steps named.

import { once } from "node:events";
import { existsSync, readFileSync, rmSync } from "node:fs";
import { createServer } from "node:net";
import { join } from "node:path";
import { fuzz } from "./fuzz.mjs";
import { driverEnvironment, ensureChromium } from "./lib/chromium.mjs";
import { heading, main, Obstacle, root, run } from "./lib/process.mjs";
import { checkNode, ensureBindgen, ensurePackages, ensureRust } from "./lib/setup.mjs";
import { checkSize } from "./size.mjs";
import { buildGpuWasm, buildSolidWasm, buildWasm } from "./wasm.mjs";

/** @typedef {{ passed: number, failed: number, skipped?: number, retried?: number }} Count */

const WASM = ["--target", "wasm32-unknown-unknown"];
const SURFACES = ["--features", "surfaces"];
// With what computes on a graphics card; all else is the same code.
const GPU = ["--features", "gpu"];
const GPU_TARGETS = ["--test", "gpu*", "--bench", "card"];
const FUZZ_CASES = 2000;
// In a glob, so that a second file of browser tests needs no word here.
const BROWSER_TESTS = ["--test", "wasm*"];

/** @type {Record<string, { title: string, check: () => Promise<Count> }>} */
const STEPS = {
  style: {
    title: "style: rustfmt, clippy (native, wasm32), rustdoc, Biome",
    check: () =>
      all(
        () => succeeds("cargo", ["fmt", "--check"]),
        () => succeeds("cargo", ["clippy", "--locked", "--all-targets", "--", "-D", "warnings"]),
        () => succeeds("cargo", ["clippy", "--locked", ...GPU, "--lib", ...GPU_TARGETS, "--", "-D", "warnings"]),
        () =>
          succeeds("cargo", ["clippy", "--locked", ...WASM, ...GPU, "--lib", ...BROWSER_TESTS, "--", "-D", "warnings"]),
        () => succeeds("cargo", ["clippy", "--locked", ...WASM, "--lib", ...SURFACES, "--", "-D", "warnings"]),
        () => succeeds("cargo", ["doc", "--locked", "--no-deps", "--lib"], { RUSTDOCFLAGS: "-D warnings" }),
        () => succeeds(...program("@biomejs/biome/bin/biome", ["check", "--error-on-warnings"])),
      ),
  },
  rust: {
    title: "rust: the solver's tests",
    check: async () => {
      const test = ["test", "--locked", ...GPU, "--no-fail-fast"];
      // Without the examples: none holds a test, and that they compile is seen above.
      const own = await run("cargo", [...test, "--lib", "--tests"]);
      const docs = await run("cargo", [...test, "--doc"]);
      return cargoTests({ code: own.code || docs.code, text: own.text + docs.text });
    },
  },
  wasm: {
    title: "wasm: the solver in a worker of headless Chromium",
    check: async () => {
      const env = await driverEnvironment();
      await ensureBindgen();
      return cargoTests(await run("cargo", ["test", "--locked", ...WASM, ...GPU, ...BROWSER_TESTS], { env }));
    },
  },
  types: {
    title: "types: tsc",
    check: async () => {
      // The page's types come from Rust, so they have to be generated before they can be checked.
      await buildWasm();
      await buildSolidWasm();
      await buildGpuWasm();
      return all(() => succeeds(...program("typescript/bin/tsc", ["--noEmit"])));
    },
  },
  unit: {
    title: "unit: vitest",
    check: async () => {
      await buildWasm();
      await buildSolidWasm();
      await buildGpuWasm();
      const file = report("vitest.json");
      const reporters = ["--reporter=default", "--reporter=json", `--outputFile.json=${file}`];
      const { code } = await run(...program("vitest/vitest.mjs", ["run", ...reporters]));
      const result = read(file);
      return reconcile(code, { passed: result?.numPassedTests ?? 0, failed: result?.numFailedTests ?? 0 });
    },
  },
  fuzz: {
    title: "fuzz: the package under strange inputs and calls",
    check: async () => {
      await buildWasm();
      const { right, refused, defects } = await fuzz(FUZZ_CASES);
      return { passed: right + refused, failed: defects };
    },
  },
  package: {
    title: "package: what `npm pack` makes, in Node, in a page, in a worker and with Vite",
    check: async () => {
      await buildWasm();
      await buildSolidWasm();
      await buildGpuWasm();
      // Not above: on a fresh clone there is no browser's client before the packages are there.
      const { tryPackage } = await import("./tryPackage.mjs");
      return tryPackage();
    },
  },
  build: {
    title: "build: the page and its size budget",
    check: async () => {
      await buildWasm();
      await buildSolidWasm();
      await buildGpuWasm();
      return all(
        () => succeeds(...program("vite/bin/vite.js", ["build"])),
        async () => checkSize(),
      );
    },
  },
  page: {
    title: "page: Playwright on the built page",
    check: async () => {
      const file = report("playwright.json");
      const env = {
        CHROME_PATH: await ensureChromium(),
        PLAYWRIGHT_JSON_OUTPUT_FILE: file,
        THINSHELL_PORT: String(await freePort()),
      };
      const { code } = await run(...program("@playwright/test/cli.js", ["test", "--reporter=list,json"]), { env });
      const stats = read(file)?.stats;
      const retried = stats?.flaky ?? 0;
      return reconcile(code, { passed: (stats?.expected ?? 0) + retried, failed: stats?.unexpected ?? 0, retried });
    },
  },
  browsers: {
    title: "browsers: the page in Firefox and WebKitGTK, through WebDriver",
    check: async () => {
      // Not above: on a fresh clone there is no WebDriver client before the packages are there.
      const { checkBrowsers } = await import("./browsers.mjs");
      return checkBrowsers();
    },
  },
};

await main(async () => {
  const chosen = process.argv.slice(2);
  const unknown = chosen.find((name) => !(name in STEPS));
  if (unknown !== undefined)
    throw new Obstacle(`There is no step "${unknown}"; the steps are ${Object.keys(STEPS).join(", ")}.`);
  checkNode();
  await ensurePackages();
  await ensureRust({ lints: true });

  const sum = { passed: 0, failed: 0 };
  for (const [name, { title, check }] of Object.entries(STEPS)) {
    if (chosen.length > 0 && !chosen.includes(name)) continue;
    heading(title);
    /** @type {Count} */
    const count = await check().catch((error) => {
      if (!(error instanceof Obstacle)) throw error;
      console.error(error.message);
      return { passed: 0, failed: 1 };
    });
    // A step that ran nothing has shown nothing, unless it has said why.
    if (count.passed + count.failed === 0 && !count.skipped) count.failed = 1;
    const skipped = count.skipped ? `, ${count.skipped} skipped` : "";
    const retried = count.retried ? `, ${count.retried} of them at the second attempt` : "";
    console.log(`${name}: ${count.passed} passed${retried}, ${count.failed} failed${skipped}`);
    sum.passed += count.passed;
    sum.failed += count.failed;
    if (count.failed > 0) {
      process.exitCode = 1;
      break;
    }
  }
  console.log(`\n${sum.passed} passed, ${sum.failed} failed`);
});

/**
 * Makes every check, so that one run shows all there is to mend.
 *
 * @param {(() => Promise<boolean>)[]} checks
 * @returns {Promise<Count>}
 */
async function all(...checks) {
  const count = { passed: 0, failed: 0 };
  for (const check of checks) {
    if (await check()) count.passed++;
    else count.failed++;
  }
  return count;
}

/**
 * @param {string} command
 * @param {string[]} args
 * @param {Record<string, string>} [env]
 */
async function succeeds(command, args, env = {}) {
  return (await run(command, args, { env })).code === 0;
}

/**
 * A package's program, to be run through this very Node.
 *
 * @param {string} path below node_modules
 * @param {string[]} args
 * @returns {[string, string[]]}
 */
function program(path, args) {
  return [process.execPath, [join(root, "node_modules", path), ...args]];
}

/**
 * Sums up the results of the test programs that cargo has run.
 *
 * @param {{ code: number, text: string }} end
 */
function cargoTests({ code, text }) {
  const count = { passed: 0, failed: 0 };
  for (const [, passed, failed] of text.matchAll(/^test result: .*?(\d+) passed; (\d+) failed/gm)) {
    count.passed += Number(passed);
    count.failed += Number(failed);
  }
  const skipped = [...text.matchAll(/^skipped: /gm)].length;
  return reconcile(code, { ...count, passed: count.passed - skipped, skipped });
}

/**
 * A program that fails without a failed test (it did not compile, say) is a failure too.
 *
 * @param {number} code
 * @param {Count} count
 */
function reconcile(code, count) {
  return code !== 0 && count.failed === 0 ? { ...count, failed: 1 } : count;
}

/** A port that nobody listens on, so that two runs at once do not test each other's page. */
async function freePort() {
  const server = createServer().listen(0);
  await once(server, "listening");
  const address = server.address();
  server.close();
  if (address === null || typeof address === "string") throw new Error("a listening server has a port");
  return address.port;
}

/** @param {string} name */
function report(name) {
  const file = join(root, "target", name);
  rmSync(file, { force: true });
  return file;
}

/** @param {string} file */
function read(file) {
  return existsSync(file) ? JSON.parse(readFileSync(file, "utf8")) : null;
}
