/** What is being imported. */

import { signal } from "@preact/signals";
import type { Side } from "../session";

export type ImportRequest = {
  readonly side: Side;
  /** A file, a pasted text, or nothing yet. */
  readonly input: Blob | string | null;
  /** Opened for the gallery. */
  readonly gallery?: boolean;
};

/** The request that the dialog answers; null while it is closed. */
export const importing = signal<ImportRequest | null>(null);
