// The size budget: what the first load asks for, compressed as a server would send it.

import { readdirSync, readFileSync } from "node:fs";
import { join, posix } from "node:path";
import { pathToFileURL } from "node:url";
import { gzipSync } from "node:zlib";
import { WORKER } from "./lib/offline.mjs";
import { main, Obstacle, root } from "./lib/process.mjs";

const BUDGET = 200_000;

/**
 * The files that loading index.html asks for, in the order they are found.
 *
 * A file counts when one that counts names it, in whatever way: a tag, a static import, a worker's or the module's URL,
 * a style sheet's url(). Only `import("…")`, the list from which Vite preloads for it, links to follow, what is for
 * installing the page, and the service worker, which comes when the page is idle, may name a file for later.
 *
 * @param {Map<string, string>} texts each file of the build by its path, with its text ("" for binary ones)
 * @returns {string[]}
 */
export function firstLoad(texts) {
  const asked = ["index.html"];
  const others = [...texts.keys()].filter((path) => path !== WORKER);
  for (const path of asked) {
    const now = (texts.get(path) ?? "")
      .replace(/\bimport\(\s*[`"'][^`"']*[`"']\s*\)/g, "")
      .replace(/__vite__mapDeps[^;]*?\[[^\]]*\]/g, "")
      .replace(/<a\s[^>]*>/g, "")
      .replace(/<link\s[^>]*rel="(manifest|apple-touch-icon)"[^>]*>/g, "");
    for (const other of others) if (!asked.includes(other) && now.includes(posix.basename(other))) asked.push(other);
  }
  return asked;
}

/**
 * Prints the table of the first load and what is left for later.
 *
 * @param {string} dist
 * @returns {boolean} whether the first load keeps to the budget
 */
export function checkSize(dist = join(root, "dist")) {
  const paths = readdirSync(dist, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => posix.relative(slashes(dist), slashes(join(entry.parentPath, entry.name))));
  if (!paths.includes("index.html")) throw new Obstacle("dist/ holds no page: run `npm run build` first.");
  const texts = new Map(
    paths.map((path) => [
      path,
      /\.(html|js|css|svg|json|webmanifest)$/.test(path) ? readFileSync(join(dist, path), "utf8") : "",
    ]),
  );
  const first = new Set(firstLoad(texts));
  let total = 0;
  for (const path of [...first, ...paths.filter((path) => !first.has(path))]) {
    const bytes = gzipSync(readFileSync(join(dist, path)), { level: 9 }).length;
    if (first.has(path)) total += bytes;
    console.log(`${(bytes / 1000).toFixed(1).padStart(9)} kB  ${path}${first.has(path) ? "" : "  (later, on demand)"}`);
  }
  const within = total <= BUDGET;
  console.log(
    `${(total / 1000).toFixed(1).padStart(9)} kB  first load, gzip; the budget is ${BUDGET / 1000} kB${within ? "" : ": too much"}`,
  );
  return within;
}

/** @param {string} path */
function slashes(path) {
  return path.replaceAll("\\", "/");
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href)
  await main(async () => {
    if (!checkSize()) throw new Obstacle("The first load exceeds its budget: load what it does not need on demand.");
  });
