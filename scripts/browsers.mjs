// `npm test -- browsers`: the built page in Firefox and WebKitGTK, each through its WebDriver: loaded, drawn upon, matched
// and saved. One that is not installed is skipped with its reason, and fails where CI is set.

import { pathToFileURL } from "node:url";
import { By, until } from "selenium-webdriver";
import { buildPage } from "./build.mjs";
import { driving, freePort, KINDS } from "./lib/drivers.mjs";
import { main, Obstacle, root } from "./lib/process.mjs";

/** @typedef {import("selenium-webdriver").WebDriver} Driver */

/** Two browsers at work beside a solver, on a machine that others use. */
const PATIENCE_MILLIS = 90_000;
const EXPORTS = /** @type {const} */ ([
  ["Everything (JSON)", "application/json"],
  ["Picture (PNG)", "image/png"],
  ["Drawing (SVG)", "image/svg+xml"],
]);

/** @type {readonly (readonly [string, (driver: Driver, address: string) => Promise<void>])[]} */
const CHECKS = [
  [
    "a link shows its match without a press",
    async (driver, address) => {
      await driver.get(`${address}#v=2&preset=ellipse&finest=5`);
      await matched(driver);
    },
  ],
  [
    "two curves drawn with the pointer are matched within half a cell",
    async (driver) => {
      await listen(driver);
      for (const side of ["reference", "template"]) await press(driver, `Clear ${side}`);
      await stroke(driver, "Reference", 0.2, 0.2);
      await stroke(driver, "Template", 0.28, 0.18);
      await press(driver, "Match");
      await matched(driver);
    },
  ],
  [
    "the match is saved as JSON, PNG and SVG",
    async (driver) => {
      for (const [label, type] of EXPORTS) {
        const saved = await exported(driver, label);
        expect(saved.type.startsWith(type), `${label} is of type ${saved.type}`);
        expect(saved.size > 1000, `${label} has ${saved.size} bytes`);
        if (type === "application/json")
          expect(JSON.parse(saved.text).match?.report?.finished === true, `${label} holds no finished match`);
      }
    },
  ],
  [
    "another view is drawn, with its legend",
    async (driver) => {
      const picker = await driver.findElement(By.css("select.view-picker"));
      await picker.findElement(By.css('option[value="stretch"]')).click();
      await driver.wait(until.elementLocated(By.css(".legend")), PATIENCE_MILLIS);
    },
  ],
  [
    "nothing was against the policy, and no error went unsaid",
    async (driver) => {
      const heard = /** @type {string[]} */ (await driver.executeScript("return window.heard"));
      expect(heard.length === 0, heard.join("; "));
    },
  ],
  [
    "a reload brings the drawing back, and its match",
    async (driver) => {
      await driver.navigate().refresh();
      await matched(driver);
      await element(driver, "Clear template", (button) => button.isEnabled());
    },
  ],
  [
    "the experiments are there",
    async (driver, address) => {
      await driver.get(`${address}experiments.html`);
      await driver.wait(until.elementLocated(By.css("#experiments section img")), PATIENCE_MILLIS);
    },
  ],
];

/**
 * @param {{ built?: boolean }} [options] built: dist/ is the page to be tried
 * @returns {Promise<{ passed: number, failed: number, skipped: number }>}
 */
export async function checkBrowsers({ built = false } = {}) {
  if (!built) await buildPage();
  const { preview } = await import("vite");
  const port = await freePort();
  const server = await preview({ root, logLevel: "warn", preview: { port, strictPort: true } });
  const count = { passed: 0, failed: 0, skipped: 0 };
  try {
    for (const kind of KINDS) {
      const missing = kind.missing();
      if (missing !== null) {
        const counts = Boolean(process.env.CI);
        console.log(`  ${counts ? "✗" : "-"} ${kind.name} was ${counts ? "to be tried" : "skipped"}: ${missing}`);
        if (counts) count.failed += 1;
        else count.skipped += 1;
        continue;
      }
      await driving(kind, (driver) => tried(driver, kind.name, `http://localhost:${port}/`, count));
    }
  } finally {
    await server.close();
  }
  return count;
}

/**
 * @param {Driver} driver
 * @param {string} name
 * @param {string} address
 * @param {{ passed: number, failed: number }} count
 */
