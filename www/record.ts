/**
 * A match as a file: shapes, settings, φ and the report, as JSON that loads back to the same state to the bit.
 *
 * `{format: "thinshell", version: 1, reference: {loops}, template: {loops}, pins, settings, match}`; a loop is a list of
 * points [x, y], domain units, y up, and a pin `{reference: [x, y], template: [x, y]}`. `match` is null, or `{report, deformation, curves}` with φ at the nodes of level
 * `report.level`, x y x y …, x fastest.
 */

import type { Curves, FrameReply, Status } from "./protocol";
import { type Chosen, FIELDS, parseSetting, withSetting } from "./settings";
import type { Loop, Point, Shape } from "./shapes/geometry";
import { FORMAT } from "./shapes/import/format";
import { isInBox, MOST_PINS, type Pin, type Shapes } from "./shapes/pins";
import { files as say } from "./words/files";

export type SavedMatch = Pick<FrameReply, "status" | "deformation" | "curves">;

export type MatchRecord = Shapes & {
  readonly settings: Chosen;
  readonly match: SavedMatch | null;
};

const VERSION = 1;

export function encodeRecord({ reference, template, pins, settings, match }: MatchRecord): string {
  return JSON.stringify({
    format: FORMAT,
    version: VERSION,
    reference: { loops: reference.map(pairs) },
    template: { loops: template.map(pairs) },
    pins: pins.map((pin) => ({ reference: pair(pin.reference), template: pair(pin.template) })),
    // Defaults as well: another version of the page may have others.
    settings: Object.fromEntries(FIELDS.map((field) => [field.name, settings[field.name] ?? field.initial])),
    // What could not be read again is no result: its shapes and settings are enough to start it again.
    match:
      match !== null && isSound(match)
        ? {
            report: { ...match.status, facts: [...match.status.facts] },
            deformation: [...match.deformation],
            curves: {
              reference: match.curves.reference.map(pairs),
              template: match.curves.template.map(pairs),
              matched: match.curves.matched.map(pairs),
            },
          }
        : null,
  });
}

/** Throws a sentence for what `encodeRecord` has not written. */
export function decodeRecord(content: unknown): MatchRecord {
  const record = object(content, "the file");
  if (record.version !== VERSION) {
    throw new Error(say.version(String(record.version), VERSION));
  }
  const reference = shape(object(record.reference, "reference").loops, "reference");
  const template = shape(object(record.template, "template").loops, "template");
  // Files of before there were pins have none.
  const pins = list(record.pins ?? [], "pins").map(pinFrom);
  if (pins.length > MOST_PINS) throw damaged(say.manyPins(MOST_PINS));
  let settings: Chosen = {};
  const given = object(record.settings ?? {}, "settings");
  for (const [name, value] of Object.entries(given)) {
    const field = FIELDS.find((candidate) => candidate.name === name);
    if (!field) throw new Error(say.setting(name));
    settings = withSetting(settings, field, parseSetting(field, String(value)));
  }
  return { reference, template, pins, settings, match: record.match === null ? null : savedMatch(record.match) };
}

function pinFrom(content: unknown, index: number): Pin {
  const pin = object(content, `pin ${index + 1}`);
  const end = (side: "reference" | "template"): Point => {
    const name = `pin ${index + 1}, ${side}`;
    const [x, y, ...more] = list(pin[side], name).map((value) => number(value, name));
    if (more.length > 0 || !isInBox(x) || !isInBox(y)) throw damaged(say.outside(name));
    return { x, y };
  };
  return { reference: end("reference"), template: end("template") };
}

const ENERGIES = ["membrane", "bending", "mismatch", "volume", "pins", "total"];
/** What is measured on the curves: null where the grid does not see them. */
const MEASURES = { mismatch: ["mean", "max"], cover: ["mean", "max"], stretch: ["mean", "deviation"] };

/** What files from before the template's parts were measured lack. */
const UNMEASURED = { cover: { mean: Number.NaN, max: Number.NaN }, measure: Number.NaN };

/** A grid of 1025² nodes: no page computes finer ones, and a file of one has 50 MB. */
const FINEST = 10;

