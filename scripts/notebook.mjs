// `npm run notebook`: runs examples/notebook/thinshell.ipynb in JupyterLab, in a headless browser, cell by cell as a
// reader would, and prints what the cells say. Needs `pip install jupyterlab anywidget`; JUPYTER names a `jupyter` that is
// not on the path.

import { spawn } from "node:child_process";
import { once } from "node:events";
import { cpSync, mkdtempSync, rmSync } from "node:fs";
import { createServer } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { bundleElement } from "./element.mjs";
import { chromiumFlags, ensureChromium } from "./lib/chromium.mjs";
import { main, Obstacle, root } from "./lib/process.mjs";
import { checkNode, ensurePackages } from "./lib/setup.mjs";
import { buildWasm } from "./wasm.mjs";

const START_MILLIS = 180_000;
const MATCH_MILLIS = 90_000;

/** Of the cells, in their order: what the reader waits for before the next one. */
const MATCHED = 'thin-shell-match [role="img"]';

async function freePort() {
  const server = createServer().listen(0);
  await once(server, "listening");
  const address = server.address();
  server.close();
  if (address === null || typeof address === "string") throw new Error("a listening server has a port");
  return address.port;
}

async function run() {
  await bundleElement();
  // A copy: what is run leaves its outputs in the file.
  const folder = mkdtempSync(join(tmpdir(), "thinshell-notebook-"));
  cpSync(join(root, "examples", "notebook"), join(folder, "examples", "notebook"), { recursive: true });
  cpSync(join(root, "element"), join(folder, "element"), { recursive: true });
  const port = await freePort();
  const options = ["--no-browser", `--port=${port}`, "--ServerApp.port_retries=0", "--IdentityProvider.token="];
  const rootOption = process.getuid?.() === 0 ? ["--allow-root"] : [];
  const lab = spawn(process.env.JUPYTER ?? "jupyter", ["lab", ...options, ...rootOption], {
    cwd: join(folder, "examples", "notebook"),
    stdio: ["ignore", "ignore", "ignore"],
  });
  let failed = false;
  lab.once("error", () => {
    failed = true;
  });
  const address = `http://localhost:${port}`;
  try {
    for (const until = Date.now() + START_MILLIS; ; ) {
      if (failed) throw new Obstacle("There is no jupyter: pip install jupyterlab anywidget, or name it by JUPYTER.");
      if (
        await fetch(`${address}/api`).then(
          ({ ok }) => ok,
          () => false,
        )
      )
        break;
      if (Date.now() > until) throw new Obstacle("JupyterLab did not start within three minutes.");
      await new Promise((resolve) => setTimeout(resolve, 500));
    }
    await read(address);
  } finally {
    lab.kill();
    rmSync(folder, { recursive: true, force: true });
  }
}

/** @param {string} address */
async function read(address) {
  const { chromium } = await import("@playwright/test");
  const browser = await chromium.launch({ executablePath: await ensureChromium(), args: chromiumFlags() });
  try {
    const page = await browser.newPage({ viewport: { width: 1200, height: 1400 } });
    await page.goto(`${address}/doc/tree/thinshell.ipynb`, { waitUntil: "commit", timeout: START_MILLIS });
    const cells = page.locator(".jp-CodeCell");
    await cells.nth(0).waitFor({ timeout: START_MILLIS });
    // What is pressed before the kernel is there is lost.
    await page.getByText(/ipykernel\) \| Idle/).waitFor({ timeout: START_MILLIS });
    /** @param {number} index */
    const execute = async (index) => {
      await cells.nth(index).locator(".cm-content").click();
      await page.keyboard.press("Control+Enter");
      await page.waitForFunction(
        (at) => /\[\d+\]/.test(document.querySelectorAll(".jp-CodeCell .jp-InputPrompt")[at]?.textContent ?? ""),
        index,
        { timeout: MATCH_MILLIS },
      );
    };
    /** @param {number} index */
    const said = async (index) => {
      const output = cells.nth(index).locator(".jp-OutputArea-output");
      await output.first().waitFor();
      return (await output.allInnerTexts()).join("\n");
    };
    const matched = () =>
      page.waitForFunction(
        (selector) => {
          const element = document.querySelector("thin-shell-match");
          const canvas = element?.shadowRoot?.querySelector('[role="img"]');
          return selector !== "" && /^matched/.test(canvas?.getAttribute("aria-label") ?? "");
        },
        MATCHED,
        { timeout: MATCH_MILLIS },
      );
    await execute(0);
    await execute(1);
    await matched();
    await page.waitForTimeout(1000);
    await execute(2);
    console.log(await said(2));
    await execute(3);
    await page.waitForTimeout(3000);
    await matched();
    await page.waitForTimeout(1000);
    await execute(4);
    console.log(await said(4));
    const [first, second] = [await said(2), await said(4)];
    if (!/stretch: 1\.63/.test(first) || !/stretch now: (1\.99|2\.00)/.test(second))
      throw new Obstacle("The notebook has not said what it should have.");
    console.log("The notebook has run: shapes went in, the report and φ at points came back.");
  } finally {
    await browser.close();
  }
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href)
  await main(async () => {
    checkNode();
    await ensurePackages();
    await buildWasm();
    await run();
  });

export { run };
