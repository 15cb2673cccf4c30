/** A file on its way to the browser's downloads. */

import { files } from "../words/files";

export type Saved = {
  readonly blob: Blob;
  readonly name: string;
  /** What is other than was asked for. */
  readonly note?: string;
};

/** Hands the file to the browser's downloads. */
export function download({ blob, name }: Saved): void {
  if (blob.size === 0) throw new Error(files.empty);
  const address = URL.createObjectURL(blob);
  const link = document.createElement("a");
  link.href = address;
  link.download = name;
  link.click();
  // Browsers read the address after the click; a minute is ample.
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}
