/** What the paper computes with, in so many words: the solver's defaults may move on, its experiments may not. */

import type { Settings } from "./experiment";

export const PAPER = {
  align: "none",
  bending: 1,
  tangency: 0,
  membraneModel: "intrinsic",
  volume: 1e-3,
} as const satisfies Partial<Settings>;
