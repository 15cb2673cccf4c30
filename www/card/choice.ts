/** Whether a run is given to the solver that can compute on a graphics card. Comes on demand. */

import { fetched } from "../controls/fetched";
import type { Engine } from "../engine";
import type { Settings } from "../protocol";
import { later } from "../words/later";

/**
 * The engine for such settings, in place of another. Where the card is insisted on, the solver itself says that there is
 * none; where the faster one is to compute, it is not even fetched without a card. Rejects with a sentence.
 */
export async function engineFor(
  { backend }: Partial<Settings>,
  space: "plane" | "space",
  otherwise: Engine,
): Promise<Engine> {
  const load = async () => (await import("./engines")).engines[space];
  if (backend === "gpu") return fetched(later.card.solver, load);
  return (await isThere()) ? load().catch(() => otherwise) : otherwise;
}

/** A card that no processor plays. */
async function isThere(): Promise<boolean> {
  // Browsers that have none say so by its absence, whatever the types promise.
  const { gpu } = navigator as Partial<Navigator>;
  const adapter = await gpu?.requestAdapter().catch(() => null);
  return Boolean(adapter && !adapter.info.isFallbackAdapter && adapter.info.architecture !== "swiftshader");
}
