/** Which tool the hand holds, the same on both surfaces. Signals; no DOM. */

import { signal } from "@preact/signals";
import { begun, chosen, fetchKit } from "../pins/kit";

export type Tool = "draw" | "pin";

export const tool = signal<Tool>("draw");

/** What has just been done, for those who hear the page. */
export const said = signal("");

/** Takes up the tool, after fetching it. Throws a sentence when that fails. */
export async function choose(wanted: Tool): Promise<void> {
  if (wanted === "pin") await fetchKit();
  said.value = "";
  begun.value = null;
  chosen.value = null;
  tool.value = wanted;
}
