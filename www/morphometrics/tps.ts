/**
 * TPS, the text format of tpsDig and of R's packages: specimen by specimen, a line `LM=n` and n lines `x y` (y up), then
 * `CURVES=n` or `OUTLINES=n` with, for each, `POINTS=m` and m lines, then `IMAGE=`, `ID=`, `SCALE=` (units a pixel, or
 * empty). A negative coordinate means that the point is missing.
 */

import { ImportError } from "../shapes/import/found";

/** Points are x y x y …, as they stand in the file; a missing one is NaN twice. */
export type Specimen = {
  readonly landmarks: Float64Array;
  readonly curves: readonly Float64Array[];
  readonly image: string | null;
  readonly id: string | null;
  readonly scale: number | null;
  /** Other lines, as they stand: COMMENT=, VARIABLES= and the like. */
  readonly others: readonly string[];
};

type Line = { readonly text: string; readonly number: number };

/** The format has none but COMMENT=; they are written all the same. */
const COMMENT = /^(#|\/\/)/;

/** Throws an `ImportError` that names the line. */
export function readTps(text: string): Specimen[] {
  const lines = text
    .replace(/^\uFEFF/, "")
    .split(/\r\n|\n|\r/)
    .map((line, i): Line => ({ text: line.trim(), number: i + 1 }))
    .filter((line) => line.text !== "" && !COMMENT.test(line.text));
  const found: Specimen[] = [];
  let at = 0;
  while (at < lines.length) {
    const { key, value } = keyed(lines[at]);
    if (key === "LM3") throw new ImportError(`Line ${lines[at].number}: landmarks in space are not read, only LM=.`);
    if (key !== "LM") throw new ImportError(`Line ${lines[at].number}: a specimen begins with LM=, not with ${key}=.`);
    const landmarks = points(lines, at, value);
    at += 1 + landmarks.length / 2;
    const curves: Float64Array[] = [];
    let [image, id, scale]: [string | null, string | null, number | null] = [null, null, null];
    const others: string[] = [];
    let [announcing, announced]: [Line | null, number] = [null, 0];
    for (; at < lines.length; at += 1) {
      const line = lines[at];
      const { key, value } = keyed(line);
      if (key === "LM" || key === "LM3") break;
      if (key === "POINTS") {
        curves.push(points(lines, at, value));
        at += curves[curves.length - 1].length / 2;
      } else if (key === "CURVES" || key === "OUTLINES") {
        announcing = line;
        announced += count(line, value);
      } else if (key === "IMAGE") image = value;
      else if (key === "ID") id = value;
      else if (key === "SCALE") scale = value === "" ? null : scaleOf(line, value);
      else others.push(line.text);
    }
    if (announcing && announced !== curves.length) throw uncounted(announcing, curves.length);
    found.push({ landmarks, curves, image, id, scale, others });
  }
  if (found.length === 0) throw new ImportError("The TPS file holds no specimen.");
  return found;
}

/** The same to the bit when it is read again. Throws for a negative coordinate, which would read as missing. */
export function writeTps(specimens: readonly Specimen[]): string {
  const lines: string[] = [];
  for (const { landmarks, curves, image, id, scale, others } of specimens) {
    lines.push(`LM=${landmarks.length / 2}`, ...pairs(landmarks));
    if (curves.length > 0) lines.push(`CURVES=${curves.length}`);
    for (const curve of curves) lines.push(`POINTS=${curve.length / 2}`, ...pairs(curve));
    if (image !== null) lines.push(`IMAGE=${oneLine(image)}`);
    if (id !== null) lines.push(`ID=${oneLine(id)}`);
    lines.push(...others.map(oneLine));
    if (scale !== null) lines.push(`SCALE=${decimal(scale)}`);
  }
  return `${lines.join("\n")}\n`;
}

function keyed({ text, number }: Line): { readonly key: string; readonly value: string } {
  const match = /^([A-Za-z]\w*)\s*=\s*(.*)$/.exec(text);
  if (!match) throw new ImportError(`Line ${number}: “${shown(text)}” is neither announced by a count nor named.`);
  return { key: match[1].toUpperCase(), value: match[2] };
}

/** The points that line `at` announces and the lines after it hold. */
function points(lines: readonly Line[], at: number, value: string): Float64Array {
  const announced = count(lines[at], value);
  if (announced > lines.length - at - 1) throw missing(lines[at], announced, lines.length - at - 1);
  const out = new Float64Array(2 * announced);
  for (let i = 0; i < announced; i += 1) {
    const { text, number } = lines[at + 1 + i];
    if (text.includes("=")) throw missing(lines[at], announced, i);
    const words = text.split(/[\s,]+/);
    const [x, y] = words.map((word) => (/^na(n)?$/i.test(word) ? -1 : Number(word)));
    if (words.length !== 2 || !Number.isFinite(x) || !Number.isFinite(y)) {
      throw new ImportError(`Line ${number}: “${shown(text)}” is not the two numbers of a point.`);
    }
    out.set(x < 0 || y < 0 ? [Number.NaN, Number.NaN] : [x, y], 2 * i);
  }
  return out;
}

function missing({ number, text }: Line, announced: number, there: number): ImportError {
  return new ImportError(`Line ${number} (${shown(text)}) announces ${announced} points, and ${there} follow.`);
}

function uncounted({ number, text }: Line, there: number): ImportError {
  return new ImportError(`Line ${number} (${shown(text)}) does not fit the number of its lines POINTS=: ${there}.`);
}

function count({ text, number }: Line, value: string): number {
  if (!/^\d{1,7}$/.test(value)) throw new ImportError(`Line ${number}: “${shown(text)}” gives no count.`);
  return Number(value);
}

function scaleOf({ text, number }: Line, value: string): number {
  const scale = Number(value);
  if (!(scale > 0 && Number.isFinite(scale))) {
    throw new ImportError(`Line ${number}: “${shown(text)}” is no scale; it is empty, or a number above 0.`);
  }
  return scale;
}

function pairs(numbers: Float64Array): string[] {
  return Array.from({ length: numbers.length / 2 }, (_, i) => {
    const [x, y] = [numbers[2 * i], numbers[2 * i + 1]];
    if (Number.isNaN(x) || Number.isNaN(y)) return "-1 -1";
    if (x < 0 || y < 0) throw new Error(`the point ${x}, ${y} is negative, which in TPS means missing`);
    return `${decimal(x)} ${decimal(y)}`;
  });
}

/** The shortest text that reads as this very number. */
function decimal(value: number): string {
  return Object.is(value, -0) ? "-0" : String(value);
}

function oneLine(text: string): string {
  return text.replace(/[\r\n]+/g, " ");
}

function shown(text: string): string {
  return text.length > 40 ? `${text.slice(0, 40)}…` : text;
}
