/** The ways to look at a match. */

export type View = "grid" | "image" | "pullback" | "stretch" | "determinant" | "curvature" | "band" | "mismatch";

export const VIEWS: readonly { readonly view: View; readonly label: string; readonly help: string }[] = [
  { view: "grid", label: "Grid", help: "" },
  { view: "image", label: "Image carried", help: "Each point of the picture goes where φ takes it." },
  { view: "pullback", label: "Image pulled back", help: "Each point shows what the picture has where φ takes it." },
  { view: "stretch", label: "Stretch", help: "Length after over length before, along the matched curve." },
  { view: "determinant", label: "Area ratio", help: "Area after over area before, det Dφ." },
  {
    view: "curvature",
    label: "Curvature",
    help: "Of the reference at its points and of the template at their partners.",
  },
  { view: "band", label: "Band", help: "How much each point counts as shell." },
  {
    view: "mismatch",
    label: "Mismatch",
    help: "How far distances to the two curves disagree, within the band.",
  },
];
