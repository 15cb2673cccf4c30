/**
 * Points as a table: x and y on each line, separated by commas, semicolons, tabs or spaces. The first line may name
 * the columns; then those called x and y count. One called loop tells the loops apart, else a blank line does; one called
 * shape tells shapes apart; a line with something in one called landmark is no point of the outline.
 */

import { type Choice, type Found, ImportError } from "./found";
import { choicesFrom, shapeFromLoops } from "./loops";

type Named = "loop" | "shape" | "landmark";
type Columns = { readonly x: number; readonly y: number } & { readonly [name in Named]?: number };

/** What the lines of one shape have told so far. */
type Told = { readonly name: string; readonly loops: number[][]; readonly landmarks: number[]; loop: string | null };

export function readCsv(text: string): Found {
  const lines = text.replace(/^\uFEFF/, "").split(/\r\n|\n|\r/);
  const separator = separatorOf(lines);
  let columns: Columns = { x: 0, y: 1 };
  let begun = false;
  const shapes = new Map<string, Told>();
  let last: Told | undefined;
  for (const [index, line] of lines.entries()) {
    const trimmed = line.trim();
    if (trimmed.startsWith("#")) continue;
    if (trimmed === "" || /^[,;\s]+$/.test(trimmed)) {
      if (last) endLoop(last);
      continue;
    }
    const words = wordsOf(trimmed, separator);
    if (!begun && words.some((word) => /\p{L}/u.test(word) && Number.isNaN(Number(unquoted(word))))) {
      columns = columnsFrom(words.map(unquoted), index);
      begun = true;
      continue;
    }
    if (!begun) refuseUnnamed(words, index);
    begun = true;
    const value = (column: Named) => {
      const at = columns[column];
      return at === undefined ? null : unquoted(words[at] ?? "");
    };
    const name = value("shape") ?? "Points";
    last = shapes.get(name) ?? { name, loops: [[]], landmarks: [], loop: null };
    shapes.set(name, last);
    const point = [number(words, columns.x, index), number(words, columns.y, index)];
    if (value("landmark")) {
      last.landmarks.push(...point);
      continue;
    }
    const loop = value("loop");
    if (loop !== last.loop) endLoop(last);
    last.loop = loop;
    last.loops[last.loops.length - 1].push(...point);
  }
  if (shapes.size === 0) throw new ImportError("The table holds no points; each line needs an x and a y.");
  return { kind: "shapes", choices: choicesFrom([...shapes.values()], ({ name }) => name, choice), notes: [] };
}

function choice({ name, loops, landmarks }: Told): Choice {
  const closed = loops.filter((loop) => loop.length > 0).map((loop) => Float64Array.from(loop));
  const shape = shapeFromLoops(name, closed);
  if (landmarks.length === 0) return shape;
  return { ...shape, marks: { landmarks: Float64Array.from(landmarks), image: null, scale: null } };
}

function endLoop({ loops }: Told): void {
  if (loops[loops.length - 1].length > 0) loops.push([]);
}

/** What separates the values of a table; a comma that does not may be the decimal one. */
type Separator = ";" | "\t" | "," | " ";

function separatorOf(lines: readonly string[]): Separator {
  const unnamed = lines.filter((line) => !line.startsWith("#")).map((line) => line.replace(QUOTED, ""));
  const found = ([";", "\t", ","] as const).find((mark) => unnamed.some((line) => line.trim().includes(mark)));
  return found ?? " ";
}

/** Quotes are kept, for what stands in them is a name. */
function wordsOf(line: string, separator: Separator): string[] {
  const marks = { ";": /;/, "\t": /\t/, ",": /,/, " ": /\s+/ };
  // Among commas some write spaces.
  const isSpaced = separator === "," && !line.replace(QUOTED, "").includes(",");
  const mark = marks[isSpaced ? " " : separator];
  const words: string[] = [];
  let word = "";
  for (const part of line.split(/("(?:[^"]|"")*")/)) {
    const [first, ...more] = part.startsWith('"') ? [part] : part.split(mark);
    word += first;
    for (const next of more) {
      words.push(word.trim());
      word = next;
    }
  }
  words.push(word.trim());
  const decimal = separator === ";" || separator === "\t";
  return decimal
    ? words.map((one) => one.replace(/^("?[-+]?\d*),(\d+(?:e[-+]?\d+)?"?)$/i, "$1.$2").replace(/,$/, ""))
    : words;
}

const QUOTED = /"(?:[^"]|"")*"/g;

/** Of three numbers nobody says which two are meant. */
function refuseUnnamed(words: readonly string[], index: number): void {
  const count = words.filter((word) => word !== "").length;
  if (count > 2)
    throw new ImportError(
      `Line ${index + 1} has ${count} numbers, and no line before names x and y; decimal commas need semicolons between the numbers.`,
    );
}

function columnsFrom(names: readonly string[], index: number): Columns {
  const find = (name: string) => {
    const at = names.findIndex((candidate) => candidate.toLowerCase() === name);
    return at >= 0 ? at : undefined;
  };
  const [x, y] = [find("x"), find("y")];
  if (x !== undefined && y !== undefined) {
    return { x, y, loop: find("loop"), shape: find("shape"), landmark: find("landmark") };
  }
  if (names.length === 2) return { x: 0, y: 1 };
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
  return word
    .replace(/^"(.*)"$/, "$1")
    .replaceAll('""', '"')
    .trim();
}
