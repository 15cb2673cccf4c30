/** Everything that the result's side of the page says, in English. Another language is another such object. */

import type { View } from "../view/names";

export const en = {
  language: "en",

  examples: {
    title: "Or start from an example",
    gallery: "Open the gallery",
    galleryHelp: "Countries, animals and things, to be taken as reference or template",
  },

  views: {
    grid: "Grid",
    image: "Image carried",
    pullback: "Image pulled back",
    stretch: "Stretch",
    determinant: "Area ratio",
    curvature: "Curvature",
    band: "Band",
    mismatch: "Mismatch",
    stretching: "Stretching energy",
    bending: "Bending energy",
    volume: "Volume energy",
  } as Readonly<Record<View, string>>,

  /** What the first view's colours, lines and ticks mean; the others' captions come with them. */
  gridCaption:
    "Equal colours are matched points: thin where the reference was, in its shaded band, thick where it goes; short lines join the two. The broad pale line is the target, dashed where it was not reached. The net is the plane, deformed.",

  /** Added to a view's caption where parts of the target were not reached. */
  dashed: " Dashed is what of the target was not reached.",

  status: {
    ready: "Ready: press Match.",
    cancelled: "Cancelled. Press Match to start again.",
    preparing: "Preparing the shapes …",
    loading: "Loading the solver …",
    following: "Following your hand …",
    paused: "Paused.",
    matching: "Matching …",
    finished: "Finished.",
    shapesChanged: "The shapes have changed: press Match.",
    settingsChanged: "The settings have changed: press Match.",
    pinsChanged: "The pins have changed: press Match.",
    on: (approach: string, grid: string) => `${approach}, on the ${grid} grid …`,
    unseen: ", too small to see.",
    crumpled: (measure: string) => `The moved curve lies in folds: it is ${measure} times as long as the target.`,
  },

  numbers: {
    level: "Grid",
    iteration: "Iteration",
    total: "Energy",
    "mismatch-max": "Largest distance",
    "mismatch-mean": "Mean distance",
    "cover-max": "Target missed by",
    measure: "Length ratio",
    "least-determinant": "Least area ratio",
    cells: "cells",
    noCells: "none: the grid does not see the curve",
  },

  terms: {
    title: "Energy by term",
    names: { membrane: "Stretching", bending: "Bending", mismatch: "Mismatch", volume: "Volume" },
    forces: "Show their forces as arrows",
    rest: (energy: string) => `Above the ${energy} that are there before anything is deformed.`,
    helps: {
      membrane: "Off: the shell may be stretched along the curve for nothing.",
      bending: "Off: the shell may be bent for nothing.",
      volume: "Off: the plane around gives way almost freely; a rest stays, or it could fold.",
    },
  },

  present: {
    enter: "Present",
    what: "The presentation",
    leave: "Leave",
    help: "The result alone on the whole screen, in large type",
  },

  enlarge: { what: "The large surface", begin: (side: string) => `Enlarge ${side}` },

  guess: { begin: "Guess first", another: "Another point", end: "Done" },

  save: {
    name: "Save",
    busy: "Saving …",
    legend: "With a legend",
    formats: {
      png: "Picture (PNG)",
      svg: "Drawing (SVG)",
      json: "Everything (JSON)",
      csv: "Matched points (CSV)",
      video: "Morph as video (WebM)",
      gif: "Morph as GIF",
    },
    failed: (what: string, why: string) => `${what} could not be saved. ${why}`,
  },

  morph: {
    name: "Morph",
    what: "What looks for folds",
    play: "Play the morph",
    stop: "Stop the morph",
    part: (percent: number) => `${percent} % of the deformation`,
    how: "How the morph plays",
    plays: { once: "once", loop: "again and again", swing: "to and fro" },
    folds: (first: number, last: number) =>
      `On its way, from ${first} to ${last} %, the plane folds somewhere; the match itself does not.`,
  },

  /** The state in the result's accessible name. */
  result: {
    starting: "the solver is starting",
    none: "not matched yet, the grid is undeformed",
    stale: "matched, but with other settings than those chosen now",
    otherPins: "matched, but with other pins than those set now",
    matched: (distance: string) => `matched, at most ${distance} cells off, no cell folded`,
    blind: "matched, but the grid does not see the curve",
    doing: { paused: "paused", following: "following your hand", matching: "matching" },
    on: (doing: string, side: number) => `${doing} on the ${side} by ${side} grid`,
    outdated: { settings: "Computed with other settings", pins: "Computed with other pins" },
    back: "Back to the result",
    numbers: "What measures a point",
  },
};

export type Words = typeof en;
