/** What has been typed, as what is to be done. */

import { parseArgs } from "node:util";
import { type Chosen, FIELDS, parseSetting, withSetting } from "../www/settings";

/** Something to be said in a sentence, without a stack. */
export class Refusal extends Error {}

export type Wanted = {
  readonly reference: string;
  readonly targets: readonly string[];
  readonly out: string;
  /** Semilandmarks a shape. */
  readonly points: number;
  /** Of each shape only its largest part, without its holes. */
  readonly outline: boolean;
  readonly strains: boolean;
  readonly settings: Chosen;
};

const MOST_POINTS = 10_000;

export const USAGE = `Usage: thinshell match REFERENCE TARGET … [options]

Matches one reference with each of many targets. Files are SVG, GeoJSON, JSON, TPS or CSV; a folder stands for those in it.

  --out FOLDER         where everything is written (default: matches)
  --points N           corresponding semilandmarks a shape (default: 100)
  --outline            only the largest part of each shape, its holes filled
  --strains            principal strains and expansion of each match, cell by cell
  --set NAME=VALUE     a setting, as often as wanted: ${FIELDS.map(({ name }) => name).join(", ")}
  --help, --version

Writes table.csv, semilandmarks.tps, semilandmarks.csv, and for each match NAME.json, which the page opens.
Ctrl-C ends it, and keeps what is finished.`;

/** Throws a `Refusal`. Null where only help is wanted. */
export function wantedIn(args: readonly string[]): Wanted | "help" | "version" {
  const { values, positionals } = parsed(args);
  if (values.version) return "version";
  if (values.help || args.length === 0) return "help";
  const [command, reference, ...targets] = positionals;
  if (command !== "match") throw new Refusal(`There is no command “${command}”, only match.`);
  if (reference === undefined) throw new Refusal("Name a reference and the targets to match it with.");
  if (targets.length === 0) throw new Refusal(`Name the targets to match ${reference} with.`);
  const points = Number(values.points);
  if (!(Number.isInteger(points) && points >= 3 && points <= MOST_POINTS)) {
    throw new Refusal(`--points is “${values.points}”, but must be a whole number from 3 to ${MOST_POINTS}.`);
  }
  const { out, outline, strains } = values;
  if (out === "") throw new Refusal("--out names no folder.");
  return { reference, targets, out, points, outline, strains, settings: chosenIn(values.set) };
}

function parsed(args: readonly string[]) {
  try {
    return parseArgs({
      args: [...args],
      allowPositionals: true,
      options: {
        out: { type: "string", default: "matches" },
        points: { type: "string", default: "100" },
        outline: { type: "boolean", default: false },
        strains: { type: "boolean", default: false },
        set: { type: "string", multiple: true, default: [] },
        help: { type: "boolean", short: "h", default: false },
        version: { type: "boolean", default: false },
      },
    });
  } catch (error) {
    throw new Refusal(error instanceof Error ? error.message : String(error));
  }
}

function chosenIn(given: readonly string[]): Chosen {
  return given.reduce<Chosen>((chosen, text) => {
    const [name, ...rest] = text.split("=");
    const field = FIELDS.find((candidate) => candidate.name === name);
    if (!field) {
      throw new Refusal(`There is no setting “${name}”; they are ${FIELDS.map((known) => known.name).join(", ")}.`);
    }
    try {
      return withSetting(chosen, field, parseSetting(field, rest.join("=")));
    } catch (error) {
      throw new Refusal(`${error instanceof Error ? error.message : error}.`);
    }
  }, {});
}
