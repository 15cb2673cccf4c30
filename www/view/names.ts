/** The ways to look at a match. */

export const VIEWS = [
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

export type View = (typeof VIEWS)[number];
