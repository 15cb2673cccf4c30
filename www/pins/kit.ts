/** What the page knows of pins before it can do anything with them. */

import { signal } from "@preact/signals";
import { fetched } from "../controls/fetched";
import type { Point } from "../shapes/geometry";
import { en } from "../words/en";

type Kit = typeof import("./index");

/** Draws, sets and reports pins, once it is there. */
export const kit = signal<Kit | null>(null);

/** Throws a sentence when it cannot be had. */
export async function fetchKit(): Promise<void> {
  kit.value ??= await fetched(en.missing.pins, () => import("./index"));
}

/** The end of a pin that waits for its partner. */
export const begun = signal<{ readonly side: "reference" | "template"; readonly point: Point } | null>(null);

/** The pin that can be deleted, counted from 0. */
export const chosen = signal<number | null>(null);
