/** What is being imported. */

import { signal } from "@preact/signals";
import type { Dropped } from "../batch/gather";
import type { Side } from "../session";

export type ImportRequest = {
  readonly side: Side;
  /** A file, a pasted text, or nothing yet. */
  readonly input: Blob | string | null;
  /** Opened for the gallery. */
  readonly gallery?: boolean;
  /** Opened for many targets: several files, or a folder; none yet where it is empty. */
  readonly many?: Dropped;
};

/** The request that the dialog answers; null while it is closed. */
export const importing = signal<ImportRequest | null>(null);
