// examples/notebook/thinshell.ipynb in JupyterLab, cell by cell as a reader would.

import { freePort } from "../lib/drivers.mjs";
import { behind, expect, MATCH_MILLIS, matches } from "./front.mjs";

const MISSING = "There is no jupyter: pip install jupyterlab anywidget, or name it by JUPYTER.";

/** @param {import("./front.mjs").Place} place */
export async function jupyter({ folder, shown }) {
  const port = await freePort();
  const options = ["--no-browser", `--port=${port}`, "--ServerApp.port_retries=0", "--IdentityProvider.token="];
  const rootOption = process.getuid?.() === 0 ? ["--allow-root"] : [];
  await behind(
    [process.env.JUPYTER ?? "jupyter", "lab", ...options, ...rootOption],
    folder,
    /is running at/,
    MISSING,
    () => shown(`http://localhost:${port}/doc/tree/thinshell.ipynb`, read),
  );
}

/** @param {import("@playwright/test").Page} page */
async function read(page) {
  const cells = page.locator(".jp-CodeCell");
  await cells.nth(0).waitFor();
  const idle = page.getByText(/ipykernel\) \| Idle/);
  // What is pressed before the kernel is there is lost.
  await idle.waitFor();
  /** @param {number} index */
  const execute = async (index) => {
    await cells.nth(index).locator(".cm-content").click();
    await page.keyboard.press("Control+Enter");
    await page.waitForFunction(
      (at) => /\[\d+\]/.test(document.querySelectorAll(".jp-CodeCell .jp-InputPrompt")[at]?.textContent ?? ""),
      index,
      { timeout: MATCH_MILLIS },
    );
    // A kernel at rest has heard all that the widgets have told.
    await idle.waitFor();
  };
  /** @param {number} index */
  const said = async (index) => {
    const output = cells.nth(index).locator(".jp-OutputArea-output");
    await output.first().waitFor();
    return (await output.allInnerTexts()).join("\n");
  };
  await execute(0);
  await execute(1);
  await matches(page, 1);
  await execute(2);
  expect(await said(2), /stretch: 1\.63/);
  await execute(3);
  await matches(page, 2);
  await execute(4);
  expect(await said(4), /stretch now: (1\.99|2\.00)/);
}
