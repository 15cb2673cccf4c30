// `npm run bench`: the kernels of `cargo bench` as the browser runs them. Serves benches/page/index.html, opens it in
// headless Chromium and prints what the page has put into `window.__bench`:
//
//   { rows: { name: string, [figure: string]: number | string }[] }    once all is measured, or
//   { error: string }                                                  where it could not be.
//
// The table is for people; the line after it is the same as JSON. `npm run bench -- --json` prints only that.
//
// `npm run bench -- gpu` prints what a Newton iteration asks of a graphics card, which is the same on all of them, and the
// operations of its kernels; `npm run bench -- gpu 65` also an iteration on 65³ nodes.

import { existsSync } from "node:fs";
import { join } from "node:path";
import { chromiumFlags, ensureChromium } from "./lib/chromium.mjs";
import { main, Obstacle, root, run } from "./lib/process.mjs";
import { checkNode, ensurePackages, ensureRust } from "./lib/setup.mjs";
import { buildBenchWasm } from "./wasm.mjs";

const PAGE = "benches/page/index.html";
const PATIENCE_MINUTES = 15;

await main(async () => {
  checkNode();
  if (process.argv.includes("gpu")) {
    await ensureRust();
    const { code } = await run("cargo", [
      "bench",
      "--locked",
      "--quiet",
      "--profile",
      "dev",
      "--features",
      "gpu",
      "--bench",
      "card",
      "--",
      ...process.argv.slice(2),
    ]);
    process.exitCode = code;
    return;
  }
  await ensurePackages();
  if (!existsSync(join(root, PAGE))) throw new Obstacle(`There is no ${PAGE}: restore it from the repository.`);
  await buildBenchWasm();
  const executablePath = await ensureChromium();
  const { createServer } = await import("vite");
  const { chromium } = await import("@playwright/test");

  // No reload under the measurement when a file changes.
  const server = await createServer({ root, logLevel: "warn", server: { port: 4200, hmr: false, watch: null } });
  const browser = await chromium.launch({ executablePath, args: chromiumFlags() });
  try {
    await server.listen();
    const page = await browser.newPage();
    const failed = new Promise((_, reject) => {
      page.on("pageerror", (error) => reject(new Obstacle(`The benchmark page failed: ${error.message}`)));
    });
    await page.goto(`${server.resolvedUrls?.local[0]}${PAGE}`);
    const measured = page.waitForFunction(() => Reflect.get(window, "__bench"), null, {
      timeout: PATIENCE_MINUTES * 60_000,
    });
    const result = await Promise.race([measured.then((handle) => handle.jsonValue()), failed]);
    if (result.error !== undefined) throw new Obstacle(`The benchmark could not be made: ${result.error}`);
    if (!process.argv.includes("--json")) console.table(result.rows);
    console.log(JSON.stringify({ browser: browser.version(), rows: result.rows }));
  } finally {
    await browser.close();
    await server.close();
  }
});
