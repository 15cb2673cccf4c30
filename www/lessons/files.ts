/** All lessons of a folder, or all their mistakes. Runs while the page is built. */

import { readFileSync } from "node:fs";
import type { Lesson } from "./lesson";
import { readLesson, tryState } from "./read";

/** The pages that a lesson may lead to, and what of them. */
const PAGES = /^\.\/(index|experiments|lessons)\.html(?:#(.*))?$/;
const LESSON = /^([a-z-]+)(?:\/\d+)?$/;

/** Throws the mistakes of all files at once, each with its file and line. */
export function allLessons(files: readonly string[]): readonly Lesson[] {
  const mistakes: string[] = [];
  const names = files.map((file) => /(?:^|\/)\d+-([a-z-]+)\.md$/.exec(file)?.[1]);
  const leads = (address: string): boolean => {
    const [, page, part] = PAGES.exec(address) ?? [];
    if (part === undefined || page === "experiments") return page !== undefined;
    return page === "lessons" ? names.includes(LESSON.exec(part)?.[1] ?? "") : isState(part);
  };
  const found = files.flatMap((file) => {
    try {
      return [readLesson(file, readFileSync(file, "utf8"), leads)];
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

function isState(text: string): boolean {
  try {
    tryState(text);
    return true;
  } catch {
    return false;
  }
}
