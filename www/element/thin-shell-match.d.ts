/** `<thin-shell-match>` and its anywidget, as the package has them: docs/element.md in the sources says how they are used. */

import type { Settings, Status } from "../wasm/thinshell.js";

/** A closed polygon in the unit box, y up: x y x y …, or a list of points. */
export type GivenLoop = ArrayLike<number> | readonly GivenPoint[];
export type GivenPoint = readonly [x: number, y: number];
/** A point of the reference and its partner on the template. */
export type GivenPin = readonly [x: number, y: number, u: number, v: number];

/** The numbers of a final match. */
export type Report = Pick<
  Status,
  "level" | "iteration" | "evaluations" | "energies" | "leastDeterminant" | "mismatch" | "cover" | "measure" | "stretch"
> & { readonly verdict: string | null };

export declare const TAG = "thin-shell-match";

/** Setters throw a sentence where something cannot be taken, and then nothing has changed. */
export declare class ThinShellMatch extends HTMLElement {
  reference: readonly GivenLoop[];
  template: readonly GivenLoop[];
  pins: readonly GivenPin[];
  settings: Partial<Omit<Settings, "pins">>;
  view: string;
  /** 0 shows the identity, 1 the match. */
  morph: number;
  /** Of the final match of what is given now; null before. */
  readonly report: Report | null;
  readonly problem: string | null;
  /** φ at points of the box; null without a match. */
  map(points: readonly GivenPoint[]): [number, number][] | null;
  addEventListener<Name extends keyof ThinShellMatchEventMap>(
    type: Name,
    heard: (this: ThinShellMatch, event: ThinShellMatchEventMap[Name]) => unknown,
    options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener(
    type: string,
    heard: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
}

export interface ThinShellMatchEventMap extends HTMLElementEventMap {
  /** A match is final. */
  match: CustomEvent<Report>;
  /** What is wrong, in a sentence. */
  problem: CustomEvent<string>;
}

declare global {
  interface HTMLElementTagNameMap {
    "thin-shell-match": ThinShellMatch;
  }
}

/** The anywidget: what a notebook's front end calls. */
declare const widget: {
  render(given: {
    model: {
      get(name: string): unknown;
      set(name: string, value: unknown): void;
      save_changes(): void;
      on(event: string, heard: () => void): void;
      off(event: string, heard: () => void): void;
    };
    el: HTMLElement;
  }): () => void;
};
export default widget;
