// `npm run fuzz -- 20000 [seed] [first]`: the package under thousands of strange inputs and calls. Every case must end in
// a right answer or a clear refusal; anything else is a defect, printed with what brings it back.

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { isMainThread, parentPort, Worker, workerData } from "node:worker_threads";
import { runCase } from "./fuzz/cases.mjs";
import { main, root } from "./lib/process.mjs";

/** Most cases take milliseconds, some on the finest grids half a minute; one that takes this long does not end. */
const HANG_MILLIS = 300_000;

/** @typedef {{ right: number, refused: number, defects: number }} Tally */

/**
 * @param {number} cases @param {number} [seed] @param {number} [first]
 * @returns {Promise<Tally>}
 */
export async function fuzz(cases, seed = 1, first = 0) {
  const tally = { right: 0, refused: 0, defects: 0 };
  let next = first;
  // A broken module is thrown away with its worker.
  while (next < first + cases) next = await work(next, first + cases, seed, tally);
  console.log(`fuzz: ${tally.right} right, ${tally.refused} clearly refused, ${tally.defects} defects (seed ${seed})`);
  return tally;
}

/** @param {number} from @param {number} to @param {number} seed @param {Tally} tally @returns {Promise<number>} */
function work(from, to, seed, tally) {
  return new Promise((resolve) => {
    const worker = new Worker(new URL(import.meta.url), { workerData: { from, to, seed } });
    let current = from;
    /** @type {NodeJS.Timeout} */
    let watchdog;
    const end = (/** @type {number} */ next) => {
      clearTimeout(watchdog);
      worker.terminate().then(() => resolve(next));
    };
    const defect = (/** @type {string} */ what) => {
      tally.defects++;
      console.error(`case ${current} (npm run fuzz -- 1 ${seed} ${current}): ${what}`);
    };
    const watch = () => {
      clearTimeout(watchdog);
      watchdog = setTimeout(() => {
        defect("does not end");
        end(current + 1);
      }, HANG_MILLIS);
    };
    watch();
    worker.on("message", ({ index, verdict }) => {
      watch();
      if (verdict.outcome === "defect") defect(`${verdict.defects.join("\n  ")}\n  after ${verdict.story.join(", ")}`);
      else tally[/** @type {"right" | "refused"} */ (verdict.outcome)]++;
      current = index + 1;
      if (current === to) end(to);
      else if (verdict.defects.some((/** @type {string} */ each) => /RuntimeError|pending/.test(each))) end(current);
    });
    worker.on("error", (problem) => {
      defect(`breaks the engine: ${problem.stack ?? problem}`);
      end(current + 1);
    });
  });
}

async function runCases() {
  const { initSync, Registration } = await import(pathToFileURL(join(root, "www", "wasm", "thinshell.js")).href);
  initSync({ module: readFileSync(join(root, "www", "wasm", "thinshell_bg.wasm")) });
  const { from, to, seed } = workerData;
  for (let index = from; index < to; index++)
    parentPort?.postMessage({ index, verdict: await runCase(Registration, seed * 1_000_003 + index) });
}

if (!isMainThread) await runCases();
else if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href)
  await main(async () => {
    const [cases = 2000, seed = 1, first = 0] = process.argv.slice(2).map(Number);
    const { defects } = await fuzz(cases, seed, first);
    if (defects > 0) process.exitCode = 1;
  });
