/** What an import is made of once it has been read, and what becomes of it under the user's wishes. */

import type { Shape } from "../geometry";
import { type Prepared, prepared, type Wishes } from "./fit";
import type { Choice, Found, Picture } from "./found";
import { type Traced, traced } from "./trace";

/** A choice without its loops: what there is to choose from. */
export type Offered = Omit<Choice, "loops">;

/** What has been found, without what only the work on it needs. */
export type Offer = {
  readonly choices: readonly Offered[];
  readonly notes: readonly string[];
  readonly picture: Omit<Picture, "ink"> | null;
  readonly firstIsAll: boolean;
};

export type Selection = Wishes & {
  /** The index of the choice, where there are some. */
  readonly chosen: number;
  /** Of a picture: what is above the threshold is inside, or, flipped, what is below it. */
  readonly threshold: number;
  readonly flipped: boolean;
};

export type Outcome = {
  /** Null when nothing can be taken: then `problem` says why. */
  readonly prepared: Prepared | null;
  readonly problem: string | null;
  readonly notes: readonly string[];
  /** Whether the shape in question has parts, or holes, to choose about. */
  readonly loops: number;
  readonly placed: boolean;
};

export class Content {
  readonly offer: Offer;
  private readonly choices: readonly Choice[];
  private readonly picture: Picture | null;
  /** The last outline: most wishes leave it as it is, and tracing is slow. */
  private last: { readonly threshold: number; readonly flipped: boolean; readonly trace: Traced } | null = null;

  constructor(found: Exclude<Found, { kind: "saved" }>) {
    this.choices = found.kind === "shapes" ? found.choices : [];
    this.picture = found.kind === "picture" ? found.picture : null;
    this.offer = {
      choices: this.choices.map(({ loops: _, ...choice }) => choice),
      notes: found.notes,
      picture: this.picture && withoutInk(this.picture),
      firstIsAll: found.kind === "shapes" && found.firstIsAll === true,
    };
  }

  outcome(wishes: Selection): Outcome {
    const trace = this.picture && this.outline(this.picture, wishes);
    const choice = this.choices[wishes.chosen];
    const loops: Shape = trace?.loops ?? choice?.loops ?? [];
    const facts = { loops: loops.length, placed: choice?.placed ?? false };
    const notes = trace?.cut ? ["The shape reaches the picture's edge and is cut there."] : [];
    if (choice?.problem !== undefined) return { ...facts, prepared: null, problem: choice.problem, notes };
    if (trace && trace.loops.length === 0) {
      return { ...facts, prepared: null, problem: "Nothing is inside at this threshold; move the slider.", notes };
    }
    try {
      const result = prepared(loops, wishes);
      return { ...facts, prepared: result, problem: null, notes: [...notes, ...result.notes] };
    } catch (error) {
      return { ...facts, prepared: null, problem: error instanceof Error ? error.message : String(error), notes };
    }
  }

  private outline(picture: Picture, { threshold, flipped }: Selection): Traced {
    if (this.last?.threshold !== threshold || this.last.flipped !== flipped) {
      this.last = { threshold, flipped, trace: traced(picture, threshold, flipped) };
    }
    return this.last.trace;
  }
}

function withoutInk({ width, height, threshold, borderIsInk }: Picture): Omit<Picture, "ink"> {
  return { width, height, threshold, borderIsInk };
}
