/** What the page says from the first load on. */

import type { Inspection, Status } from "../protocol";
import type { View } from "../view/names";
import { CRUMPLED, FITS, isSeen } from "./facts";
import { page } from "./language";
import { decimals } from "./numbers";
import { SIDES, type Side, sidesSaid } from "./sides";

export const en = page("en", {
  /** What a press does. */
  actions: {
    match: "Match",
    live: "Live",
    liveHelp: "The match follows your hand while you change a shape or a setting",
    pause: "Pause",
    resume: "Resume",
    cancel: "Cancel",
    undo: "Undo",
    redo: "Redo",
    fit: "Fit",
    drawAgain: "Draw again",
    dismiss: "Dismiss",
    matchOn: (grid: string) => `Match on ${grid}`,
  },

  sketch: {
    names: { reference: "Reference", template: "Target" },
    surface: { reference: "Reference shape", template: "Template shape" },
    clear: "Clear",
    /** As the surfaces' own, a name by which the page is driven. */
    clearSide: (side: Side) => `Clear ${side}`,
    invitation: "Draw a closed curve here",
  },

  imports: {
    name: "Import",
    of: (side: Side) => `Import ${SIDES[side]}`,
    help: (side: Side) => `Take the ${SIDES[side]} from a drawing, a picture, a list of points or the gallery`,
    what: "The import",
    loading: "Loading the import …",
  },

  /** The parts of the page that are fetched when they are opened. */
  parts: {
    energies: "Energies over iterations",
    runs: "Runs so far",
    compare: "Compare side by side",
    settings: "Settings",
    changed: (count: number) => `(${count} changed)`,
    named: (title: string) => `“${title}”`,
    loading: "Loading …",
  },

  /** What is fetched on demand and did not come. */
  missing: {
    sentence: (what: string) => `${what} could not be loaded; check the connection and try again, or reload the page.`,
    tool: "What is needed for this tool",
    draw: "What is needed to draw",
    pins: "What is needed for pins",
    view: "This view",
    files: "What saves files",
    language: "This language",
  },

  solver: {
    /** What the solver says in English, above all why it refuses; in other languages it is said again. */
    words: sidesSaid,
    refused:
      "The solver could not be started, because the browser refuses the page's worker. Reload the page, and let its security policy allow “worker-src blob:”; a browser extension may forbid workers, too",
    stopped: (why: string) =>
      `The solver stopped unexpectedly (${why}). Your shapes are kept; press Match to try again with a fresh one.`,
    offline: "the solver could not be loaded; check the connection, then try again or reload the page",
    unanswered: (status: number) => `the solver could not be loaded (${status}); reload the page`,
    untaken: (why: string) =>
      `the solver could not be loaded, since this browser does not take its WebAssembly (${why}); use a current Firefox, Chrome or Safari, and let the page's security policy allow 'wasm-unsafe-eval'`,
    canvas: "this browser gives no 2D canvas; use a current Firefox, Chrome or Safari",
  },

  examples: {
    title: "Or start from an example",
    gallery: "Open the gallery",
  },

  view: "View",

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
    shapesChanged: "The shapes have changed: press Match.",
    settingsChanged: "The settings have changed: press Match.",
    pinsChanged: "The pins have changed: press Match.",
    on: (approach: string, grid: string) => `${approach}, on the ${grid} grid …`,
    /** What the solver says in English; in other languages it is said again from `facts` (facts.ts). */
    approach: ({ approach }: Status) => approach,
    stop: ({ stop }: Status) => stop ?? "Finished.",
    verdict: (status: Status): string | null => {
      const { verdict, facts, measure } = status;
      if (facts[2] === FITS && !isSeen(status)) return verdict?.replace(/\.$/, ", too small to see.") ?? null;
      if (facts[2] !== CRUMPLED) return verdict;
      return `${verdict} The moved curve lies in folds: it is ${decimals(measure)} times as long as the target.`;
    },
    unresolved: ({ words }: Inspection) => words,
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
  },

  enlarge: { what: "The large surface", begin: (side: Side) => `Enlarge ${SIDES[side]}` },

  guess: { begin: "Guess first", another: "Another point", end: "Done" },

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
    name: (state: string) => `Deformed grid and matched curve: ${state}`,
    title: "Match",
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
});
