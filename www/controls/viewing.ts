/** How matches are looked at, the same for every canvas that shows one. */

import { signal } from "@preact/signals";
import { kit } from "../pins/kit";
import type { Frame } from "../view/canvas";
import type { View } from "../view/names";
import type { Theme } from "../view/palette";
import type { Probe } from "../view/probe";
import type { Picture } from "../view/raster";
import { drawMissed, drawResult, type Match, type ResultScene } from "../view/result";
import { en } from "../words/en";
import { fetched } from "./fetched";

export const view = signal<View>("grid");

/** Whether nobody sees the page, so that nothing need move. */
export const resting = signal(false);

/** The place on the reference that is pointed at. */
export const probe = signal<Probe | null>(null);

/** What gives and shows the numbers there, once it is there. */
export const local = signal<typeof import("./Readout") | null>(null);

/** Throws a sentence when it cannot be had. */
export async function fetchLocal(): Promise<void> {
  local.value ??= await fetched(en.result.numbers, () => import("./Readout"));
}

/** An iteration that is looked at again, and what the picture says of it. */
export const past = signal<{ readonly match: Match; readonly words: string } | null>(null);

/** A guess under way, of one match: who points at the picture means the guess. */
export const guess = signal<{
  readonly of: Float64Array;
  /** What is asked, or what came out. */
  readonly says: string;
  readonly moved: (place: { readonly x: number; readonly y: number }) => void;
  readonly place: () => void;
  /** Whether the key was one of the guess's. */
  readonly key: (key: string) => boolean;
  readonly draw: (context: CanvasRenderingContext2D, frame: Frame) => void;
} | null>(null);

/** What is drawn over the picture of one match, and of no other. */
export const arrows = signal<{
  readonly of: Float64Array;
  readonly draw: (context: CanvasRenderingContext2D, frame: Frame, match: Match, morph: number) => void;
} | null>(null);

/** What draws all views but the grid, once it is there: no part of the first load. */
export const lazy = signal<{
  readonly views: typeof import("../view/views");
  readonly pictures: typeof import("../view/picture");
  readonly legends: typeof import("./Legend");
  readonly captions: Readonly<Record<View, string>>;
} | null>(null);

/** The picture that the image views carry along. */
export const picture = signal<Picture | null>(null);

/** Shows the view, after fetching what draws it. Throws a sentence when that fails. */
export async function choose(wanted: View): Promise<void> {
  if (wanted !== "grid" && !lazy.value) {
    const [views, pictures, legends, { captions }] = await fetched(en.missing.view, () =>
      Promise.all([import("../view/views"), import("../view/picture"), import("./Legend"), import("../words/later")]),
    );
    picture.value ??= pictures.pattern();
    lazy.value = { views, pictures, legends, captions };
  }
  view.value = wanted;
}

/** Where the chosen view's scale has to end for a match. */
export function limitOf(match: Match | null, bandwidth: number): number {
  return (match && lazy.value?.views.limitOf(view.value, match, bandwidth)) || 1;
}

/** Draws a match in the chosen view; without a match the shapes on the undeformed grid. */
export function draw(
  context: CanvasRenderingContext2D,
  frame: Frame,
  colours: Theme,
  scene: ResultScene,
  limit: number,
): void {
  const { match, morph, bandwidth, pins } = scene;
  const [painter, image] = [lazy.peek(), picture.peek()];
  if (view.peek() === "grid" || !match || !painter || !image) drawResult(context, frame, colours, scene);
  else {
    painter.views.drawView(view.peek(), context, frame, colours, { match, morph, bandwidth, limit, picture: image });
    // What is pulled back lies on the reference.
    if (view.peek() !== "pullback") drawMissed(context, frame, colours, scene.missed ?? []);
  }
  // What comes over it leaves no trace in the next picture.
  context.save();
  const over = arrows.peek();
  if (match && over?.of === match.deformation) over.draw(context, frame, match, morph);
  const asked = guess.peek();
  if (match && asked?.of === match.deformation) asked.draw(context, frame);
  context.restore();
  // What is pulled back is seen where it was.
  const shown = view.peek() === "pullback" ? 0 : morph;
  const tools = kit.peek();
  tools?.drawPinMarks(context, frame, colours, tools.pinMarks(pins, match, scene.reference, shown, colours.cycle));
}
