/** What a batch leaves with: a table of the matches, their semilandmarks as TPS and CSV, and strains cell by cell. */

import { centroidSize } from "../morphometrics/configuration";
import { type Specimen, writeTps } from "../morphometrics/tps";
import { contains } from "../shapes/geometry";
import { FITS } from "../words/facts";
import { type Matched, type Plan, strained } from "./match";
import { own, type Subject } from "./subject";

/** One target: what came of it, in a sentence, and its match where there is one. */
export type Row = {
  readonly name: string;
  readonly file: string;
  readonly outcome: string;
  readonly target: Subject | null;
  readonly match: Matched | null;
};

/** How many have been matched, and how many of those matches are good ones. */
export function counts(rows: readonly Row[]): { readonly matched: number; readonly fitting: number } {
  return { matched: rows.filter(({ match }) => match).length, fitting: rows.filter(fits).length };
}

/** By the solver's own verdict; every match comes to an end, also one that misses a hole. */
function fits({ match }: Row): boolean {
  return match?.status.facts[2] === FITS;
}

type Value = string | number | null | undefined;

/** Columns of the table, in its order. Lengths in cells are those of the finest grid. */
const COLUMNS: readonly (readonly [string, (row: Row) => Value])[] = [
  ["shape", ({ name }) => name],
  ["file", ({ file }) => file],
  ["matched", ({ match }) => (match ? "yes" : "no")],
  ["centroid_size", ({ match }) => match?.centroidSize],
  ["procrustes_distance", ({ match }) => match?.procrustesDistance],
  ["fits", (row) => row.match && (fits(row) ? "yes" : "no")],
  ["mismatch_mean_cells", ({ match }) => match?.status.mismatch.mean],
  ["mismatch_max_cells", ({ match }) => match?.status.mismatch.max],
  ["cover_max_cells", ({ match }) => match?.status.cover.max],
  ["length_ratio", ({ match }) => match?.status.measure],
  ["least_determinant", ({ match }) => match?.status.leastDeterminant],
  ["membrane", ({ match }) => match?.status.energies.membrane],
  ["bending", ({ match }) => match?.status.energies.bending],
  ["volume", ({ match }) => match?.status.energies.volume],
  ["level", ({ match }) => match?.status.level],
  ["outcome", ({ outcome }) => outcome],
];

export function tableCsv(rows: readonly Row[]): string {
  return csv([COLUMNS.map(([name]) => name), ...rows.map((row) => COLUMNS.map(([, value]) => value(row)))]);
}

/** The reference first, then every target that has been matched: as many points each, in the same order. */
export function semilandmarksTps(plan: Plan, rows: readonly Row[]): string {
  return writeTps(
    configurations(plan, rows).map(({ name, points, subject }): Specimen => {
      const [moved, by] = positive(points);
      return {
        landmarks: moved,
        curves: [],
        image: subject.image,
        id: name,
        scale: subject.scale ?? 1,
        others: by ? [`COMMENT=moved by ${by[0]} ${by[1]}, since negative coordinates would mean missing points`] : [],
      };
    }),
  );
}

/** The same as a table, in true units where the files give a scale. */
export function semilandmarksCsv(plan: Plan, rows: readonly Row[]): string {
  const lines: Value[][] = [["shape", "point", "x", "y"]];
  for (const { name, points, subject } of configurations(plan, rows)) {
    const scale = subject.scale ?? 1;
    for (let i = 0; i < points.length; i += 2) lines.push([name, i / 2 + 1, scale * points[i], scale * points[i + 1]]);
  }
  return csv(lines);
}

/**
 * Strains, a line a cell of each match: its middle in the reference's units, whether that lies inside the reference, the
 * principal strains, the direction of the first in degrees, and the expansion. Both shapes at one centroid size.
 */
export function strainsCsv({ reference }: Plan, rows: readonly Row[]): string {
  const lines: Value[][] = [["shape", "x", "y", "inside", "strain_1", "strain_2", "direction_1", "expansion"]];
  const places = new Map<number, readonly (readonly [number, number, number])[]>();
  for (const { name, match } of rows) {
    if (!match) continue;
    const { cells, first, second, angle, expansion } = strained(match);
    const middles = places.get(cells) ?? placesOf(reference, cells);
    places.set(cells, middles);
    middles.forEach((place, at) => {
      lines.push([name, ...place, first[at], second[at], (angle[at] * 180) / Math.PI, expansion[at]]);
    });
  }
  return csv(lines);
}

/** The middle of each cell in the reference's units, and 1 where it lies inside it, else 0. */
function placesOf({ shape, box }: Subject, cells: number): (readonly [number, number, number])[] {
  return Array.from({ length: cells * cells }, (_, at) => {
    const middle = { x: ((at % cells) + 0.5) / cells, y: (Math.floor(at / cells) + 0.5) / cells };
    const [x, y] = own(Float64Array.of(middle.x, middle.y), box);
    return [x, y, contains(shape, middle) ? 1 : 0];
  });
}

/** The reference's own centroid size, in true units where its file gives a scale. */
export function referenceSize({ reference, points }: Plan): number {
  return centroidSize(own(points, reference.box)) * (reference.scale ?? 1);
}

type Configuration = { readonly name: string; readonly points: Float64Array; readonly subject: Subject };

function configurations({ reference, points }: Plan, rows: readonly Row[]): Configuration[] {
  const first = { name: reference.name, points: own(points, reference.box), subject: reference };
  const others = rows.flatMap(({ name, match, target }) =>
    match && target ? [{ name, points: match.points, subject: target }] : [],
  );
  return [first, ...others];
}

/** Moved so that no coordinate is negative, where one is; by how much, or null. */
function positive(points: Float64Array): readonly [Float64Array, readonly [number, number] | null] {
  const least = [0, 1].map((part) => points.reduce((low, v, i) => (i % 2 === part ? Math.min(low, v) : low), 0));
  if (least.every((low) => low === 0)) return [points, null];
  const by = [-least[0], -least[1]] as const;
  // What was the least is 0 then, and not some rounding below it.
  return [points.map((value, i) => Math.max(0, value + by[i % 2])), by];
}

function csv(lines: readonly (readonly Value[])[]): string {
  return `${lines.map((line) => line.map(field).join(",")).join("\n")}\n`;
}

function field(value: Value): string {
  const text = String(value ?? "");
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
