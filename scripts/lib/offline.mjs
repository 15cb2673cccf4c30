// The service worker's list: every file of the built page with its SHA-256, and a version made of all of them.

import { createHash } from "node:crypto";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join, relative } from "node:path";

export const WORKER = "sw.js";

/**
 * A Vite plugin: writes the list into the built worker, when everything else is written.
 *
 * @returns {import("vite").Plugin}
 */
export function offline() {
  return {
    name: "thinshell-offline",
    apply: "build",
    enforce: "post",
    writeBundle: ({ dir }) => {
      if (dir === undefined) throw new Error("a build of several files has a folder");
      writeList(dir);
    },
  };
}

/** @param {string} folder */
function writeList(folder) {
  const list = listOf(folder);
  const text = JSON.stringify(list);
  const version = createHash("sha256").update(text).digest("hex").slice(0, 16);
  const file = join(folder, WORKER);
  const worker = readFileSync(file, "utf8");
  if (!worker.includes("__FILES__") || !worker.includes("__VERSION__"))
    throw new Error(`${WORKER} has no places for its list of files and its version`);
  // Within a string in a string, in whichever quotes it has been put.
  writeFileSync(file, worker.replace("__FILES__", text.replaceAll('"', '\\"')).replace("__VERSION__", version));
}

/**
 * @param {string} folder
 * @returns {Record<string, string>}
 */
export function listOf(folder) {
  const files = readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => relative(folder, join(entry.parentPath, entry.name)).replaceAll("\\", "/"))
    .filter((path) => path !== WORKER)
    .sort();
  return Object.fromEntries(
    files.map((path) => [
      path,
      createHash("sha256")
        .update(readFileSync(join(folder, path)))
        .digest("hex"),
    ]),
  );
}
