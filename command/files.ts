/** Files and folders as shapes. */

import { readdirSync, readFileSync, statSync } from "node:fs";
import { join } from "node:path";
import { subjectsIn, type Taken } from "../www/batch/subjects";
import { Content } from "../www/shapes/import/content";
import { type Found, ImportError } from "../www/shapes/import/found";
import { kindOf, textIn } from "../www/shapes/import/kind";
import { readText } from "../www/shapes/import/read";
import { readSvg } from "../www/shapes/import/svg";
import { checkWellFormed } from "./drawing";

const READABLE = /\.(svg|json|geojson|csv|txt|tps)$/i;

/** The files meant: one that is named, and of a folder those whose ending is that of a readable one. */
export function filesIn(paths: readonly string[]): string[] {
  return paths.flatMap((path) => {
    if (!statSync(path, { throwIfNoEntry: false })?.isDirectory()) return [path];
    return readdirSync(path, { withFileTypes: true })
      .filter((entry) => entry.isFile() && READABLE.test(entry.name))
      .map(({ name }) => join(path, name))
      .sort();
  });
}

/** The shapes of a file. Throws a sentence where it is none. */
export async function read(path: string, outline: boolean): Promise<Taken[]> {
  const found = foundIn(path);
  if (found.kind !== "shapes") throw new ImportError("This is a saved match; take its shapes out of it on the page.");
  const content = new Content(found);
  return subjectsIn(content.offer, path, outline, (wishes) => content.outcome(wishes));
}

function foundIn(path: string): Found {
  let bytes: Buffer;
  try {
    bytes = readFileSync(path);
  } catch (error) {
    const { code } = error as NodeJS.ErrnoException;
    throw new ImportError(code === "ENOENT" ? "There is no such file." : `The file cannot be read (${code}).`);
  }
  if (bytes.length === 0) throw new ImportError("The file is empty.");
  const kind = kindOf(bytes.toString("latin1", 0, 64));
  if (kind === "picture") throw new ImportError("Pictures are read by the page only; save its outline there, as SVG.");
  if (typeof kind === "object") throw new ImportError(kind.refusal);
  const given = textIn(bytes.toString("utf8"));
  if (given.kind === "text") return readText(given.text);
  checkWellFormed(given.text);
  return readSvg(given.text);
}
