// `npm run bench:live`: how soon the match follows the hand. Builds the page, opens it in headless Chromium, switches
// Live on and drags a point of a curve along a path with mouse events at some 60 a second. Prints, for each example,
// median, 95th percentile and maximum of the page's own measure "live-frame": from the event's time stamp to the end of
// the drawing of the frame that was computed from it, at 65 × 65 nodes. Then the delay of mouse events while a long match
// runs: from their time stamp to the page's handler. `-- --json` prints only the line for machines.

import { main, Obstacle } from "../scripts/lib/process.mjs";
import { opened } from "./opened.mjs";

const EXAMPLES = ["ellipse", "star", "leaf"];
const EVENTS = 240;
const EVENT_MILLIS = 1000 / 60;
const PORT = 4210;
/** Of the drag's path, in sides of the box; a figure of eight that never stands still. */
const REACH = 0.05;

await main(async () => {
  const { rows, delay } = await opened(PORT, async (browser) => {
    const rows = [];
    for (const example of EXAMPLES) rows.push(await dragged(browser, example));
    return { rows, delay: await whileSolving(browser) };
  });
  if (!process.argv.includes("--json")) {
    console.table(rows);
    console.table([{ "input delay while solving": "", ...delay }]);
  }
  console.log(JSON.stringify({ rows, delay }));
});

/**
 * @param {import("@playwright/test").Browser} browser
 * @param {string} example
 */
async function dragged(browser, example) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  await page.goto(`http://localhost:${PORT}/#v=1&preset=${example}`);
  await page.evaluate(() => {
    const frames = [];
    Reflect.set(window, "frames", frames);
    new PerformanceObserver((list) => {
      for (const entry of list.getEntriesByName("live-frame")) frames.push(entry.duration);
    }).observe({ type: "measure" });
  });
  await page.getByRole("switch", { name: "Live" }).click();
  const ended = page.getByRole("status").locator('data[data-name="mismatch-max"]');
  await ended.waitFor();

  const surface = page.getByRole("application", { name: "Template shape" });
  const box = await surface.boundingBox();
  if (!box) throw new Obstacle("The template's surface is not on the page.");
  const start = await rightmost(surface);
  const at = (x, y) => [box.x + x * box.width, box.y + (1 - y) * box.height];
  await page.mouse.move(...at(...start));
  await page.mouse.down();
  const begin = performance.now();
  const moves = [];
  for (let i = 1; i <= EVENTS; i += 1) {
    const t = (2 * Math.PI * i) / 120;
    // Not awaited one by one: a hand does not wait for the page either.
    moves.push(page.mouse.move(...at(start[0] + REACH * Math.sin(t), start[1] + REACH * Math.sin(2 * t))));
    await new Promise((resolve) => setTimeout(resolve, begin + i * EVENT_MILLIS - performance.now()));
  }
  const seconds = (performance.now() - begin) / 1000;
  await Promise.all(moves);
  await page.mouse.up();
  await ended.waitFor();
  const mismatch = Number(await ended.getAttribute("value"));

  const frames = (await page.evaluate(() => Reflect.get(window, "frames"))).sort((a, b) => a - b);
  await page.close();
  if (frames.length === 0) throw new Obstacle(`No frame of “${example}” followed the hand.`);
  return {
    example,
    events: EVENTS,
    "events a second": Number((EVENTS / seconds).toFixed(1)),
    frames: frames.length,
    ...quantiles(frames),
    "frames over 100 ms": frames.filter((millis) => millis > 100).length,
    "largest distance after release, cells": Number(mismatch.toFixed(3)),
  };
}

/** @param {readonly number[]} sorted */
function quantiles(sorted) {
  const quantile = (part) => Number(sorted[Math.min(sorted.length - 1, Math.floor(part * sorted.length))].toFixed(1));
  return { "median ms": quantile(0.5), "95 % ms": quantile(0.95), "max ms": quantile(1) };
}

/** @param {import("@playwright/test").Browser} browser */
async function whileSolving(browser) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  await page.goto(`http://localhost:${PORT}/#v=1&preset=clover&finest=8&minimizer=ncg`);
  const surface = page.getByRole("application", { name: "Reference shape" });
  await surface.evaluate((element) => {
    const delays = [];
    Reflect.set(window, "delays", delays);
    element.addEventListener("pointermove", (event) => delays.push(performance.now() - event.timeStamp));
  });
  const box = await surface.boundingBox();
  if (!box) throw new Obstacle("The reference's surface is not on the page.");
  await page.getByRole("button", { name: "Match", exact: true }).click();
  for (let i = 0; i < EVENTS; i += 1) {
    await page.mouse.move(box.x + 20 + 0.8 * i, box.y + 40 + 0.5 * i);
    await new Promise((resolve) => setTimeout(resolve, EVENT_MILLIS));
  }
  if ((await page.getByRole("progressbar").count()) === 0)
    throw new Obstacle("The match ended before the measurement.");
  const delays = (await page.evaluate(() => Reflect.get(window, "delays"))).sort((a, b) => a - b);
  await page.close();
  return { events: delays.length, ...quantiles(delays) };
}

/** The template's rightmost painted pixel, as parts of the surface, y up: a point of its curve. */
async function rightmost(surface) {
  return surface.evaluate((canvas) => {
    const { width, height } = canvas;
    const { data } = canvas.getContext("2d").getImageData(0, 0, width, height);
    for (let x = width - 1; x >= 0; x -= 1) {
      for (let y = 0; y < height; y += 1) {
        if (data[4 * (y * width + x) + 3] > 0) return [(x - 1) / width, 1 - y / height];
      }
    }
    throw new Error("the template's surface is empty");
  });
}
