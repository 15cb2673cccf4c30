/** What the page can do around surfaces, for those who show them. */

import type { Side } from "./session";

export type Ways = {
  readonly leave: () => void;
  /** Takes a file for a side. */
  readonly take: (side: Side, file: File) => Promise<void>;
  readonly address: () => string;
};
