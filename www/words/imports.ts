/** What the import dialog and the gallery say themselves; the readers of files have sentences of their own. */

import { page } from "./language";
import { SIDES, type Side } from "./sides";

export const imports = page("imports", {
  /** What the import says in English of what it reads; in other languages it is said again. */
  words: (english: string) => english,
  close: "Close",
  pastedText: "the pasted text",
  picture: "the picture",
  useAs: (side: Side) => `Use as ${SIDES[side]}`,
  preparing: "Preparing the shape …",
  reading: "Reading …",
  name: "Import",
  stop: "Stop",
  choose: "Choose a file",
  gallery: "Gallery",
  formats:
    "SVG or its path data, PNG, JPEG, WebP, JSON, GeoJSON, TPS, CSV, or a match saved here. You can also drop a file anywhere on the page, or paste a picture or text.",
  paste: "Paste text here",
  pasteName: "SVG, path data, JSON or CSV text",
  savedMatch: (grid: string) => `A saved match on the ${grid} grid, with its shapes and settings.`,
  savedShapes: "Two saved shapes with their settings, not yet matched.",
  openAll: "Open everything",
  only: { reference: "Only the reference", template: "Only the target" },
  preview: (what: string) => `Preview: ${what}`,
  nothing: "nothing to show",
  counts: (loops: number, points: number) => `${loops} ${loops === 1 ? "loop" : "loops"}, ${points} points`,
  from: (source: string) => `From ${source}`,
  options: {
    shape: "Shape",
    parts: "Parts",
    holes: "Holes",
    smoothing: "Smoothing",
    place: "Place",
    inside: "Inside is",
    threshold: "Threshold",
    automatic: "Automatic threshold",
  },
  parts: { all: "all", largest: "only the largest" },
  holes: { keep: "keep", fill: "fill" },
  /** Widths in cells. */
  smoothings: { 0: "none", 0.5: "half a cell", 1: "one cell", 2: "two cells", 4: "four cells" } as Record<
    string,
    string
  >,
  places: { asIs: "as in the file", fit: "scaled and centred" },
  insides: { dark: "what is dark or opaque", light: "what is light or clear" },
  galleryWhat: "The gallery",
  galleryLoading: "Loading the gallery …",
  /** Of a silhouette, from its name in English. */
  silhouette: (english: string) => english,
  collections: { things: "Things", countries: "Countries" },
  credits: {
    countries: "Natural Earth, through world-atlas",
    publicDomain: "public domain; world-atlas: ISC licence",
    mit: "MIT licence",
  },
  /** Before the source's name, and behind it. */
  sourceFrom: "From",
});
