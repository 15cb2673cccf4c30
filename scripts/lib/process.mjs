// Running other programs and talking to whoever started us. Plain Node: it works before `npm ci` has run.

import { spawn, spawnSync } from "node:child_process";
import { accessSync, constants, statSync } from "node:fs";
import { delimiter, join } from "node:path";
import { fileURLToPath } from "node:url";

/** The repository's root, whatever the current directory is. */
export const root = fileURLToPath(new URL("../..", import.meta.url));

/** A problem that the user can solve: shown as one sentence, without a stack. */
export class Obstacle extends Error {}

/** @param {string} text */
export function heading(text) {
  const line = `── ${text} ${"─".repeat(Math.max(3, 72 - text.length))}`;
  console.log(process.stdout.isTTY ? `\n\x1b[1m${line}\x1b[0m` : `\n${line}`);
}

/**
 * The full path of a program on PATH, or null.
 *
 * @param {string} name
 * @returns {string | null}
 */
export function which(name) {
  const endings = process.platform === "win32" ? (process.env.PATHEXT ?? ".EXE;.CMD").split(";") : [""];
  for (const folder of (process.env.PATH ?? "").split(delimiter)) {
    for (const ending of endings) {
      const path = join(folder, name + ending);
      if (folder !== "" && isExecutable(path)) return path;
    }
  }
  return null;
}

/** @param {string} path */
export function isExecutable(path) {
  try {
    accessSync(path, constants.X_OK);
    return statSync(path).isFile();
  } catch {
    return false;
  }
}

/**
 * What a program prints, or null where it is missing or fails.
 *
 * @param {string} command
 * @param {string[]} args
 * @returns {string | null}
 */
export function output(command, args) {
  const { status, stdout } = spawnSync(command, args, { cwd: root, encoding: "utf8", shell: needsShell(command) });
  return status === 0 ? stdout.trim() : null;
}

/**
 * Runs a program in the repository's root, shows what it prints as it comes, and keeps a copy.
 *
 * @param {string} command
 * @param {string[]} args
 * @param {{ env?: Record<string, string>, quiet?: boolean }} [options] quiet: print only when it fails
 * @returns {Promise<{ code: number, text: string }>} the exit code and the plain text, colours removed
 */
export function run(command, args, { env = {}, quiet = false } = {}) {
  return new Promise((resolve, reject) => {
    const child = spawn(command, args, {
      cwd: root,
      env: { ...process.env, ...colours(), ...env },
      stdio: ["ignore", "pipe", "pipe"],
      shell: needsShell(command),
    });
    let text = "";
    for (const [from, to] of /** @type {const} */ ([
      [child.stdout, process.stdout],
      [child.stderr, process.stderr],
    ])) {
      from.setEncoding("utf8");
      from.on("data", (chunk) => {
        text += chunk;
        if (!quiet) to.write(chunk);
      });
    }
    child.on("error", reject);
    child.on("close", (code) => {
      if (quiet && code !== 0) process.stderr.write(text);
      resolve({ code: code ?? 1, text: withoutColours(text) });
    });
  });
}

/**
 * Runs a program that has to succeed.
 *
 * @param {string} command
 * @param {string[]} args
 * @param {{ env?: Record<string, string>, quiet?: boolean }} [options]
 */
export async function must(command, args, options) {
  const { code, text } = await run(command, args, options);
  if (code !== 0)
    throw new Obstacle(`\`${[command, ...args].join(" ")}\` ended with exit code ${code}; its output is above.`);
  return text;
}

/**
 * Runs a script's main function and turns its end into the process's.
 *
 * @param {() => Promise<void>} work
 */
export async function main(work) {
  try {
    await work();
  } catch (error) {
    console.error(error instanceof Obstacle ? `\n${error.message}` : error);
    process.exitCode = 1;
  }
}

/** @param {string} text */
export function withoutColours(text) {
  // biome-ignore lint/suspicious/noControlCharactersInRegex: the escape character is what a colour begins with
  return text.replace(/\x1b\[[0-9;]*m/g, "");
}

// A pipe is no terminal, so the programs behind it have to be told that colours are welcome.
function colours() {
  return process.stdout.isTTY ? { CARGO_TERM_COLOR: "always", FORCE_COLOR: "1" } : {};
}

// On Windows npm and npx are command files, which only a shell can run.
/** @param {string} command */
function needsShell(command) {
  return process.platform === "win32" && /^(npm|npx)$/.test(command);
}
