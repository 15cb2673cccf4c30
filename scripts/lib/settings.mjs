// What `describeSettings` of the solver says, as files: the package's settings.js, offered.js and their types, and
// docs/settings.md.

/** @typedef {import("../../www/wasm/settings.js").Setting} Setting */

const TYPES = `/** What can be said of every setting. */
export interface Words<Name extends keyof Settings = Exclude<keyof Settings, "pins">> {
  readonly name: Name;
  /** In formulas; empty where there is none. */
  readonly symbol: string;
  readonly group: "Energies" | "Grid" | "Method";
  /** Whether the page offers it. */
  readonly onPage: boolean;
  /** In plain words. */
  readonly label: string;
  readonly help: string;
}

/** A number from least to most; \`why\` not beyond. \`usual\` is what the page offers. */
export interface NumberSetting extends Words {
  readonly kind: "number";
  readonly initial: number;
  readonly least: number;
  readonly most: number;
  readonly why: string;
  readonly usual: readonly [number, number];
  readonly unit: string;
}

/** A level l of the grid: (2^l + 1)^D nodes. */
export interface LevelSetting extends Words {
  readonly kind: "level";
  readonly initial: number;
  readonly least: number;
  readonly most: number;
  readonly usual: readonly [number, number];
}

export interface ChoiceSetting extends Words {
  readonly kind: "choice";
  readonly initial: string | boolean;
  readonly options: readonly { readonly value: string | boolean; readonly label: string }[];
}

/** Points that are tied together; none by default. */
export interface PinsSetting extends Words<"pins"> {
  readonly kind: "pins";
}

export type Setting = NumberSetting | LevelSetting | ChoiceSetting | PinsSetting;

export declare const SETTINGS: readonly Setting[];
`;

/** @param {readonly Setting[]} settings */
export function settingsModule(settings) {
  return `// Written by scripts/wasm.mjs from the solver's declarations.\nexport const SETTINGS = ${JSON.stringify(settings, null, 1)};\n`;
}

/**
 * What a page has to know before it shows a form: of the settings that it offers, and of levels, all but explanations.
 * @param {readonly Setting[]} settings
 */
export function offeredModule(settings) {
  const offered = settings.filter(({ kind, onPage }) => kind !== "pins" && (onPage || kind === "level"));
  const brief = offered.map((setting) => ({ ...setting, help: undefined, why: undefined }));
  return `// Written by scripts/wasm.mjs from the solver's declarations.\nexport const OFFERED = ${JSON.stringify(brief, null, 1)};\n`;
}

export const OFFERED_TYPES = `/* Written by scripts/wasm.mjs. */

import type { ChoiceSetting, LevelSetting, NumberSetting } from "./settings.js";

/** What there is to know of the settings that the page offers, and of levels, but for explanations. */
export type Offered =
  | Omit<NumberSetting, "help" | "why">
  | Omit<LevelSetting, "help">
  | Omit<ChoiceSetting, "help">;

export declare const OFFERED: readonly Offered[];
`;

/** @param {readonly Setting[]} settings */
export function settingsTypes(settings) {
  const fields = settings.map((setting) => {
    const symbol = setting.symbol && `${setting.symbol}. `;
    return `  /** ${symbol}${setting.help} ${range(setting)}. */\n  ${setting.name}: ${type(setting)};\n`;
  });
  return `/* Written by scripts/wasm.mjs from the solver's declarations. */

/** The settings of a registration; lengths in domain units. */
export interface Settings {
${fields.join("")}}

${TYPES}`;
}

/** @param {readonly Setting[]} settings */
export function settingsDocument(settings) {
  const groups = /** @type {const} */ (["Energies", "Grid", "Method"]).map((group) => {
    const rows = settings
      .filter((setting) => setting.group === group)
      .map((setting) => [`\`${setting.name}\``, setting.symbol, what(setting), defaults(setting), allowed(setting)]);
    const lines = [["name", "", "what it does", "default", "can be"], Array(5).fill("---"), ...rows];
    return `## ${group}\n\n${lines.map((cells) => `| ${cells.join(" | ")} |`).join("\n")}\n`;
  });
  return `${HEAD}\n${groups.join("\n")}\n${FOOT}`;
}

