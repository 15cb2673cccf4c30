/** What is about to be imported and how it will be: everything the dialog's controls change. */

import type { Offer, Selection } from "../shapes/import/content";

export type Draft = Offer &
  Selection & {
    /** The file's name, or what else it came from. */
    readonly source: string;
    /** The picture, small, to lie under its outline. */
    readonly preview: ImageBitmap | null;
  };

export function begun(offer: Offer, source: string, preview: ImageBitmap | null): Draft {
  return withChoice(
    {
      ...offer,
      source,
      chosen: 0,
      preview,
      threshold: offer.picture?.threshold ?? 0,
      flipped: offer.picture?.borderIsInk ?? false,
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

export function selectionOf(draft: Draft): Selection {
  const { chosen, threshold, flipped, parts, holes, placement, smoothing } = draft;
  return { chosen, threshold, flipped, parts, holes, placement, smoothing };
}
