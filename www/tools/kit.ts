/** What the page knows of the further tools before they are there. */

import { signal } from "@preact/signals";
import { fetched } from "../controls/fetched";
import { en } from "../words/en";
import type { Outline } from "./outline";
import type { Points } from "./points";

/** Circle, polygon, mirror and what is done to one curve, once it is there. */
export const kit = signal<typeof import("./index") | null>(null);

/** Throws a sentence when it cannot be had. */
export async function fetchKit(): Promise<void> {
  kit.value ??= await fetched(en.missing.tool, () => import("./index"));
}

/** The outline that waits for its next point, and how many it has. */
export const open = signal<{ readonly outline: Outline; readonly count: number } | null>(null);

/** The curve that is smoothed or deleted. */
export const curve = signal<{ readonly side: "reference" | "template"; readonly loop: number } | null>(null);

/** The knot of a curve that is marked, and whose tool it is. */
export const knot = signal<{ readonly tool: Points; readonly loop: number; readonly index: number } | null>(null);
