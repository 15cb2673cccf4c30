/** The words of what is fetched later, in English. */

import type { View } from "../view/names";
import { en } from "./en";
import { page } from "./language";
import { SIDES, type Side } from "./sides";

export const later = page("later", {
  settings: {
    plain: "Settings that most people want",
    experts: "For those who know the paper",
    groups: { Energies: "Energies", Grid: "Grid", Method: "Method" },
    automatic: (value: string) => `Now: ${value} box sides.`,
    reset: "Reset to defaults",
    slider: (label: string) => `${label}, slider`,
  },

  compare: {
    setting: (side: string) => `Setting that ${side} changes`,
    but: (side: string) => `${side}: the page’s settings, but`,
    nothing: "nothing changed",
    of: (setting: string, side: string) => `${setting} of ${side}`,
    run: "Compare",
    running: "Comparing …",
    stop: "Stop comparing",
    stopped: (why: string) => `The solver stopped unexpectedly (${why}); compare again.`,
    view: "View of both",
    morph: "Morph of both",
    result: (name: string) => `Result of ${name}`,
    numbers: (name: string) => `Numbers at the point, ${name}`,
    differences: (a: string, b: string) => `Differences between ${a} and ${b}`,
    rows: {
      total: "Energy",
      membrane: "of stretching",
      bending: "of bending",
      mismatch: "of the mismatch",
      volume: "of the volume",
      pins: "of the pins",
      largest: "Largest distance, cells",
      mean: "Mean distance, cells",
      missed: "Target missed by, cells",
      measure: "Length ratio",
      stretch: "Mean stretch",
      deviation: "Deviation of the stretch",
      area: "Least area ratio",
      evaluations: "Evaluations",
      millis: "Time, ms",
    },
  },

  energies: {
    title: "Energy terms over iterations, logarithmic",
    none: "Press Match to see the energies fall.",
    iteration: "Iteration",
    axis: "iteration",
    total: "Total",
  },

  view: {
    legend: "Legend",
    histogram: (most: string) => `Histogram of the stretch; the largest share of the curve is ${most}`,
    shares: ["shortened", "kept", "lengthened"],
    choose: "Choose a picture …",
    pattern: "Test pattern",
  },

  runs: {
    none: "Press Match: each run is kept here, to be shown again and to be compared.",
    title: "Runs so far, newest first",
    defaults: "Default settings",
    show: (title: string) => `Show again: ${title}`,
    pin: "Compare with it",
    pinned: "Pinned",
    now: "Now",
    run: (id: number) => `Run ${id}`,
  },

  past: {
    name: "Iteration",
    at: (iteration: number, all: number, grid: string) => `Iteration ${iteration} of ${all}, on the ${grid} grid`,
  },

  legend: { reference: "Reference", matched: "Reference, moved", template: "Target", missed: "Not reached (dashed)" },

  guess: {
    ask: "Where will the marked point of the reference go? Click there in the picture, or lead the cross by the arrow keys and press Enter.",
    off: (sides: string, cells: string) => `Your guess was ${sides} box sides off, ${cells} cells of the grid.`,
  },

  enlarged: {
    begun: (side: Side) => `The ${SIDES[side]} fills the screen; Done leads back.`,
    undo: "Undo",
    redo: "Redo",
    other: (side: Side) => `To the ${SIDES[side]}`,
    done: "Done",
  },

  gallery: { title: "Gallery", importing: (side: Side) => `Import a ${SIDES[side]}` },

  present: {
    enter: "Present",
    what: "The presentation",
    leave: "Leave",
    help: "The result alone on the whole screen, in large type",
    keys: "Space plays, ← → step, v next view, Esc leaves",
  },

  /** What the colours of the views stand for. */
  scales: {
    stretch: "Length after / before",
    determinant: "Area after / before",
    curvature: "Curvature",
    band: "Weight η of the shell",
    mismatch: "|d₂∘φ − d₁|",
    stretching: "Stretching energy, W",
    bending: "Bending energy, |S|²",
    volume: "Volume energy, W",
    perSide: "per box side",
    perSquare: "per side²",
    cells: "cells",
  },

  pictures: {
    unread: "The picture could not be read; choose a PNG, JPEG or WebP file.",
    canvas: "This browser gives no 2D canvas; use a current Firefox, Chrome or Safari.",
  },

  readout: {
    name: "Numbers at the point",
    point: "Point",
    partner: "Partner",
    stretch: "Stretch",
    determinant: "Area ratio",
    curvatures: "Curvatures",
    distance: "Distance",
    perSide: "per side",
    cells: "cells",
  },

  /** What computes, and why. */
  card: {
    solver: "The solver for graphics cards",
    by: "Computed by",
    cpu: "the processor",
    gpu: (name: string) => `the graphics card (${name})`,
    because: (who: string, reason: string) => `${who}: ${reason}`,
    last: (who: string) => `Last: ${who}.`,
  },

  /** What buttons of the first load do. */
  hints: {
    fit: "Scale and centre both shapes",
    gallery: "Countries, animals and things, to be taken as reference or target",
  },

  copying: {
    copy: "Copy link",
    copied: "Copied",
    seeAddress: "See address bar",
    help: "A link that brings back everything: shapes, pins, settings, view",
  },

  /** Of the switches that leave a term out. */
  without: {
    membrane: "Off: the shell may be stretched along the curve for nothing.",
    bending: "Off: the shell may be bent for nothing.",
    volume: "Off: the plane around gives way almost freely; a rest stays, or it could fold.",
  },

  forces: { failed: "The forces could not be computed" },
});

/** What the colours, lines and ticks of each view mean. */
export const captions: Readonly<Record<View, string>> = page("captions", {
  grid: en.gridCaption,
  image:
    "Each point of the picture is carried to where the deformation takes it. Orange is the target; the black line is the reference, carried along.",
  pullback:
    "Each point shows what the picture has where the deformation takes it. Blue is the reference: on it lies what the picture has along the target.",
  stretch:
    "Length after over length before, along the matched curve: blue is shortened, orange lengthened, colourless kept. Thin grey is where the reference was, pale orange the target; the bars show how much of the curve has which stretch.",
  determinant:
    "Area after over area before, det Dφ: blue shrinks, orange grows, colourless is kept. The orange line is the target, the black one the reference, carried along.",
  curvature:
    "The thin curve has the colours of the reference’s curvature, the thick one those of the target’s at the partners: orange bulges out, blue in, colourless is straight.",
  band: "How much each point counts as shell, carried along: light counts fully, dark not at all. Stretching, bending and mismatch act only where it is light.",
  mismatch:
    "How far the distances to the two curves disagree, in cells of the grid: dark agrees, light does not. Beyond the band it does not count, and nothing is painted.",
  stretching:
    "Along the matched curve, what stretching or shortening it costs at each place, before its weight: dark is nothing, light the most. Thin grey is where the reference was, pale orange the target.",
  bending:
    "Along the matched curve, what the change of its curvature costs at each place, before its weight: dark is nothing, light the most. Thin grey is where the reference was, pale orange the target.",
  volume:
    "What the deformation of the plane costs at each place, before its weight: dark is nothing, light the most. The orange line is the target, the black one the reference, carried along.",
});
