/** What the page of lessons says around them. The lessons themselves are English: docs/lessons.md. */

import type { NumberName, Sign } from "../lessons/checks";
import { page } from "./language";
import { decimals } from "./numbers";

type Value = number | string | boolean;

export const lessons = page("lessons", {
  part: "The lesson",
  list: "All lessons",
  minutes: (count: number) => `${count} minutes`,
  unknown: (id: string) => `There is no lesson “${id}” here.`,
  teacher: "Teacher’s notes",
  forTeacher: "For the teacher",
  solution: "Show a solution",
  steps: "Steps",
  step: (index: number, count: number) => `Step ${index} of ${count}`,
  previous: "Back",
  next: "Next",
  end: "To all lessons",
  predict: "Predict first",
  answer: "Show the answer",
  task: "Do",
  check: "Check",
  frame: (title: string) => `Live picture: ${title}`,
  again: "Begin this step again",
  checked: { right: "Right.", wrong: "Not yet." },
  unmatched: "There is no match of what is chosen now: press Match, or wait until it is done.",
  silent: "The picture does not answer; begin this step again.",
  /** A condition with what was found. */
  holds: (what: string, found: string, sign: string, wanted: string) => `${what}: ${found}, wanted ${sign} ${wanted}`,
  signs: { "<": "less than", ">": "more than", "<=": "at most", ">=": "at least", "=": "just" } as Readonly<
    Record<Sign, string>
  >,
  numbers: {
    "stretch.mean": "Mean stretch",
    "stretch.deviation": "Deviation of the stretch",
    "mismatch.mean": "Mean distance, cells",
    "mismatch.max": "Largest distance, cells",
    "cover.mean": "Target missed on average, cells",
    "cover.max": "Target missed by, cells",
    measure: "Length ratio",
    leastDeterminant: "Least area ratio",
    iteration: "Iteration",
    evaluations: "Evaluations",
    "energies.membrane": "Energy of stretching",
    "energies.bending": "Energy of bending",
    "energies.mismatch": "Energy of the mismatch",
    "energies.volume": "Energy of the volume",
    "energies.total": "Energy",
  } as Readonly<Record<NumberName, string>>,
  pins: "Pins",
  shapes: "Both shapes as the lesson gave them",
  point: (x: number, y: number) => `Where the point (${decimals(x)}, ${decimals(y)}) goes`,
  off: (distance: number) => `${decimals(distance)} box sides off`,
  value: (value: Value) => (typeof value === "boolean" ? (value ? "yes" : "no") : String(value)),
});
