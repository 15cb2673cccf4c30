// What the programs that show notebooks have in common: a server that says when it listens, and a browser before it.

import { spawn } from "node:child_process";
import { cpSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { chromiumFlags, ensureChromium } from "../lib/chromium.mjs";
import { Obstacle, root, withoutColours } from "../lib/process.mjs";

/** @typedef {{ folder: string, shown: (address: string, look: (page: import("@playwright/test").Page) => Promise<void>) => Promise<void> }} Place */

const START_MILLIS = 180_000;
export const MATCH_MILLIS = 90_000;

/**
 * In a copy of the example and the element, for what is run leaves its outputs in the files.
 *
 * @param {(place: Place) => Promise<void>} work
 */
export async function inCopy(work) {
  const copy = mkdtempSync(join(tmpdir(), "thinshell-notebook-"));
  for (const part of ["examples/notebook", "element"]) cpSync(join(root, part), join(copy, part), { recursive: true });
  const { chromium } = await import("@playwright/test");
  const browser = await chromium.launch({ executablePath: await ensureChromium(), args: chromiumFlags() });
  try {
    await work({
      folder: join(copy, "examples", "notebook"),
      shown: async (address, look) => {
        const page = await browser.newPage({ viewport: { width: 1200, height: 1400 } });
        page.setDefaultTimeout(START_MILLIS);
        // Counts what the widgets have told of: a match is told to the model before it comes here.
        await page.addInitScript(() => {
          const told = { matches: 0 };
          Object.assign(window, { told });
          document.addEventListener("match", () => {
            told.matches += 1;
          });
        });
        await page.goto(address, { waitUntil: "commit" });
        await look(page);
        await page.close();
      },
    });
  } finally {
    await browser.close();
    rmSync(copy, { recursive: true, force: true });
  }
}

/**
 * Waits until the widgets of the page have told of so many matches.
 *
 * @param {import("@playwright/test").Page} page
 * @param {number} count
 */
export async function matches(page, count) {
  await page.waitForFunction((wanted) => Reflect.get(window, "told").matches >= wanted, count, {
    timeout: MATCH_MILLIS,
  });
}

/**
 * Runs a server from when its output says that it listens until the work is done.
 *
 * @param {readonly [string, ...string[]]} command
 * @param {string} folder
 * @param {RegExp} listening
 * @param {string} missing what to say where the program is not there
 * @param {() => Promise<void>} work
 */
export async function behind([program, ...args], folder, listening, missing, work) {
  const server = spawn(program, args, { cwd: folder, stdio: ["ignore", "pipe", "pipe"] });
  let said = "";
  try {
    await new Promise((resolve, reject) => {
      server.once("error", () => reject(new Obstacle(missing)));
      server.once("close", (code) => reject(new Obstacle(`${program} ended with exit code ${code}:\n${said}`)));
      const late = () => reject(new Obstacle(`${program} did not start within three minutes:\n${said}`));
      setTimeout(late, START_MILLIS).unref();
      for (const stream of [server.stdout, server.stderr]) {
        stream.setEncoding("utf8").on("data", (text) => {
          said += withoutColours(text);
          if (listening.test(said)) resolve(undefined);
        });
      }
    });
    await work();
  } finally {
    server.kill();
  }
}

/**
 * @param {string} said
 * @param {RegExp} wanted
 */
export function expect(said, wanted) {
  console.log(said.trimEnd());
  if (!wanted.test(said)) throw new Obstacle(`That is not what was expected: ${wanted}.`);
}
