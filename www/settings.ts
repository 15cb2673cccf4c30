/** The settings that the page offers, as the solver declares them: what a form or a link says of them is read here. */

import type { Settings } from "./protocol";
import { OFFERED, type Offered } from "./wasm/offered.js";
import { page } from "./words/language";
import { links as say } from "./words/links";

type Common = {
  readonly name: Exclude<keyof Settings, "pins">;
  readonly label: string;
  /** As the formulas have it, an index after a low line; part of the label where it has none. */
  readonly symbol: string;
  readonly group: "Energies" | "Grid" | "Method";
};

export type NumberSetting = Common & {
  readonly kind: "number";
  readonly initial: number;
  readonly least: number;
  readonly most: number;
  readonly unit: string;
};

export type ChoiceSetting = Common & {
  readonly kind: "choice";
  readonly initial: string | number | boolean;
  readonly options: readonly { readonly value: string | number | boolean; readonly label: string }[];
};

export type SettingField = NumberSetting | ChoiceSetting;
export type Chosen = Partial<Settings>;

export const FIELDS: readonly SettingField[] = OFFERED.filter((setting) => setting.onPage).map(fieldOf);

// In other languages than the solver's.
page("settings", Object.fromEntries(FIELDS.map((field) => [field.name, field])));

function fieldOf(setting: Offered): SettingField {
  const { name, symbol, group } = setting;
  // A symbol with an index cannot be set as plain text.
  const label = symbol === "" || symbol.includes("_") ? setting.label : `${setting.label} ${symbol}`;
  const common = { name, label, symbol, group };
  switch (setting.kind) {
    case "number": {
      const [least, most] = setting.usual;
      return { ...common, kind: "number", initial: setting.initial, least, most, unit: setting.unit };
    }
    case "level": {
      const [first, last] = setting.usual;
      const levels = Array.from({ length: last - first + 1 }, (_, i) => first + i);
      const options = levels.map((value) => ({ value, label: `${2 ** value + 1} × ${2 ** value + 1}` }));
      return { ...common, kind: "choice", initial: setting.initial, options };
    }
    case "choice":
      return { ...common, kind: "choice", initial: setting.initial, options: setting.options };
  }
}

/** Reads what a form or a link says. Throws a sentence for what the setting cannot be. */
export function parseSetting(field: SettingField, text: string): number | string | boolean {
  const given = text.length > LONGEST ? `${text.slice(0, LONGEST)}…` : text;
  if (field.kind === "choice") {
    const option = field.options.find((candidate) => String(candidate.value) === text);
    if (option) return option.value;
    const known = field.options.map((candidate) => candidate.value).join(", ");
    throw new Error(say.noChoice(field.label, given, known));
  }
  const value = text.trim() === "" ? Number.NaN : Number(text);
  if (!(value >= field.least && value <= field.most)) {
    throw new Error(say.noNumber(field.label, given, field.least, field.most));
  }
  return value;
}

/** Characters of what was given that a message repeats. */
const LONGEST = 60;

/** The settings with one more chosen; one equal to its default is left out. */
export function withSetting(chosen: Chosen, field: SettingField, value: number | string | boolean): Chosen {
  const { [field.name]: _, ...others } = chosen;
  return value === field.initial ? others : { ...others, [field.name]: value };
}

/** The fields whose value is not the default. */
export function changedFields(chosen: Chosen): readonly SettingField[] {
  return FIELDS.filter((field) => chosen[field.name] !== undefined);
}

/** Every setting of the page by value: what an update of a run needs, where a field left out keeps its last value. */
export function complete(chosen: Chosen): Chosen {
  return Object.fromEntries(FIELDS.map(({ name, initial }) => [name, chosen[name] ?? initial]));
}

/** Whether two choices come to the same: one left out is its default. */
export function sameSettings(a: Chosen, b: Chosen): boolean {
  const [first, second] = [a, b].map((chosen) => ({ ...chosen, ...complete(chosen) })) as Record<string, unknown>[];
  // As text, for pins are lists; none of them are as good as an empty one.
  const text = (value: unknown) => String(value ?? "");
  return [...Object.keys(first), ...Object.keys(second)].every((name) => text(first[name]) === text(second[name]));
}

/** Half width of the band in domain units, as the solver chooses it. */
export function bandwidth(chosen: Chosen): number {
  return chosen.bandwidth || Math.max(0.05, 1.5 / 2 ** finestLevel(chosen));
}

/** The default of a level's setting. */
function level(name: "coarsest" | "finest"): number {
  const setting = OFFERED.find((candidate) => candidate.name === name);
  return setting?.kind === "level" ? setting.initial : Number.NaN;
}

const FINEST = level("finest");
const COARSEST = level("coarsest");

export function finestLevel(chosen: Chosen): number {
  return chosen.finest ?? FINEST;
}

export function coarsestLevel(chosen: Chosen): number {
  return chosen.coarsest ?? COARSEST;
}
