/**
 * A match as a file: shapes, settings, φ and the report, as JSON that loads back to the same state to the bit.
 *
 * `{format: "thinshell", version: 1, reference: {loops}, template: {loops}, settings, match}`; a loop is a list of
 * points [x, y], domain units, y up. `match` is null, or `{report, deformation, curves}` with φ at the nodes of level
 * `report.level`, x y x y …, x fastest.
 */

import type { Curves, FrameReply, Status } from "./protocol";
import { type Chosen, FIELDS, parseSetting, withSetting } from "./settings";
import type { Loop, Shape } from "./shapes/geometry";
import { FORMAT } from "./shapes/import/format";

export type SavedMatch = Pick<FrameReply, "status" | "deformation" | "curves">;

export type MatchRecord = {
  readonly reference: Shape;
  readonly template: Shape;
  readonly settings: Chosen;
  readonly match: SavedMatch | null;
};

const VERSION = 1;

export function encodeRecord({ reference, template, settings, match }: MatchRecord): string {
  return JSON.stringify({
    format: FORMAT,
    version: VERSION,
    reference: { loops: reference.map(pairs) },
    template: { loops: template.map(pairs) },
    // Defaults as well: another version of the page may have others.
    settings: Object.fromEntries(FIELDS.map((field) => [field.name, settings[field.name] ?? field.initial])),
    match: match && {
      report: match.status,
      deformation: [...match.deformation],
      curves: {
        reference: match.curves.reference.map(pairs),
        template: match.curves.template.map(pairs),
        matched: match.curves.matched.map(pairs),
      },
    },
  });
}

/** Throws a sentence for what `encodeRecord` has not written. */
export function decodeRecord(content: unknown): MatchRecord {
  const record = object(content, "the file");
  if (record.version !== VERSION) {
    throw new Error(`The file is of version ${String(record.version)}; this page reads version ${VERSION}.`);
  }
  const reference = shape(object(record.reference, "reference").loops, "reference");
  const template = shape(object(record.template, "template").loops, "template");
  let settings: Chosen = {};
  const given = object(record.settings ?? {}, "settings");
  for (const [name, value] of Object.entries(given)) {
    const field = FIELDS.find((candidate) => candidate.name === name);
    if (!field) throw new Error(`The file has a setting “${name}”, which this page does not know.`);
    settings = withSetting(settings, field, parseSetting(field, String(value)));
  }
  return { reference, template, settings, match: record.match === null ? null : savedMatch(record.match) };
}

const NUMBERS = ["level", "iteration", "evaluations", "leastDeterminant"];
const GROUPS = {
  energies: ["membrane", "bending", "mismatch", "volume", "total"],
  mismatch: ["mean", "max"],
  stretch: ["mean", "deviation"],
};

function savedMatch(content: unknown): SavedMatch {
  const match = object(content, "match");
  const report = object(match.report, "match.report");
  for (const name of NUMBERS) number(report[name], `match.report.${name}`);
  for (const [group, names] of Object.entries(GROUPS)) {
    const values = object(report[group], `match.report.${group}`);
    for (const name of names) number(values[name], `match.report.${group}.${name}`);
  }
  const status = { ...(report as unknown as Status), finished: true };
  const deformation = Float64Array.from(list(match.deformation, "match.deformation"), (value, i) =>
    number(value, `match.deformation[${i}]`),
  );
  const side = 2 ** status.level + 1;
  if (deformation.length !== 2 * side * side) {
    throw new Error(
      `The deformation has ${deformation.length} numbers, but level ${status.level} needs ${2 * side * side}; save it again.`,
    );
  }
  const given = object(match.curves, "match.curves");
  const curves: Curves = {
    reference: [...shape(given.reference, "match.curves.reference")],
    template: [...shape(given.template, "match.curves.template")],
    matched: [...shape(given.matched, "match.curves.matched")],
  };
  const partners = curves.reference.every((loop, i) => loop.length === curves.matched[i]?.length);
  if (!partners || curves.reference.length !== curves.matched.length) {
    throw new Error("The matched curves have not the points of the reference; save the match again.");
  }
  return { status, deformation, curves };
}

function pairs(loop: Loop): [number, number][] {
  return Array.from({ length: loop.length / 2 }, (_, i) => [loop[2 * i], loop[2 * i + 1]]);
}

function shape(content: unknown, name: string): Shape {
  return list(content, name).map((loop, l) => {
    const points = list(loop, `${name}, loop ${l + 1},`);
    const out = new Float64Array(2 * points.length);
    points.forEach((point, i) => {
      const [x, y] = list(point, `${name}, loop ${l + 1}, point ${i + 1},`);
      out[2 * i] = number(x, `${name}, loop ${l + 1}, point ${i + 1}`);
      out[2 * i + 1] = number(y, `${name}, loop ${l + 1}, point ${i + 1}`);
    });
    return out;
  });
}

function object(value: unknown, name: string): Record<string, unknown> {
  if (typeof value === "object" && value !== null && !Array.isArray(value)) return value as Record<string, unknown>;
  throw new Error(`The file is damaged: ${name} is missing or of the wrong kind; save it again.`);
}

function list(value: unknown, name: string): readonly unknown[] {
  if (Array.isArray(value)) return value;
  throw new Error(`The file is damaged: ${name} is no list; save it again.`);
}

function number(value: unknown, name: string): number {
  if (typeof value === "number" && Number.isFinite(value)) return value;
  throw new Error(`The file is damaged: ${name} is no number; save it again.`);
}
