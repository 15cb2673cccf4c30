// Firefox and WebKitGTK behind WebDriver: where they are, what drives them, and what is missing where they are not.

import { spawn } from "node:child_process";
import { once } from "node:events";
import { createServer } from "node:net";
import { homedir } from "node:os";
import { join } from "node:path";
import { Browser, Builder, Capabilities } from "selenium-webdriver";
import { isExecutable, Obstacle, which } from "./process.mjs";

/**
 * @typedef {{
 *   name: string,
 *   missing: () => string | null,
 *   command: (port: number) => [string, string[]],
 *   capabilities: () => Capabilities,
 * }} Kind
 */

/** Debian has none; built from crates.io it lies beside cargo, which need not be on the PATH. */
const geckodriver = () =>
  which("geckodriver") ??
  [join(process.env.CARGO_HOME ?? join(homedir(), ".cargo"), "bin", "geckodriver")].find(isExecutable) ??
  null;

const firefox = () => which("firefox-esr") ?? which("firefox");

const miniBrowser = () =>
  ["x86_64-linux-gnu", "aarch64-linux-gnu"]
    .flatMap((machine) =>
      ["4.1", "4.0", "6.0"].map((version) => `/usr/lib/${machine}/webkit2gtk-${version}/MiniBrowser`),
    )
    .find(isExecutable) ?? null;

/** @type {readonly Kind[]} */
export const KINDS = [
  {
    name: "Firefox",
    missing: () => {
      if (firefox() === null) return "there is no firefox-esr and no firefox";
      return geckodriver() === null ? "there is no geckodriver: `cargo install geckodriver --locked` builds one" : null;
    },
    command: (port) => [geckodriver() ?? "", ["--port", String(port)]],
    capabilities: () =>
      new Capabilities().setBrowserName(Browser.FIREFOX).set("moz:firefoxOptions", {
        binary: firefox(),
        args: ["-headless", "-width", "1280", "-height", "900"],
      }),
  },
  {
    name: "WebKitGTK",
    missing: () => {
      if (which("WebKitWebDriver") === null || miniBrowser() === null) return "there is no webkit2gtk-driver";
      return process.env.DISPLAY || which("xvfb-run") !== null ? null : "there is no display and no xvfb";
    },
    command: (port) => {
      const driver = ["WebKitWebDriver", `--port=${port}`];
      const [program = "", ...args] = process.env.DISPLAY
        ? driver
        : ["xvfb-run", "-a", "-s", "-screen 0 1400x1000x24", ...driver];
      return [program, args];
    },
    capabilities: () =>
      new Capabilities()
        .setBrowserName("MiniBrowser")
        .set("webkitgtk:browserOptions", { binary: miniBrowser(), args: ["--automation", "--geometry=1280x900"] }),
  },
];

/**
 * Starts the driver and a browser with a fresh profile, and ends both after the work.
 *
 * @param {Kind} kind
 * @param {(driver: import("selenium-webdriver").WebDriver) => Promise<void>} work
 */
export async function driving(kind, work) {
  const port = await freePort();
  const [program, args] = kind.command(port);
  // In a group of its own: a display's wrapper does not hand on what ends it.
  const server = spawn(program, args, { stdio: "ignore", detached: true });
  try {
    const address = `http://127.0.0.1:${port}`;
    await ready(address, kind.name);
    const driver = await new Builder().usingServer(address).withCapabilities(kind.capabilities()).build();
    try {
      await work(driver);
    } finally {
      await driver.quit().catch(() => {});
    }
  } finally {
    if (server.pid !== undefined && server.exitCode === null) process.kill(-server.pid);
  }
}

const TRIES = 100;
const TRY_MILLIS = 200;

/**
 * @param {string} address
 * @param {string} name
 */
async function ready(address, name) {
  for (let i = 0; i < TRIES; i += 1) {
    const answer = await fetch(`${address}/status`).catch(() => null);
    if (answer?.ok) return;
    await new Promise((resolve) => setTimeout(resolve, TRY_MILLIS));
  }
  throw new Obstacle(`The driver of ${name} did not answer at ${address}.`);
}

/** A port that nobody listens on. */
export async function freePort() {
  const server = createServer().listen(0);
  await once(server, "listening");
  const address = server.address();
  server.close();
  if (address === null || typeof address === "string") throw new Error("a listening server has a port");
  return address.port;
}
