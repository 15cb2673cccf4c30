// `node scripts/icons.mjs`: the icons of the installed page in public/, painted by Chromium from public/icon.svg.

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { chromium } from "@playwright/test";
import { chromiumFlags, ensureChromium } from "./lib/chromium.mjs";
import { main, root } from "./lib/process.mjs";

/** A maskable icon is cut to a circle of four fifths of its side: the picture stays within, its ground goes on. */
const ICONS = [
  { name: "icon-192.png", side: 192, share: 1, ground: "transparent" },
  { name: "icon-512.png", side: 512, share: 1, ground: "transparent" },
  { name: "icon-maskable-512.png", side: 512, share: 0.8, ground: "#2b3a8f" },
];

await main(async () => {
  const svg = readFileSync(join(root, "public/icon.svg"), "utf8");
  const browser = await chromium.launch({ executablePath: await ensureChromium(), args: chromiumFlags() });
  for (const { name, side, share, ground } of ICONS) {
    const page = await browser.newPage({ viewport: { width: side, height: side } });
    const size = `width:${100 * share}vw;height:${100 * share}vh`;
    await page.setContent(
      `<body style="margin:0;display:grid;place-items:center;height:100vh;background:${ground}">${svg.replace("<svg", `<svg style="${size}"`)}`,
    );
    await page.screenshot({ path: join(root, "public", name), omitBackground: true });
    await page.close();
  }
  await browser.close();
});
