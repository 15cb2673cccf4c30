/** All lessons of a folder, or all their mistakes. Runs while the page is built. */

import { readFileSync } from "node:fs";
import type { Lesson } from "./lesson";
import { readLesson } from "./read";

/** The pages that a lesson may lead to. */
const PAGES = /^\.\/(index|experiments|lessons)\.html(#.*)?$/;

/** Throws the mistakes of all files at once, each with its file and line. */
export function allLessons(files: readonly string[]): readonly Lesson[] {
  const mistakes: string[] = [];
  const found = files.flatMap((file) => {
    try {
      return [readLesson(file, readFileSync(file, "utf8"), (address) => PAGES.test(address))];
    } catch (error) {
      mistakes.push(error instanceof Error ? error.message : String(error));
      return [];
    }
  });
  const ids = found.map(({ id }) => id);
  const twice = ids.find((id, index) => ids.indexOf(id) !== index);
  if (twice !== undefined) mistakes.push(`two lessons are called ${twice}`);
  if (mistakes.length > 0) throw new Error(`The lessons have mistakes:\n${mistakes.join("\n")}`);
  return found;
}
