/** How the match is looked at, as far as a link tells it: the page's views come on demand. */

import type { ReadonlySignal } from "@preact/signals";
import type { View } from "../view/names";

export type Looks = {
  readonly view: ReadonlySignal<View>;
  /** Rejects with a sentence where the view cannot be had. */
  choose(view: View): Promise<void>;
};