async function tried(driver, name, address, count) {
  await driver.manage().setTimeouts({ script: PATIENCE_MILLIS, pageLoad: PATIENCE_MILLIS });
  for (const [title, check] of CHECKS) {
    try {
      await check(driver, address);
      console.log(`  ✓ ${name}: ${title}`);
      count.passed += 1;
    } catch (error) {
      console.log(`  ✗ ${name}: ${title}\n    ${error instanceof Error ? error.message : String(error)}`);
      count.failed += 1;
    }
  }
}

/**
 * Waits for a finished match, and looks at its numbers.
 *
 * @param {Driver} driver
 */
async function matched(driver) {
  const value = async (/** @type {string} */ name) => {
    const found = until.elementLocated(By.css(`[role="status"] data[data-name="${name}"]`));
    const text = await (await driver.wait(found, PATIENCE_MILLIS)).getAttribute("value");
    // Without a value there is no number: an empty text would be 0.
    return text ? Number(text) : Number.NaN;
  };
  const most = await value("mismatch-max");
  expect(most < 0.5, `the largest distance is ${most} cells`);
  const least = await value("least-determinant");
  expect(least > 0, `the least area ratio is ${least}`);
}

/**
 * @param {Driver} driver
 * @param {string} name
 * @param {(button: import("selenium-webdriver").WebElement) => Promise<boolean>} [holds]
 */
async function element(driver, name, holds = async () => true) {
  const place = By.xpath(`//button[normalize-space()="${name}" or @aria-label="${name}"]`);
  const found = await driver.wait(until.elementLocated(place), PATIENCE_MILLIS);
  await driver.wait(() => holds(found), PATIENCE_MILLIS, `“${name}” is not what it should be`);
  return found;
}

/**
 * @param {Driver} driver
 * @param {string} name
 */
async function press(driver, name) {
  await (await element(driver, name)).click();
}

/**
 * An ellipse about the middle of a side's surface.
 *
 * @param {Driver} driver
 * @param {string} side
 * @param {number} a parts of the surface
 * @param {number} b
 */
async function stroke(driver, side, a, b) {
  const surface = await driver.findElement(By.css(`canvas[aria-label="${side} shape"]`));
  await driver.executeScript("arguments[0].scrollIntoView({ block: 'center' })", surface);
  const { width, height } = await surface.getRect();
  // Offsets are from the element's middle.
  const at = (/** @type {number} */ t) => ({
    origin: surface,
    x: Math.round(a * width * Math.cos(t)),
    y: Math.round(-b * height * Math.sin(t)),
    duration: 10,
  });
  const points = 36;
  const hand = driver.actions({ async: true }).move(at(0)).press();
  for (let i = 1; i <= points; i += 1) hand.move(at((2 * Math.PI * i) / (points + 1)));
  await hand.release().perform();
}

/**
 * What the page hands to the browser to be saved.
 *
 * @param {Driver} driver
 * @param {string} label
 * @returns {Promise<{ type: string, size: number, text: string }>}
 */
async function exported(driver, label) {
  await driver.executeScript(`
    const made = window.made ??= URL.createObjectURL;
    window.saved = new Promise((resolve) => {
      URL.createObjectURL = (blob) => {
        resolve(blob);
        return made.call(URL, blob);
      };
    });
  `);
  await driver.findElement(By.css("details.save > summary")).click();
  await press(driver, label);
  return driver.executeAsyncScript(`
    const done = arguments[arguments.length - 1];
    window.saved.then(async (blob) => done({ type: blob.type, size: blob.size, text: await blob.text() }));
  `);
}

/**
 * From now on, whatever should not happen is noted.
 *
 * @param {Driver} driver
 */
async function listen(driver) {
  await driver.executeScript(`
    const heard = (window.heard = []);
    addEventListener("error", (event) => heard.push(String(event.message)));
    addEventListener("unhandledrejection", (event) => heard.push(String(event.reason)));
    addEventListener("securitypolicyviolation", (event) => heard.push(event.violatedDirective + " " + event.blockedURI));
  `);
}

/**
 * @param {boolean} holds
 * @param {string} otherwise
 */
function expect(holds, otherwise) {
  if (!holds) throw new Error(otherwise);
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href)
  await main(async () => {
    const { failed } = await checkBrowsers({ built: process.argv.includes("--built") });
    if (failed > 0) throw new Obstacle("The page does not do in every browser what it should; the list is above.");
  });
