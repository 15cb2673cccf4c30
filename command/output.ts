/** What a batch leaves in its folder, and on the screen. */

import { mkdirSync, statSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import type { Matched, Plan } from "../www/batch/match";
import { distinct } from "../www/batch/subjects";
import { type Row, semilandmarksCsv, semilandmarksTps, strainsCsv, tableCsv } from "../www/batch/tables";
import { encodeRecord } from "../www/record";
import { Refusal } from "./arguments";
import { codeOf } from "./files";

export class Output {
  /** Files of different names, on disks that do not tell capitals apart too. */
  private readonly fileName = distinct();

  constructor(
    private readonly folder: string,
    private readonly plan: Plan,
    private readonly strains: boolean,
  ) {
    written(folder, () => makeFolder(resolve(folder)));
  }

  match(row: Row, match: Matched): void {
    const { name, target } = row;
    if (!target) return;
    const { reference, settings } = this.plan;
    const { status, deformation, curves, pins } = match;
    const record = { reference: reference.shape, template: target.shape, pins, settings };
    const stem = this.fileName(safe(name));
    this.write(`${stem}.json`, encodeRecord({ ...record, match: { status, deformation, curves } }));
    if (this.strains) this.write(`${stem}-strains.csv`, strainsCsv(this.plan, [row]));
  }

  /** Of what there is by now. */
  tables(rows: readonly Row[]): void {
    this.write("table.csv", tableCsv(rows));
    this.write("semilandmarks.tps", semilandmarksTps(this.plan, rows));
    this.write("semilandmarks.csv", semilandmarksCsv(this.plan, rows));
  }

  private write(name: string, text: string): void {
    const file = join(this.folder, name);
    written(file, () => writeFileSync(file, text));
  }
}

/** One by one: some systems' folders that take no other make Node's own way of doing it all at once go on for ever. */
function makeFolder(path: string): void {
  if (statSync(path, { throwIfNoEntry: false })?.isDirectory()) return;
  if (dirname(path) !== path) makeFolder(dirname(path));
  mkdirSync(path);
}

function written(path: string, write: () => void): void {
  try {
    write();
  } catch (error) {
    const code = codeOf(error);
    const why = code === "EEXIST" || code === "ENOTDIR" ? "a file has its name" : (REASONS[code] ?? code);
    throw new Refusal(`${path} cannot be written: ${why}.`);
  }
}

const REASONS: Readonly<Record<string, string>> = {
  EACCES: "it is not allowed",
  EPERM: "it is not allowed",
  EROFS: "the disk can only be read",
  ENOSPC: "the disk is full",
  EISDIR: "a folder has its name",
};

/** A name that every system takes for that of a file, and that is none of the tables'. */
function safe(name: string): string {
  const plain = name
    .toLowerCase()
    .replace(/[^\p{L}\p{N}._-]+/gu, "-")
    .replace(/^[.-]+|[.-]+$/g, "")
    .slice(0, 80);
  return plain === "" || /^(con|prn|aux|nul|com\d|lpt\d)$/.test(plain) ? `match-${plain}` : plain;
}

/** The table on the screen: what is looked at first. */
export function printed(rows: readonly Row[]): string {
  const lines = rows.map(({ name, match, outcome }) => [
    name,
    match ? match.procrustesDistance.toFixed(4) : "",
    match ? match.centroidSize.toPrecision(5) : "",
    match ? match.status.mismatch.max.toFixed(3) : "",
    match ? match.status.leastDeterminant.toFixed(3) : "",
    outcome,
  ]);
  const all = [["shape", "distance", "size", "mismatch", "least det", "outcome"], ...lines];
  const widths = all[0].map((_, column) => Math.max(...all.map((line) => [...line[column]].length)));
  const last = widths.length - 1;
  return all
    .map((line) =>
      line
        .map((text, column) => {
          if (column === last) return text;
          const room = " ".repeat(widths[column] - [...text].length);
          return column === 0 ? text + room : room + text;
        })
        .join("  "),
    )
    .join("\n");
}
