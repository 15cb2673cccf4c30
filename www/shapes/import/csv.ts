/**
 * Points as a table: x and y on each line, separated by commas, semicolons, tabs or spaces. The first line may name
 * the columns; then those called x and y count, and one called loop tells the loops apart. Else a blank line does.
 */

import type { Loop } from "../geometry";
import { type Found, ImportError } from "./found";
import { shapeFromLoops } from "./loops";

type Columns = { readonly x: number; readonly y: number; readonly loop: number | null };

export function readCsv(text: string): Found {
  const lines = text.replace(/^\uFEFF/, "").split(/\r\n|\n|\r/);
  // In tables separated by semicolons the comma may be the decimal one.
  const semicolons = lines.some((line) => line.includes(";"));
  let columns: Columns = { x: 0, y: 1, loop: null };
  let begun = false;
  const loops: number[][] = [[]];
  let name: string | null = null;
  lines.forEach((line, index) => {
    const trimmed = line.trim();
    if (trimmed.startsWith("#")) return;
    if (trimmed === "" || /^[,;\s]+$/.test(trimmed)) {
      if (loops[loops.length - 1].length > 0) loops.push([]);
      return;
    }
    const words = semicolons
      ? trimmed.split(/\s*;\s*/).map((word) => word.replace(",", "."))
      : trimmed.split(/\s*,\s*|\s+/);
    if (!begun && words.some((word) => Number.isNaN(Number(unquoted(word))))) {
      columns = columnsFrom(words.map(unquoted), index);
      begun = true;
      return;
    }
    begun = true;
    const loop = columns.loop === null ? null : unquoted(words[columns.loop] ?? "");
    if (loop !== name && loops[loops.length - 1].length > 0) loops.push([]);
    name = loop;
    loops[loops.length - 1].push(number(words, columns.x, index), number(words, columns.y, index));
  });
  const closed = loops.filter((loop) => loop.length > 0);
  if (closed.length === 0) throw new ImportError("The table holds no points; each line needs an x and a y.");
  const shape = closed.map((loop): Loop => Float64Array.from(loop));
  return { kind: "shapes", choices: [shapeFromLoops("Points", shape)], notes: [] };
}

function columnsFrom(names: readonly string[], index: number): Columns {
  const find = (name: string) => names.findIndex((candidate) => candidate.toLowerCase() === name);
  const [x, y, loop] = [find("x"), find("y"), find("loop")];
  if (x >= 0 && y >= 0) return { x, y, loop: loop >= 0 ? loop : null };
  if (names.length === 2) return { x: 0, y: 1, loop: null };
  throw new ImportError(`Line ${index + 1} names ${names.length} columns; call the two to be used x and y.`);
}

function number(words: readonly string[], column: number, index: number): number {
  const word = words[column];
  if (word === undefined) throw new ImportError(`Line ${index + 1} has only one number; each line needs an x and a y.`);
  const value = word === "" ? Number.NaN : Number(unquoted(word));
  if (!Number.isFinite(value)) {
    const shown = word.length > 24 ? `${word.slice(0, 24)}…` : word;
    throw new ImportError(`Line ${index + 1}: “${shown}” is not a number; each line needs an x and a y.`);
  }
  return value;
}

function unquoted(word: string): string {
  return word.replace(/^"(.*)"$/, "$1").trim();
}
