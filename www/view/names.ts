/** The ways to look at a match. */

import { en } from "../words/en";

const ALL = [
  "grid",
  "image",
  "pullback",
  "stretch",
  "determinant",
  "curvature",
  "band",
  "mismatch",
  "stretching",
  "bending",
  "volume",
] as const;

export type View = (typeof ALL)[number];

export const VIEWS: readonly { readonly view: View; readonly label: string }[] = ALL.map((view) => ({
  view,
  label: en.views[view],
}));
