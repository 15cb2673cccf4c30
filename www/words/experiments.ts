/** What the experiments' page says around the experiments. */

import { page } from "./language";

export const experiments = page("experiments", {
  lists: { curves: "Experiments with curves", surfaces: "Experiments with surfaces" },
  paper: "In the paper.",
  here: "Here.",
  open: "Open in the page",
  cancel: "Cancel",
  compute: "Compute",
  inFull: "Compute in full",
  /** What a press does, and to which experiment. */
  of: (what: string, title: string) => `${what}: ${title}`,
  part: (title: string, number: number) => `${title}, part ${number}`,
  failed: (why: string) => `The experiment has failed: ${why}. Compute it again; if it fails again, reload the page.`,
  doing: (percent: number, what: string) => `${percent} %: ${what}`,
  beforehand: "Computed beforehand; what you compute here takes its place.",
  done: (seconds: string, short: boolean) => `Computed in ${seconds}${short ? ", on small grids" : ""}.`,
  saveSvg: "Save as SVG",
  table: (name: string) => `Table: ${name}`,
});
