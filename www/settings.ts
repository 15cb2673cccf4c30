/** The settings that the page offers: names in plain words, ranges, help. Defaults are the solver's own. */

import type { Settings } from "./protocol";

type Common = {
  readonly name: keyof Settings;
  readonly label: string;
  readonly help: string;
  readonly group: "Energies" | "Grid" | "Method";
};

export type NumberSetting = Common & {
  readonly kind: "number";
  readonly initial: number;
  readonly least: number;
  readonly most: number;
  readonly step: number;
  readonly unit: string;
};

export type ChoiceSetting = Common & {
  readonly kind: "choice";
  readonly initial: string | number | boolean;
  readonly options: readonly { readonly value: string | number | boolean; readonly label: string }[];
};

export type SettingField = NumberSetting | ChoiceSetting;
export type Chosen = Partial<Settings>;

export const FIELDS: readonly SettingField[] = [
  {
    kind: "number",
    name: "membrane",
    label: "Stretching",
    group: "Energies",
    help: "How much the shell resists being stretched along the curve. 0 leaves it out.",
    initial: 1,
    least: 0,
    most: 100,
    step: 0.1,
    unit: "",
  },
  {
    kind: "number",
    name: "bending",
    label: "Bending",
    group: "Energies",
    help: "How much the shell resists a change of curvature. 0 leaves it out.",
    initial: 1,
    least: 0,
    most: 100,
    step: 0.1,
    unit: "",
  },
  {
    kind: "choice",
    name: "bendingModel",
    label: "Bending compares",
    group: "Energies",
    help: "The relative shape operator sees direction too; mean curvature alone is the simpler alternative.",
    initial: "shape-operator",
    options: [
      { value: "shape-operator", label: "shape operators" },
      { value: "mean-curvature", label: "mean curvatures" },
    ],
  },
  {
    kind: "number",
    name: "thickness",
    label: "Thickness δ",
    group: "Energies",
    help: "Of the shell, on the coarsest grid. Stretching counts δ times, bending δ³ times.",
    initial: 0.5,
    least: 0.001,
    most: 10,
    step: 0.05,
    unit: "box sides",
  },
  {
    kind: "number",
    name: "penalty",
    label: "Fit 1/ε",
    group: "Energies",
    help: "How strongly the first curve is drawn onto the second, on the coarsest grid.",
    initial: 1000,
    least: 0.001,
    most: 10_000_000,
    step: 100,
    unit: "per side²",
  },
  {
    kind: "number",
    name: "volume",
    label: "Volume ξ",
    group: "Energies",
    help: "How much the plane around the curve resists being deformed.",
    initial: 0.001,
    least: 0.000001,
    most: 1000,
    step: 0.001,
    unit: "",
  },
  {
    kind: "choice",
    name: "finest",
    label: "Finest grid",
    group: "Grid",
    help: "The match is refined up to this grid.",
    initial: 7,
    options: [
      { value: 5, label: "33 × 33" },
      { value: 6, label: "65 × 65" },
      { value: 7, label: "129 × 129" },
      { value: 8, label: "257 × 257" },
    ],
  },
  {
    kind: "number",
    name: "bandwidth",
    label: "Band σ",
    group: "Grid",
    help: "Half width of the shell's band around the reference. 0 chooses it from the finest grid.",
    initial: 0,
    least: 0,
    most: 0.25,
    step: 0.01,
    unit: "box sides",
  },
  {
    kind: "number",
    name: "vertexShare",
    label: "Corner share θ",
    group: "Grid",
    help: "Part of the volume term taken at cell corners, which keeps cells from folding there. 0 is the paper.",
    initial: 0.25,
    least: 0,
    most: 1,
    step: 0.05,
    unit: "",
  },
  {
    kind: "choice",
    name: "halving",
    label: "Per finer grid",
    group: "Grid",
    help: "Halving thickness and ε with the cell size sharpens the match level by level.",
    initial: true,
    options: [
      { value: true, label: "halve δ and ε" },
      { value: false, label: "keep δ and ε" },
    ],
  },
  {
    kind: "choice",
    name: "align",
    label: "Start from",
    group: "Method",
    help: "The best similarity moves, turns and scales the reference towards the template first; the paper starts from the identity.",
    initial: "similarity",
    options: [
      { value: "similarity", label: "the best similarity" },
      { value: "none", label: "the identity" },
    ],
  },
  {
    kind: "choice",
    name: "minimizer",
    label: "Minimiser",
    group: "Method",
    help: "Newton's method takes a few costly steps, the paper's conjugate gradients many cheap ones.",
    initial: "newton",
    options: [
      { value: "newton", label: "projected Newton" },
      { value: "ncg", label: "conjugate gradients" },
    ],
  },
];

/** Reads what a form or a link says. Throws a sentence for what the setting cannot be. */
export function parseSetting(field: SettingField, text: string): number | string | boolean {
  if (field.kind === "choice") {
    const option = field.options.find((candidate) => String(candidate.value) === text);
    if (option) return option.value;
    const known = field.options.map((candidate) => candidate.value).join(", ");
    throw new Error(`${field.label} is “${text}”, but must be one of ${known}`);
  }
  const value = text.trim() === "" ? Number.NaN : Number(text);
  if (!(value >= field.least && value <= field.most)) {
    throw new Error(`${field.label} is “${text}”, but must be a number from ${field.least} to ${field.most}`);
  }
  return value;
}

/** The settings with one more chosen; one equal to its default is left out. */
export function withSetting(chosen: Chosen, field: SettingField, value: number | string | boolean): Chosen {
  const { [field.name]: _, ...others } = chosen;
  return value === field.initial ? others : { ...others, [field.name]: value };
}

/** Every setting of the page by value: what an update of a run needs, where a field left out keeps its last value. */
export function complete(chosen: Chosen): Settings {
  return Object.fromEntries(FIELDS.map(({ name, initial }) => [name, chosen[name] ?? initial]));
}

/** Half width of the band in domain units, as the solver chooses it. */
export function bandwidth(chosen: Chosen): number {
  return chosen.bandwidth || Math.max(0.05, 1.5 / 2 ** finestLevel(chosen));
}

export function finestLevel(chosen: Chosen): number {
  return chosen.finest ?? 7;
}
