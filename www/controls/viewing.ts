/** How matches are looked at, the same for every canvas that shows one. */

import { signal } from "@preact/signals";
import type { View } from "../view/names";
import type { Probe } from "../view/probe";
import type { Picture } from "../view/raster";

export const view = signal<View>("grid");

/** The place on the reference that is pointed at. */
export const probe = signal<Probe | null>(null);

/** What draws all views but the grid, once it is there: no part of the first load. */
export const lazy = signal<{
  readonly views: typeof import("../view/views");
  readonly pictures: typeof import("../view/picture");
} | null>(null);

/** The picture that the image views carry along. */
export const picture = signal<Picture | null>(null);

/** Shows the view, after fetching what draws it. Throws a sentence when that fails. */
export async function choose(wanted: View): Promise<void> {
  if (wanted !== "grid" && !lazy.value) {
    try {
      const [views, pictures] = await Promise.all([import("../view/views"), import("../view/picture")]);
      picture.value ??= pictures.pattern();
      lazy.value = { views, pictures };
    } catch {
      throw new Error("This view could not be loaded; check the connection, or reload the page.");
    }
  }
  view.value = wanted;
}
