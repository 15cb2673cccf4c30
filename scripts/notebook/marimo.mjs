// examples/notebook/marimo_match.py as marimo shows it to readers.

import { freePort } from "../lib/drivers.mjs";
import { behind, expect, matches } from "./front.mjs";

const MISSING = "There is no marimo: pip install marimo anywidget, or name it by MARIMO.";

/** @param {import("./front.mjs").Place} place */
export async function marimo({ folder, shown }) {
  const port = await freePort();
  const options = ["--headless", "--no-token", `--port=${port}`];
  await behind(
    [process.env.MARIMO ?? "marimo", "run", "marimo_match.py", ...options],
    folder,
    /https?:\/\/\S+:\d+/,
    MISSING,
    () => shown(`http://localhost:${port}/`, read),
  );
}

/** @param {import("@playwright/test").Page} page */
async function read(page) {
  await matches(page, 1);
  // The report has come to Python, and what depends on it has been computed anew.
  const said = page.getByText(/^Stretch 1\.6/);
  await said.waitFor();
  expect((await said.textContent()) ?? "", /^Stretch 1\.63; the right end goes to 0\.8\d, 0\.50/);
  await page.getByRole("combobox", { name: "Target" }).selectOption("round");
  await matches(page, 2);
  const again = page.getByText(/^Stretch (2\.00|1\.99)/);
  await again.waitFor();
  console.log(await again.textContent());
}
