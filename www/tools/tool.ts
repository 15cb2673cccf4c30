/** Which tool the hand holds, the same on both surfaces. Signals; no DOM. */

import { signal } from "@preact/signals";
import { fetched } from "../controls/fetched";
import { begun, chosen, fetchKit as fetchPins } from "../pins/kit";
import { en } from "../words/en";
import { fetchKit } from "./kit";

export type ToolName = "draw" | "circle" | "polygon" | "mirror" | "points" | "pin";

export const tool = signal<ToolName>("draw");

/** What puts a tool into the hand; the page is seen before it is there. */
export const hands = signal<typeof import("../controls/hand") | null>(null);

/** Throws a sentence when they cannot be had. */
export async function fetchHands(): Promise<typeof import("../controls/hand")> {
  hands.value ??= await fetched(en.missing.draw, () => import("../controls/hand"));
  return hands.value;
}

/** What has just been done, for those who hear the page. */
export const said = signal("");

/** Takes up the tool, after fetching it. Throws a sentence when that fails. */
export async function choose(wanted: ToolName): Promise<void> {
  if (wanted === "pin") await fetchPins();
  else if (wanted !== "draw") await fetchKit();
  said.value = "";
  begun.value = null;
  chosen.value = null;
  tool.value = wanted;
}
