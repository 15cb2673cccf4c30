// `npm run bench:first`: how soon a first visit can be used, and how soon it sees a finished match without a press. Builds
// the page, opens it in headless Chromium, each time in a fresh profile, and prints median and maximum of: the page drawn
// and answering ("interactive": the button Match is there and a task of its own has run after the next frame), the first
// finished match drawn, and both again for a visit that the service worker answers without the network. `-- --json`
// prints only the line for machines.

import { main } from "../scripts/lib/process.mjs";
import { opened } from "./opened.mjs";

const VISITS = 15;
const PORT = 4211;

await main(async () => {
  const visits = await opened(PORT, async (browser) => {
    /** @type {{ visit: string, interactive: number, matched: number }[]} */
    const found = [];
    for (let i = 0; i < VISITS; i += 1) {
      const context = await browser.newContext({ viewport: { width: 1280, height: 800 } });
      const page = await context.newPage();
      await page.addInitScript(watch);
      found.push({ visit: "first", ...(await visited(page)) });
      await page.evaluate(() => navigator.serviceWorker.ready.then(() => undefined));
      await context.setOffline(true);
      found.push({ visit: "again, without the network", ...(await visited(page)) });
      await context.close();
    }
    return found;
  });
  const rows = [...new Set(visits.map(({ visit }) => visit))].map((visit) => {
    const of = (/** @type {"interactive" | "matched"} */ what) =>
      visits
        .filter((one) => one.visit === visit)
        .map((one) => Math.round(one[what]))
        .sort((a, b) => a - b);
    const [interactive, matched] = [of("interactive"), of("matched")];
    return {
      visit,
      "interactive, median ms": interactive[VISITS >> 1],
      "interactive, max ms": interactive[VISITS - 1],
      "matched, median ms": matched[VISITS >> 1],
      "matched, max ms": matched[VISITS - 1],
    };
  });
  if (!process.argv.includes("--json")) console.table(rows);
  console.log(JSON.stringify({ visits: VISITS, rows }));
});

/** In the page, before its own scripts: notes when what is waited for is seen, since the navigation began. */
function watch() {
  /** @type {Record<string, number>} */
  const times = {};
  Reflect.set(window, "times", times);
  const look = () => {
    if (!("interactive" in times) && document.querySelector(".toolbar button.primary")) {
      times.interactive = Number.NaN;
      setTimeout(() => {
        times.interactive = performance.now();
      });
    }
    if (document.querySelector('[role="status"] data[data-name="mismatch-max"]')) times.matched = performance.now();
    else requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
}

/**
 * @param {import("@playwright/test").Page} page
 * @returns {Promise<{ interactive: number, matched: number }>}
 */
async function visited(page) {
  await page.goto(`http://localhost:${PORT}/`);
  await page.waitForFunction(() => "matched" in Reflect.get(window, "times"));
  return page.evaluate(() => Reflect.get(window, "times"));
}
