// The page for what is measured in a browser: built, served and opened in headless Chromium.

import { buildPage } from "../scripts/build.mjs";
import { chromiumFlags, ensureChromium } from "../scripts/lib/chromium.mjs";
import { root } from "../scripts/lib/process.mjs";
import { checkNode, ensurePackages } from "../scripts/lib/setup.mjs";

/**
 * Ends browser and server whatever becomes of what is measured.
 * @template T
 * @param {number} port
 * @param {(browser: import("@playwright/test").Browser) => Promise<T>} measure
 */
export async function opened(port, measure) {
  checkNode();
  await ensurePackages();
  await buildPage();
  const executablePath = await ensureChromium();
  const { preview } = await import("vite");
  const { chromium } = await import("@playwright/test");
  const server = await preview({ root, logLevel: "warn", preview: { port, strictPort: true } });
  const browser = await chromium.launch({ executablePath, args: chromiumFlags() });
  try {
    return await measure(browser);
  } finally {
    await browser.close();
    await server.close();
  }
}
