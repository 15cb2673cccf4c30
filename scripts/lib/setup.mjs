// What a fresh machine lacks: npm packages, the wasm target, the wasm-bindgen command line. Each is made once and
// recognised afterwards in milliseconds.

import { createHash } from "node:crypto";
import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { homedir } from "node:os";
import { delimiter, join } from "node:path";
import { heading, isExecutable, must, Obstacle, output, root, which } from "./process.mjs";

const WASM = "wasm32-unknown-unknown";

/** Refuses a Node that Vite does not run on. */
export function checkNode() {
  const [major = 0, minor = 0] = process.versions.node.split(".").map(Number);
  const fits = (major === 20 && minor >= 19) || (major === 22 && minor >= 12) || major > 22;
  if (!fits)
    throw new Obstacle(
      `Node 20.19 or newer is needed and this is ${process.versions.node}: install one from https://nodejs.org, then run this again.`,
    );
}

/** Installs the npm packages when there are none or when the lockfile has changed since. */
export async function ensurePackages() {
  const lock = createHash("sha256")
    .update(readFileSync(join(root, "package-lock.json")))
    .digest("hex");
  const stamp = join(root, "node_modules", ".thinshell-lock");
  if (existsSync(stamp) && readFileSync(stamp, "utf8") === lock) return;
  heading("npm packages");
  // The tests use a Chromium of the system, so no package has to fetch one.
  await must("npm", ["ci", "--no-audit", "--no-fund"], { env: { PLAYWRIGHT_SKIP_BROWSER_DOWNLOAD: "1" } });
  writeFileSync(stamp, lock);
}

/**
 * Makes sure of a Rust that can build the crate, for this machine and for wasm.
 *
 * @param {{ lints?: boolean }} [options] lints: rustfmt and clippy as well
 */
export async function ensureRust({ lints = false } = {}) {
  // A rustup installed a minute ago is not yet on the PATH of an open terminal.
  const cargoBin = join(process.env.CARGO_HOME ?? join(homedir(), ".cargo"), "bin");
  if (which("cargo") === null && existsSync(cargoBin)) process.env.PATH += delimiter + cargoBin;
  if (which("cargo") === null)
    throw new Obstacle("Rust is missing: install it with rustup from https://rustup.rs, then run this again.");
  if (process.platform === "linux" && ["cc", "gcc", "clang"].every((name) => which(name) === null))
    throw new Obstacle(
      "Rust needs a C linker and there is none: install one (on Debian and Ubuntu `sudo apt-get install build-essential`), then run this again.",
    );

  // rustup installs what rust-toolchain.toml names at the first call, unless the toolchain is there without it.
  const version = output("rustc", ["--version"])?.match(/\d+\.\d+/)?.[0];
  if (version === undefined)
    throw new Obstacle("`rustc --version` failed: repair Rust with `rustup update stable`, then run this again.");
  const needed = readFileSync(join(root, "Cargo.toml"), "utf8").match(/^rust-version = "(\d+\.\d+)/m)?.[1] ?? "1.0";
  if (Number(version.split(".")[1]) < Number(needed.split(".")[1]))
    throw new Obstacle(
      `Rust ${needed} or newer is needed and this is ${version}: run \`rustup update stable\`, then run this again.`,
    );

  if (which("rustup") === null) {
    // A distribution's Rust: it can be complete, but nothing can be added to it from here.
    const library = join(output("rustc", ["--print", "sysroot"]) ?? "", "lib", "rustlib", WASM);
    if (!existsSync(library))
      throw new Obstacle(
        `This Rust lacks the target ${WASM} and there is no rustup to add it: install rustup from https://rustup.rs, then run this again.`,
      );
    return;
  }
  const lines = (/** @type {string[]} */ ...args) => (output("rustup", args) ?? "").split(/\r?\n/);
  if (!lines("target", "list", "--installed").includes(WASM)) {
    heading(`Rust target ${WASM}`);
    await must("rustup", ["target", "add", WASM]);
  }
  if (!lints) return;
  const installed = lines("component", "list", "--installed");
  const missing = ["rustfmt", "clippy"].filter((name) => !installed.some((line) => line.startsWith(`${name}-`)));
  if (missing.length > 0) {
    heading(`Rust components ${missing.join(", ")}`);
    await must("rustup", ["component", "add", ...missing]);
  }
}

/**
 * Builds the wasm-bindgen command line of the version that Cargo.lock pins, unless it is there.
 *
 * @returns {Promise<string>} the path of `wasm-bindgen`; the test runner of .cargo/config.toml lies beside it
 */
export async function ensureBindgen() {
  const linked = lockedVersion(join(root, "Cargo.lock"), "wasm-bindgen");
  const manifest = join(root, "scripts", "wasm-bindgen", "Cargo.toml");
  const offered = lockedVersion(join(root, "scripts", "wasm-bindgen", "Cargo.lock"), "wasm-bindgen-cli");
  if (linked !== offered)
    throw new Obstacle(
      `Cargo.lock has wasm-bindgen ${linked}, scripts/wasm-bindgen builds ${offered}: set both Cargo.toml files to the same version.`,
    );
  // Not in CARGO_TARGET_DIR: .cargo/config.toml has to know where the test runner lies.
  const folder = join(root, "target", "wasm-bindgen");
  const ending = process.platform === "win32" ? ".exe" : "";
  const tool = join(folder, "debug", `wasm-bindgen${ending}`);
  const runner = join(folder, "debug", `wasm-bindgen-test-runner${ending}`);
  const current = isExecutable(runner) && isExecutable(tool) && output(tool, ["--version"])?.endsWith(` ${linked}`);
  if (!current) {
    heading(`wasm-bindgen ${linked} (built once)`);
    await must("cargo", ["build", "--locked", "--manifest-path", manifest, "--target-dir", folder]);
  }
  return tool;
}

/**
 * @param {string} lockfile
 * @param {string} name
 */
function lockedVersion(lockfile, name) {
  const version = readFileSync(lockfile, "utf8").match(new RegExp(`name = "${name}"\\r?\\nversion = "([^"]+)"`))?.[1];
  if (version === undefined)
    throw new Obstacle(`${lockfile} names no package ${name}: restore it from the repository.`);
  return version;
}
