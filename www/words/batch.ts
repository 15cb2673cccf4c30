/** What the page says of a batch: one reference matched with many targets. */

import { page } from "./language";

export const batch = page("batch", {
  title: "One reference, many targets",
  open: "Many files",
  what: "The batch",
  loading: "Loading the batch …",
  help: "Every shape of the files is matched with the reference, one after the other. Choose files or a folder, or drop them here: drawings, pictures, lists of points, and TPS files with all their specimens.",
  files: "Choose files",
  folder: "Choose a folder",
  reference: "Reference",
  references: { page: "the reference of the page", first: "the first shape of the files" },
  outline: "Only the outline of each shape: its largest part, without holes",
  points: "Points on each outline",
  chosen: (count: number) =>
    count === 0 ? "No files yet." : count === 1 ? "1 file is ready." : `${count} files are ready.`,
  most: (most: number) => `Of the folder the first ${most} files are taken.`,
  noReference: "The page has no reference; draw one, or take the first shape of the files.",
  unread: (file: string, why: string) => `${file} cannot be the reference: ${why}`,
  start: "Match all",
  stop: "Stop",
  progress: "Batch",
  reading: (file: string) => `Reading ${file} …`,
  matching: (name: string, grid: string) => `Matching ${name}, on the ${grid} grid …`,
  done: (good: number, all: number, fitting: number) => `${good} of ${all} shapes are matched, ${fitting} of them fit.`,
  stopped: (good: number) => `Stopped; the ${good === 1 ? "match" : `${good} matches`} so far can be saved.`,
  failed: (why: string) => `The solver stopped unexpectedly (${why}).`,
  saved: "This is a saved match; take a shape out of it by importing it.",
  table: "Matches with the reference",
  columns: {
    shape: "Shape",
    distance: "Procrustes distance",
    size: "Centroid size",
    mismatch: "Largest distance, cells",
    outcome: "Outcome",
  },
  show: (name: string) => `Show ${name}`,
  saves: {
    table: "Table (CSV)",
    tps: "Points (TPS)",
    points: "Points (CSV)",
    strains: "Strains (CSV)",
  },
  unlike: (reference: number, target: number) =>
    `Landmarks are not tied: the reference has ${reference}, this shape ${target}.`,
  firstLandmarks: (all: number, most: number) => `Of ${all} landmarks the first ${most} are tied.`,
});
