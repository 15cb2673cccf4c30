/** What is about to be imported and how it will be: everything the dialog's controls change. */

import { type Placement, type Prepared, prepared } from "../shapes/import/fit";
import type { Choice, Found, Picture } from "../shapes/import/found";
import type { Holes, Parts } from "../shapes/import/parts";
import { type Traced, traced } from "../shapes/import/trace";

export type Draft = {
  /** The file's name, or what else it came from. */
  readonly source: string;
  readonly choices: readonly Choice[];
  readonly chosen: number;
  readonly notes: readonly string[];
  readonly picture: Picture | null;
  /** The picture, small, to lie under its outline. */
  readonly preview: ImageBitmap | null;
  readonly threshold: number;
  readonly flipped: boolean;
  readonly parts: Parts;
  readonly holes: Holes;
  readonly placement: Placement;
  /** In cells. */
  readonly smoothing: number;
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

export function begun(found: Exclude<Found, { kind: "saved" }>, source: string, preview: ImageBitmap | null): Draft {
  const choices = found.kind === "shapes" ? found.choices : [];
  const picture = found.kind === "picture" ? found.picture : null;
  return withChoice(
    {
      source,
      choices,
      chosen: 0,
      notes: found.notes,
      picture,
      preview,
      threshold: picture?.threshold ?? 0,
      flipped: picture?.borderIsInk ?? false,
      parts: "all",
      holes: "keep",
      placement: "fit",
      smoothing: 0,
    },
    0,
  );
}

/** The smoothing that outlines of pictures begin with, in cells: their pixels are steps. */
const PIXELS = 1;

/** Each choice begins as its file means it. */
export function withChoice(draft: Draft, chosen: number): Draft {
  const choice = draft.choices[chosen];
  return {
    ...draft,
    chosen,
    parts: choice?.mainPart ? "largest" : "all",
    placement: choice?.placed ? "asIs" : "fit",
    smoothing: choice?.smoothing ?? PIXELS,
  };
}

export function outcome(draft: Draft): Outcome {
  const trace = draft.picture && outline(draft.picture, draft.threshold, draft.flipped);
  const choice = draft.choices[draft.chosen];
  const loops = trace?.loops ?? choice?.loops ?? [];
  const facts = { loops: loops.length, placed: choice?.placed ?? false };
  const notes = [...draft.notes];
  if (trace?.cut) notes.push("The shape reaches the picture's edge and is cut there.");
  if (trace && trace.loops.length === 0) {
    return { ...facts, prepared: null, problem: "Nothing is inside at this threshold; move the slider.", notes };
  }
  try {
    const result = prepared(loops, draft);
    return { ...facts, prepared: result, problem: null, notes: [...notes, ...result.notes] };
  } catch (error) {
    return { ...facts, prepared: null, problem: error instanceof Error ? error.message : String(error), notes };
  }
}

/** The last outline: the other controls leave it as it is, and tracing is the only slow step. */
let last: { picture: Picture; threshold: number; flipped: boolean; trace: Traced } | null = null;

function outline(picture: Picture, threshold: number, flipped: boolean): Traced {
  if (last?.picture !== picture || last.threshold !== threshold || last.flipped !== flipped) {
    last = { picture, threshold, flipped, trace: traced(picture, threshold, flipped) };
  }
  return last.trace;
}
