// A Chromium and the driver that fits it: the ones on the machine, else installed.

import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { heading, isExecutable, Obstacle, output, root, run, which } from "./process.mjs";

const BROWSERS = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"];
const ADVICE =
  "install Chromium or Chrome and the chromedriver of the same version, or name them in CHROME_PATH and CHROMEDRIVER";

/** What starts Chromium, from the one list in webdriver.json. */
export function chromiumFlags() {
  const flags = capabilities()["goog:chromeOptions"].args;
  // Chromium refuses to start its sandbox as root, as which containers run.
  return process.getuid?.() === 0 ? [...flags, "--no-sandbox"] : flags;
}

/** The Chromium to test with, or null where none is found. */
export function findChromium() {
  const named = fromEnvironment("CHROME_PATH");
  if (named !== null) return named;
  const places = [
    "/Applications/Chromium.app/Contents/MacOS/Chromium",
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    ...["ProgramFiles", "ProgramFiles(x86)", "LOCALAPPDATA"].flatMap((name) =>
      process.env[name] ? [join(process.env[name], "Google", "Chrome", "Application", "chrome.exe")] : [],
    ),
    ...downloaded("chrome"),
  ];
  return BROWSERS.map(which).find((path) => path !== null) ?? places.find(isExecutable) ?? null;
}

/** The chromedriver to test with, or null where none is found. */
function findDriver() {
  const named = fromEnvironment("CHROMEDRIVER");
  if (named !== null) return named;
  const places = [
    "/usr/lib/chromium/chromedriver",
    "/usr/lib/chromium-browser/chromedriver",
    // GitHub's runners name the folder here.
    join(process.env.CHROMEWEBDRIVER ?? "", "chromedriver"),
    ...downloaded("chromedriver"),
  ];
  return which("chromedriver") ?? places.find(isExecutable) ?? null;
}

/**
 * The Chromium for pages, installed where the machine has none.
 *
 * @returns {Promise<string>}
 */
export async function ensureChromium() {
  const found = findChromium();
  if (found !== null) return found;
  await install();
  const installed = findChromium();
  if (installed === null) throw new Obstacle(`No Chromium was found or could be installed: ${ADVICE}.`);
  return installed;
}

/**
 * The environment in which cargo's wasm tests find their browser and its driver.
 *
 * @returns {Promise<Record<string, string>>}
 */
export async function driverEnvironment() {
  let browser = await ensureChromium();
  let driver = findDriver();
  if (driver === null) {
    await install();
    driver = findDriver();
    browser = await ensureChromium();
  }
  if (driver === null) throw new Obstacle(`No chromedriver was found or could be installed: ${ADVICE}.`);
  const [ofBrowser, ofDriver] = [majorVersion(browser), majorVersion(driver)];
  if (ofBrowser !== null && ofDriver !== null && ofBrowser !== ofDriver)
    throw new Obstacle(`${driver} is for version ${ofDriver}, ${browser} is version ${ofBrowser}: ${ADVICE}.`);

  const all = capabilities();
  all["goog:chromeOptions"].binary = browser;
  all["goog:chromeOptions"].args = chromiumFlags();
  const file = join(root, "target", "webdriver.json");
  mkdirSync(join(root, "target"), { recursive: true });
  writeFileSync(file, JSON.stringify(all, null, "\t"));
  return { CHROMEDRIVER: driver, WASM_BINDGEN_TEST_WEBDRIVER_JSON: file };
}

// Through apt where there is one that we may use, else Chrome for Testing through npm, which needs no rights.
async function install() {
  heading("Chromium and chromedriver");
  if (which("apt-get") !== null) {
    const asRoot = process.getuid?.() === 0 ? [] : which("sudo") !== null ? ["sudo", "-n"] : null;
    if (asRoot !== null) {
      const apt = (/** @type {string[]} */ ...args) => {
        const [command = "", ...rest] = [...asRoot, "env", "DEBIAN_FRONTEND=noninteractive", "apt-get", ...args];
        return run(command, rest);
      };
      await apt("update");
      const { code } = await apt("install", "-y", "--no-install-recommends", "chromium", "chromium-driver");
      if (code === 0) return;
      console.log("apt-get could not install chromium and chromium-driver; trying Chrome for Testing.");
    }
  }
  for (const name of ["chrome", "chromedriver"])
    await run("npx", ["--yes", "@puppeteer/browsers@2", "install", `${name}@stable`, "--path", downloads]);
}

const downloads = join(root, "target", "browsers");

/** @param {"chrome" | "chromedriver"} name */
function downloaded(name) {
  // The installer lays them down as chrome/linux-131.0.6778.85/chrome-linux64/chrome.
  const programs = {
    chrome: ["chrome", "chrome.exe", "Google Chrome for Testing.app/Contents/MacOS/Google Chrome for Testing"],
    chromedriver: ["chromedriver", "chromedriver.exe"],
  };
  return folders(join(downloads, name)).flatMap((version) =>
    folders(version).flatMap((platform) => programs[name].map((program) => join(platform, program))),
  );
}

/** @param {string} folder */
function folders(folder) {
  return existsSync(folder) ? readdirSync(folder).map((name) => join(folder, name)) : [];
}

/** @param {string} program */
function majorVersion(program) {
  // chrome.exe answers `--version` with a window.
  if (process.platform === "win32") return null;
  return output(program, ["--version"])?.match(/(\d+)\.\d+\.\d+/)?.[1] ?? null;
}

/** @returns {{ "goog:chromeOptions": { binary?: string, args: string[] } }} */
function capabilities() {
  return JSON.parse(readFileSync(join(root, "webdriver.json"), "utf8"));
}

/** @param {string} name */
function fromEnvironment(name) {
  const path = process.env[name];
  if (path === undefined || path === "") return null;
  if (!isExecutable(path)) throw new Obstacle(`${name} is ${path}, which is no program: correct it or unset it.`);
  return path;
}