function savedMatch(content: unknown): SavedMatch {
  const match = object(content, "match");
  const report = object(match.report, "match.report");
  const level = whole(report.level, "match.report.level", FINEST);
  for (const name of ["iteration", "evaluations"]) whole(report[name], `match.report.${name}`);
  const energies = object(report.energies, "match.report.energies");
  energies.pins ??= 0;
  for (const name of ENERGIES) number(energies[name], `match.report.energies.${name}`);
  // Files of before the cover was measured have none.
  const given = Object.entries(MEASURES).filter(([group]) => group in report || group !== "cover");
  const measured = given.map(([group, names]) => {
    const values = object(report[group], `match.report.${group}`);
    return [group, { ...values, ...named(names, (name) => measure(values[name], `match.report.${group}.${name}`)) }];
  });
  if (report.measure === null) report.measure = Number.NaN;
  const stop = typeof report.stop === "string" ? report.stop : null;
  const verdict = typeof report.verdict === "string" ? report.verdict : null;
  // In the file's own order, so that a match saved again is the same file.
  const missing = Object.entries(UNMEASURED).filter(([name]) => !(name in report));
  const known = { ...(report as unknown as Status), ...Object.fromEntries(missing) };
  const found = { ...known, ...Object.fromEntries(measured) };
  // Sentences in another language than the file's come from them; without, the file's own are shown.
  const facts = Float64Array.from(
    Array.isArray(report.facts) && report.facts.every(Number.isFinite) ? report.facts : [],
  );
  const status = { ...found, stop, verdict, facts, finished: true };
  const deformation = Float64Array.from(list(match.deformation, "match.deformation"), (value, i) =>
    number(value, `match.deformation[${i}]`),
  );
  const side = 2 ** level + 1;
  if (deformation.length !== 2 * side * side) {
    throw new Error(say.deformation(deformation.length, level, 2 * side * side));
  }
  if (!(number(report.leastDeterminant, "match.report.leastDeterminant") > 0) || folds(deformation, side)) {
    throw new Error(say.folded);
  }
  const outlines = object(match.curves, "match.curves");
  const curves: Curves = {
    reference: [...shape(outlines.reference, "match.curves.reference")],
    template: [...shape(outlines.template, "match.curves.template")],
    matched: [...shape(outlines.matched, "match.curves.matched")],
  };
  const partners = curves.reference.every((loop, i) => loop.length === curves.matched[i]?.length);
  if (!partners || curves.reference.length !== curves.matched.length) {
    throw new Error(say.unlike);
  }
  return { status, deformation, curves };
}

/** Whether a corner of a cell is turned over. */
function folds(deformation: Float64Array, side: number): boolean {
  const at = (i: number, j: number) => 2 * (j * side + i);
  for (let j = 0; j < side; j += 1) {
    for (let i = 0; i < side; i += 1) {
      // A node is the corner of up to four cells: across to one neighbour, up or down to another.
      for (const [di, dj] of CORNERS) {
        if (i + di < 0 || i + di >= side || j + dj < 0 || j + dj >= side) continue;
        const [here, across, up] = [at(i, j), at(i + di, j), at(i, j + dj)];
        const determinant =
          (deformation[across] - deformation[here]) * (deformation[up + 1] - deformation[here + 1]) -
          (deformation[across + 1] - deformation[here + 1]) * (deformation[up] - deformation[here]);
        if (!(determinant * di * dj > 0)) return true;
      }
    }
  }
  return false;
}

const CORNERS = [
  [1, 1],
  [-1, 1],
  [1, -1],
  [-1, -1],
] as const;

/** Whether every number is one that the file can hold and that reading it takes. */
function isSound({ status, deformation, curves }: SavedMatch): boolean {
  const all = [deformation, ...curves.reference, ...curves.template, ...curves.matched];
  return (
    all.every((numbers) => numbers.every(Number.isFinite)) &&
    Object.values(status.energies).every(Number.isFinite) &&
    status.leastDeterminant > 0 &&
    !folds(deformation, 2 ** status.level + 1)
  );
}

function named<T>(names: readonly string[], value: (name: string) => T): Record<string, T> {
  return Object.fromEntries(names.map((name) => [name, value(name)]));
}

function pair({ x, y }: Point): [number, number] {
  return [x, y];
}

function pairs(loop: Loop): [number, number][] {
  return Array.from({ length: loop.length / 2 }, (_, i) => [loop[2 * i], loop[2 * i + 1]]);
}

function shape(content: unknown, name: string): Shape {
  return list(content, name).map((loop, l) => {
    const points = list(loop, `${name}, loop ${l + 1},`);
    const out = new Float64Array(2 * points.length);
    points.forEach((point, i) => {
      const [x, y, ...more] = list(point, `${name}, loop ${l + 1}, point ${i + 1},`);
      if (more.length > 0) throw damaged(say.manyNumbers(`${name}, loop ${l + 1}, point ${i + 1}`));
      out[2 * i] = number(x, `${name}, loop ${l + 1}, point ${i + 1}`);
      out[2 * i + 1] = number(y, `${name}, loop ${l + 1}, point ${i + 1}`);
    });
    return out;
  });
}

function object(value: unknown, name: string): Record<string, unknown> {
  if (typeof value === "object" && value !== null && !Array.isArray(value)) return value as Record<string, unknown>;
  throw damaged(say.missing(name));
}

function list(value: unknown, name: string): readonly unknown[] {
  if (Array.isArray(value)) return value;
  throw damaged(say.noList(name));
}

function number(value: unknown, name: string): number {
  if (typeof value === "number" && Number.isFinite(value)) return value;
  throw damaged(say.noNumber(name));
}

/** JSON has no word for what is no number but null. */
function measure(value: unknown, name: string): number {
  return value === null ? Number.NaN : number(value, name);
}

function whole(value: unknown, name: string, most = Number.MAX_SAFE_INTEGER): number {
  const found = number(value, name);
  if (Number.isInteger(found) && found >= 0 && found <= most) return found;
  throw damaged(say.strange(name, found));
}

function damaged(what: string): Error {
  return new Error(say.damaged(what));
}
