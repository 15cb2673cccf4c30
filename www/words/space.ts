/** Everything that the page says of surfaces, in English. */

import { page } from "./language";
import { written } from "./numbers";
import { SIDES, type Side } from "./sides";

export const space = page("space", {
  leave: "Back to curves",
  title: "Elastic matching of two surfaces",
  document: "thinshell: elastic matching of two surfaces",
  promise:
    "Choose two closed surfaces: space, with a thin shell along the first, is deformed until it lies on the second.",
  examples: "Or start from an example",

  sides: { reference: "Reference", template: "Target" },
  surface: { reference: "Reference shape", template: "Template shape" },
  choose: (side: Side) => `Surface of the ${SIDES[side]}`,
  open: (side: Side) => `Open a file as ${SIDES[side]}`,
  file: "File",
  actions: {
    match: "Match",
    live: "Live",
    liveHelp: "A match begins whenever you change a surface, a pin or a setting",
    pause: "Pause",
    resume: "Resume",
    cancel: "Cancel",
    undo: "Undo",
    redo: "Redo",
    swap: "Swap",
    swapHelp: "The reference becomes the target, and the other way round",
    link: "Copy link",
    copied: "Copied",
    address: "See address bar",
    linkHelp: "A link that brings back surfaces of the gallery, pins, settings, view and camera",
    camera: "Reset view",
    dismiss: "Dismiss",
  },

  pins: {
    set: "Set pins",
    help: "Points of the reference tied to points of the target",
    deleteAll: "Delete all pins",
    name: (number: number, side: Side) => `Pin ${number} on the ${SIDES[side]}`,
    guide:
      "Press a point of either surface, then its partner on the other one. By keys: turn the point to the cross in the middle, then Enter.",
    begun: (number: number, side: Side) =>
      `Pin ${number} begins on the ${SIDES[side]}: now press its partner on the ${SIDES[side === "reference" ? "template" : "reference"]}, or Escape.`,
    keys: "Pins are dragged along their surface, or moved by arrow keys; Delete takes one away.",
  },

  view: "View",
  views: {
    colours: "Equal colours",
    area: "Area ratio",
    distance: "Distance",
    slice: "Slice",
  },
  captions: {
    colours:
      "Equal colours are matched points: each point of the reference keeps its colour and its lines, and the target shows those of its partners.",
    area: "How much the surface grows: the area around each point after the match over the area before.",
    distance: "How far each point of the moved reference lies from the target, in cells of the grid that was matched.",
    slice:
      "Space is cut along a plane of the undeformed grid: the net is where the deformation takes it, the strong line where it takes the curve that the plane cuts out of the reference.",
  },
  keys: "Drag to turn, with Shift to move, wheel to zoom; two fingers zoom and move. Keys: arrows turn, Shift with arrows moves, + and − zoom, Home goes back.",
  waiting: "Colours and maps come with the match.",
  legend: "What the colours mean",
  area: "Area ratio",
  distance: "Distance to the target",
  cells: "cells",
  target: "The target as a veil",
  plane: "Across",
  axes: ["width", "height", "depth"],
  at: "Plane at",
  percent: (part: number) => `${Math.round(100 * part)} %`,

  pose(across: number, above: number, zoom: number, moved: boolean): string {
    const side = across === 0 ? "" : `, ${Math.abs(across)}° from the ${across > 0 ? "right" : "left"}`;
    const height = above === 0 ? "" : `, ${Math.abs(above)}° from ${above > 0 ? "above" : "below"}`;
    const from = side || height ? `Seen${side}${height}`.replace(/^Seen,/, "Seen") : "Seen from the front";
    return `${from}, zoom ${written(zoom.toFixed(1))}${moved ? ", moved" : ""}`;
  },

  /** Begins as the plane's does, for whoever looks for it by name. */
  result: "Deformed grid and matched curve, here a surface",
  state: {
    none: "not matched yet",
    starting: "the solver is starting",
    paused: "paused",
    on: (grid: string) => `matching on the ${grid} grid`,
    stale: "matched, but with other surfaces or settings than those chosen now",
    matched: (distance: string) => `matched, at most ${distance} cells off, nothing folded`,
  },
  status: {
    ready: "Ready: press Match.",
    cancelled: "Cancelled. Press Match to start again.",
    loading: "Loading the solver for surfaces …",
    preparing: "Preparing the surfaces …",
    paused: "Paused.",
    on: (grid: string) => `Matching on the ${grid} grid …`,
    changed: "Surfaces or settings have changed: press Match.",
    finished: "Finished.",
  },
  grid: (level: number) => `${2 ** level + 1}³`,
  numbers: {
    level: "Grid",
    iteration: "Iteration",
    total: "Energy",
    "mismatch-max": "Largest distance",
    "mismatch-mean": "Mean distance",
    "cover-max": "Target missed by",
    measure: "Area over the target's",
    "area-deviation": "Area ratio varies by",
    "pins-off": "A pin is off by",
    "least-determinant": "Least volume ratio",
  },
  after: "Match after the grid",
  nothing: "none: the grid does not see the surface",

  settings: "Settings",
  changed: (count: number) => (count > 0 ? ` (${count} changed)` : ""),
  reset: "Reset to defaults",
  finest: "Finest grid",
  finestHelp:
    "Nodes of the last grid. 33³ takes seconds; each next one takes about ten times as long and eight times the memory.",

  save: "Save",
  formats: {
    png: "Picture (PNG)",
    ply: "Matched surface (PLY)",
    json: "Everything (JSON)",
    video: "Morph as video",
    gif: "Morph as GIF",
  },
  saving: "Saving …",
  films: "What makes films",
  notSaved: (what: string, why: string) => `${what} could not be saved. ${why}`,
  noMatch: "There is no match to save yet; press Match first.",

  noWebGl:
    "This browser shows no WebGL, so the surfaces cannot be drawn here; matching, numbers and saving work. Allow hardware acceleration, or use a current Firefox, Chrome or Safari.",
  crashed: (why: string) =>
    `The solver stopped unexpectedly (${why}). Your surfaces are kept; press Match to try again with a fresh one.`,

  files: {
    notRead: (name: string, why: string) => `“${name}” was not taken: it ${why}.`,
    unknown: "is none of PLY, OBJ, STL, NRRD or JSON with a level set",
    large: (limit: number) => `has more than ${limit} triangles; reduce it first, for example in MeshLab`,
    empty: "holds no triangles",
    cut: "ends too early",
    number: "has something else where a number was expected",
    index: "names a vertex that it does not have",
    flat: "has no extent",
    far: "reaches farther than numbers do",
    nrrd: "is no NRRD of three sizes with one number a voxel, raw, packed by gzip or as text, in one file",
    manyVoxels: (limit: number) => `has more than ${limit} voxels; reduce it first`,
    plyFormat: (format: string) => `is a PLY of the unknown format “${format}”`,
    plyHeader: "has no PLY header that can be read",
    json: "is no JSON with “cells” (2 to 128) and “values”, one for each of the (cells + 1)³ nodes, x fastest, negative inside",
  },

  links: {
    notRead: (why: string) => `The link could not be read: ${why}.`,
    number: (text: string) => `“${text.slice(0, 60)}” is not what it should be`,
    unknown: (id: string) => `there is no surface “${id}” in the gallery`,
    elsewhere: (side: Side) => `the ${SIDES[side]} is a file that is kept in another browser only, or no more`,
    notWhole: "The link holds settings, view and camera, but not the file's mesh: that is kept in this browser only.",
    notKept: "This browser keeps no files: after a reload the dropped mesh has to be opened again.",
  },
});
