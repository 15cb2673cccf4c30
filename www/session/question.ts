import type { Loop } from "../shapes/geometry";
import type { Side } from "./edits";

/** What is to be decided before a stroke becomes a shape. */
export type Question = {
  readonly side: Side;
  /** What has been drawn. */
  readonly loop: Loop;
  readonly words: string;
  readonly ways: readonly { readonly label: string; readonly go: () => void }[];
};
