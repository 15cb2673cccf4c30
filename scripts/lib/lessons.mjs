// Gives the page its lessons: the files of docs/lessons, read and checked while it is built.

import { readdirSync } from "node:fs";
import { join, resolve } from "node:path";
import { runnerImport } from "vite";

const LIST = "virtual:lessons";
const ONE = "virtual:lesson/";

/**
 * @param {string} folder
 * @returns {import("vite").Plugin}
 */
export function lessons(folder) {
  /** @type {Promise<readonly import("../../www/lessons/lesson").Lesson[]> | null} */
  let all = null;
  const read = () => {
    all ??= readAll(folder);
    return all;
  };
  return {
    name: "thinshell-lessons",
    buildStart() {
      for (const file of filesOf(folder)) this.addWatchFile(resolve(file));
    },
    watchChange() {
      all = null;
    },
    resolveId: (id) => (id === LIST || id.startsWith(ONE) ? `\0${id}` : null),
    async load(id) {
      if (id === `\0${LIST}`) return listed(await read());
      if (!id.startsWith(`\0${ONE}`)) return null;
      const wanted = (await read()).find((lesson) => id === `\0${ONE}${lesson.id}`);
      if (!wanted) throw new Error(`there is no lesson ${id}`);
      return `export default ${JSON.stringify(wanted)}`;
    },
  };
}

/**
 * In the order of their names.
 *
 * @param {string} folder
 */
export function filesOf(folder) {
  return readdirSync(folder)
    .filter((name) => name.endsWith(".md"))
    .sort()
    .map((name) => join(folder, name).replaceAll("\\", "/"));
}

/**
 * By the page's own readers of links and settings.
 *
 * @param {string} folder
 */
async function readAll(folder) {
  /** @type {{ module: typeof import("../../www/lessons/files") }} */
  const { module } = await runnerImport(resolve("www/lessons/files.ts"), { configFile: false, logLevel: "error" });
  return module.allLessons(filesOf(folder));
}

/** @param {readonly import("../../www/lessons/lesson").Lesson[]} all */
function listed(all) {
  const entries = all.map(({ id, title, about, minutes }) => {
    const known = JSON.stringify({ id, title, about, minutes });
    return `{ ...${known}, load: () => import(${JSON.stringify(ONE + id)}) }`;
  });
  return `export default [${entries.join(",\n")}]`;
}
