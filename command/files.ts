/** Files and folders as shapes. */

import { readdirSync, readFileSync, statSync } from "node:fs";
import { join } from "node:path";
import { subjectsIn, type Taken } from "../www/batch/subjects";
import { Content } from "../www/shapes/import/content";
import { type Found, ImportError } from "../www/shapes/import/found";
import { kindOf, textIn } from "../www/shapes/import/kind";
import { readText } from "../www/shapes/import/read";
import { readSvg } from "../www/shapes/import/svg";
import { Refusal } from "./arguments";
import { checkWellFormed } from "./drawing";

/** What systems call it when nothing can have this name. */
const ABSENT = ["ENOENT", "ENOTDIR", "ENAMETOOLONG", "ELOOP"];
const READABLE = /\.(svg|json|geojson|csv|txt|tps)$/i;

/** The files meant: one that is named, and of a folder those whose ending is that of a readable one. */
export function filesIn(paths: readonly string[]): string[] {
  return paths.flatMap((path) => {
    if (!isFolder(path)) return [path];
    const found = listed(path)
      .filter((name) => READABLE.test(name) && !isFolder(join(path, name)))
      .map((name) => join(path, name))
      .sort();
    if (found.length === 0) throw new Refusal(`${path} is a folder without any SVG, GeoJSON, JSON, TPS or CSV file.`);
    return found;
  });
}

/** What cannot be looked at is no folder: reading it tells why. */
function isFolder(path: string): boolean {
  try {
    return statSync(path).isDirectory();
  } catch {
    return false;
  }
}

function listed(folder: string): string[] {
  try {
    return readdirSync(folder);
  } catch (error) {
    throw new Refusal(`The folder ${folder} cannot be read (${codeOf(error)}).`);
  }
}

/** What the system calls it, such as EACCES. */
export function codeOf(error: unknown): string {
  return (error as NodeJS.ErrnoException).code ?? String(error);
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
    const code = codeOf(error);
    if (code === "EISDIR") throw new ImportError("This is a folder; name a file in it.");
    throw new ImportError(ABSENT.includes(code) ? "There is no such file." : `The file cannot be read (${code}).`);
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
