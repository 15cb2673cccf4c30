/**
 * What an experiment is. Experiments know shapes, settings and what is measured; where the solver runs (Node, a worker)
 * is their caller's business.
 */

import type { Registration, Settings, Shape } from "../wasm/thinshell.js";
import { withPower } from "../words/numbers";

export type { Registration, Settings, Shape, Status } from "../wasm/thinshell.js";

/** The solver's door: `Registration` of the wasm package. */
export type Solver = {
  create(reference: Shape, template: Shape, settings?: Partial<Settings>): Promise<Registration>;
};

export type Context = {
  readonly solver: Solver;
  /** The wall clock, milliseconds. */
  readonly millis: () => number;
  /** Called between solver steps: how much is done, 0 to 1, and what is going on. */
  readonly progress: (done: number, doing: string) => void | Promise<void>;
};

/** "short" keeps to sizes that a test or an impatient reader can wait for. */
export type Size = "full" | "short";

/** What comes out, in reading order. Texts are plain sentences. */
export type Block =
  | { readonly kind: "text"; readonly text: string }
  | { readonly kind: "table"; readonly head: readonly string[]; readonly rows: readonly (readonly string[])[] }
  /** `name` is the file's, without its ending. */
  | { readonly kind: "figure"; readonly name: string; readonly svg: string; readonly caption: string };

export type Study = {
  /** Stands in links; never changes. */
  readonly id: string;
  readonly title: string;
  /** What the paper does and sees. */
  readonly paper: string;
  /** What is done here: shapes, settings, what is measured. */
  readonly setup: string;
  /** Whether "short" is another computation than "full". */
  readonly hasShortForm: boolean;
  readonly run: (context: Context, size: Size) => Promise<Block[]>;
};

/** With curves. */
export type Experiment = Study & {
  /** The pair that says most, to be opened in the page. */
  readonly example: () => {
    readonly reference: Shape;
    readonly template: Shape;
    readonly settings: Partial<Settings>;
  };
};

/** With surfaces: the pair that says most is one of the page's gallery. */
export type SolidExperiment = Study & {
  readonly example: {
    readonly reference: string;
    readonly template: string;
    readonly settings: Partial<Settings>;
  };
};

export function text(...sentences: string[]): Block {
  return { kind: "text", text: withMinus(sentences.join(" ")) };
}

export function table(head: readonly string[], rows: readonly (readonly string[])[]): Block {
  return { kind: "table", head, rows: rows.map((row) => row.map(withMinus)) };
}

/** A true minus before every number that has one. */
export function withMinus(words: string): string {
  return words.replace(/(?<=^|[\s(])-(?=\d)/g, "−");
}

/** What stands under a letter, as in α_bend. */
export const INDEX = /(?<=\p{L})_(\p{L}+)/gu;

/** Nodes a side on a level, as tables name it. */
export function nodes(level: number): string {
  return `${2 ** level + 1}²`;
}

/** A length in cells; two digits below one cell, fewer above. */
export function cells(value: number): string {
  return value.toFixed(value < 10 ? 2 : 1);
}

export function seconds(millis: number): string {
  return `${(millis / 1000).toFixed(millis < 10_000 ? 2 : 1)} s`;
}

/** A determinant or another small positive number. */
export function small(value: number): string {
  return value >= 0.01 ? value.toFixed(3) : withPower(value, 1);
}