const HEAD = `# Settings

Written by \`npm run settings\` from their declarations in \`src/settings/declaration.rs\`, from which the solver, the
TypeScript types and the page follow as well. All are optional; lengths are in units of the box [0,1]^D. Symbols are those
of the functional in \`src/lib.rs\`. Those marked ● are on the page.
`;

const FOOT = `## What goes with what

- \`finest\` is at least \`coarsest\`. For surfaces it is 5 by default and 7 at most.
- \`lambda\` is at least 2 \`mu\`. The law of shell and volume is μ/2 tr A + (λ−2μ)/8 det A + (λ+2μ)/8 / det A. With
  λ < 2μ its middle term is negative and grows faster than the first: a deformation that enlarges the box without bound
  has an energy without bound from below, so that there is nothing to find.
- \`bandwidth\` is 0, which takes the larger of 0.05 and 1.5 cells of the finest grid, or at least half such a cell. The
  shell is integrated at 3 Gauss points an axis of each cell; every point of a curve has one within √D √0.6 / 4 cells,
  0.27 in the plane and 0.34 in space, and a band narrower than that may lie between them unseen. On coarser grids the
  band is widened to 0.35 of their cells where it is narrower.
- \`thickness\` and \`penalty\` are those of the coarsest grid; with \`halving\` each finer one halves δ and ε.

## Why there are upper bounds

Energies are compared in double precision, but the hessian, from which the search takes its direction, is in single: it
keeps seven digits and overflows at 3·10³⁸. A weight a million times that of the other terms leaves nothing of them, and
all bounds together, on the finest grid, stay twenty powers of ten below the overflow. What is meant by an enormous
weight is reached by an ordinary one: only ratios of weights matter, so lower the others.
`;

/** @param {Setting} setting */
function type(setting) {
  if (setting.kind === "pins") return "Float64Array";
  if (setting.kind !== "choice") return "number";
  if (setting.options.every(({ value }) => typeof value === "boolean")) return "boolean";
  return setting.options.map(({ value }) => JSON.stringify(value)).join(" | ");
}

/**
 * Default and range, as a sentence without its stop.
 * @param {Setting} setting
 */
function range(setting) {
  if (setting.kind === "pins") return "Default none";
  if (setting.kind === "choice") return `Default ${JSON.stringify(setting.initial)}`;
  return `Default ${number(setting.initial)}, from ${number(setting.least)} to ${number(setting.most)}`;
}

/** @param {Setting} setting */
function what(setting) {
  const unit = setting.kind === "number" && setting.unit ? ` In ${setting.unit}.` : "";
  return `${setting.onPage ? "● " : ""}**${setting.label}.** ${setting.help}${unit}`;
}

/** @param {Setting} setting */
function defaults(setting) {
  if (setting.kind === "pins") return "none";
  return setting.kind === "choice" ? `\`${JSON.stringify(setting.initial)}\`` : number(setting.initial);
}

/** @param {Setting} setting */
function allowed(setting) {
  if (setting.kind === "pins") return "a Float64Array of at most 1000 pins within the box";
  if (setting.kind === "choice")
    return setting.options.map(({ value, label }) => `\`${JSON.stringify(value)}\` (${label})`).join(", ");
  const ends = `${number(setting.least)} to ${number(setting.most)}`;
  return setting.kind === "level" ? `a whole number, ${ends}` : `${ends}: ${setting.why}`;
}

/**
 * With an exponent where zeros would have to be counted, as in the solver's messages.
 * @param {number} value
 */
function number(value) {
  const plain = value === 0 || (Math.abs(value) >= 1e-3 && Math.abs(value) < 1e6);
  return plain ? String(value) : value.toExponential().replace("e+", "e");
}
