/**
 * Conditions on a match, as lessons write them: what an exercise asks for, and what a step says is true.
 *
 *     stretch.deviation < 0.05
 *     setting bending = 0
 *     pins <= 2
 *     point 0.76 0.44 -> 0.67 0.62 within 0.05
 *     shapes unchanged
 */

import { FIELDS, parseSetting } from "../settings";

type Pair = readonly [number, number];

/** Numbers of a report that conditions can be on. */
export const NUMBERS = [
  "stretch.mean",
  "stretch.deviation",
  "mismatch.mean",
  "mismatch.max",
  "cover.mean",
  "cover.max",
  "measure",
  "leastDeterminant",
  "iteration",
  "evaluations",
  "energies.membrane",
  "energies.bending",
  "energies.mismatch",
  "energies.volume",
  "energies.total",
] as const;

export type NumberName = (typeof NUMBERS)[number];
const SIGNS = ["<", ">", "<=", ">=", "="] as const;
export type Sign = (typeof SIGNS)[number];

export type Check =
  | { readonly kind: "number"; readonly name: NumberName; readonly sign: Sign; readonly value: number }
  | { readonly kind: "setting"; readonly name: string; readonly sign: Sign; readonly value: number | string | boolean }
  | { readonly kind: "pins"; readonly sign: Sign; readonly value: number }
  | { readonly kind: "point"; readonly from: Pair; readonly to: Pair; readonly within: number }
  | { readonly kind: "shapes" };

/** What conditions are looked up in. */
export type Known = {
  readonly number: (name: NumberName) => number;
  /** With its default where nothing else is chosen. */
  readonly setting: (name: string) => number | string | boolean;
  readonly pins: number;
  readonly shapesKept: boolean;
  readonly map: (point: Pair) => Pair;
};

export type Outcome = {
  readonly holds: boolean;
  /** What was found: a number, or how far off a point is. */
  readonly found: number | string | boolean;
};

/** Throws a sentence's part for what is no condition. */
export function parseCheck(text: string): Check {
  const words = text.trim().split(/\s+/);
  const [first] = words;
  if (text.trim() === "shapes unchanged") return { kind: "shapes" };
  if (first === "point") return pointCheck(text, words);
  if (first === "setting" && words.length === 4) {
    const field = FIELDS.find(({ name }) => name === words[1]);
    if (!field) throw new Error(`there is no setting “${words[1]}”`);
    const value = parseSetting(field, words[3]);
    const sign = signOf(words[2]);
    if (field.kind === "choice" && sign !== "=") throw new Error(`${field.name} can only be compared by =`);
    return { kind: "setting", name: field.name, sign, value };
  }
  if (words.length !== 3) throw new Error(`“${text}” is no condition: it must be like stretch.deviation < 0.05`);
  if (first === "pins") return { kind: "pins", sign: signOf(words[1]), value: finite(words[2]) };
  const name = NUMBERS.find((known) => known === first);
  if (!name) throw new Error(`there is no number “${first}”; there are ${NUMBERS.join(", ")}`);
  return { kind: "number", name, sign: signOf(words[1]), value: finite(words[2]) };
}

function pointCheck(text: string, words: readonly string[]): Check {
  const [, x, y, arrow, u, v, within, distance, ...more] = words;
  if (arrow !== "->" || within !== "within" || distance === undefined || more.length > 0)
    throw new Error(`“${text}” must be like point 0.3 0.4 -> 0.5 0.6 within 0.05`);
  return { kind: "point", from: [finite(x), finite(y)], to: [finite(u), finite(v)], within: finite(distance) };
}

export function evaluate(check: Check, known: Known): Outcome {
  switch (check.kind) {
    case "shapes":
      return { holds: known.shapesKept, found: known.shapesKept };
    case "point": {
      const [x, y] = known.map(check.from);
      const off = Math.hypot(x - check.to[0], y - check.to[1]);
      return { holds: off <= check.within, found: off };
    }
    case "pins":
      return { holds: compared(known.pins, check.sign, check.value), found: known.pins };
    case "setting": {
      const found = known.setting(check.name);
      return { holds: compared(found, check.sign, check.value), found };
    }
    case "number": {
      const found = known.number(check.name);
      return { holds: compared(found, check.sign, check.value), found };
    }
  }
}

/** What a dotted name stands for in a report's numbers. */
export function numberIn(numbers: object, name: NumberName): number {
  const value = name.split(".").reduce<unknown>((held, key) => (held as Record<string, unknown>)[key], numbers);
  return typeof value === "number" ? value : Number.NaN;
}

function compared<T extends number | string | boolean>(found: T, sign: Sign, value: T): boolean {
  if (sign === "=") return found === value;
  if (sign === "<") return found < value;
  if (sign === ">") return found > value;
  return sign === "<=" ? found <= value : found >= value;
}

function signOf(text: string): Sign {
  const sign = SIGNS.find((known) => known === text);
  if (!sign) throw new Error(`“${text}” compares nothing; there are ${SIGNS.join(" ")}`);
  return sign;
}

function finite(text: string): number {
  const value = text === undefined || text === "" ? Number.NaN : Number(text);
  if (!Number.isFinite(value)) throw new Error(`“${text}” is no number`);
  return value;
}
