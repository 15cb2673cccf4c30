/** Draws a match in every way but the deformed grid. Knows plain arrays only; fetched when first asked for. */

import { curvatures, nearest, stretch } from "./along";
import { type Frame, trace } from "./canvas";
import { strokeColoured } from "./curve";
import { atNodes, bendingAt, stretchingAt, volumeDensities } from "./density";
import { bandWeights, distances, logDeterminants, mismatches, thinned, valueAt } from "./field";
import { movedGrid, movedLoops } from "./morph";
import type { View } from "./names";
import type { Theme } from "./palette";
import { CURVATURE_CELLS } from "./probe";
import { carried, type Picture, pulledBack, type Raster, sample } from "./raster";
import type { Match } from "./result";
import { amounts, clipped, css, factors, place, quantile, roundUp, type Scale, signed } from "./scales";

export type ViewScene = {
  readonly match: Match;
  /** 0 shows the identity, 1 the match. */
  readonly morph: number;
  readonly bandwidth: number;
  /** Where the scale ends, as `limitOf` gives it; one for several matches that are compared. */
  readonly limit: number;
  readonly picture: Picture;
};

/** Pixels computed a CSS pixel, at most. */
const FINENESS = 2;

/** Fields with a distance at each node are costly, and smooth: no more cells than this. */
const FIELD_CELLS = 64;

/** What the match needs the view's scale to reach: doublings, cells or 1/length. 1 where nothing is to choose. */
export function limitOf(view: View, match: Match, bandwidth: number): number {
  const values = valuesOf(view, match, bandwidth);
  switch (view) {
    case "stretch":
    case "determinant":
      return doublings(values.map((value) => Math.abs(Math.log2(value))));
    case "curvature":
      return roundUp(quantile(values.map(Math.abs), 0.98));
    case "mismatch":
      return roundUp(quantile(values, 0.995));
    case "stretching":
    case "bending":
    case "volume":
      return roundUp(quantile(values, 0.98));
    default:
      return 1;
  }
}

/** Everything that the view's scale is for. */
function valuesOf(view: View, match: Match, bandwidth: number): Float64Array {
  switch (view) {
    case "stretch":
      return joined(stretches(match));
    case "determinant":
      return logDeterminants(mapOf(match)).map((log) => 2 ** log);
    case "curvature": {
      const both = bothCurvatures(match);
      return joined([...both.reference, ...both.partner]);
    }
    case "mismatch":
      return mismatchWithin(match, bandwidth);
    case "stretching":
    case "bending":
      return joined(costs(view, match, 1));
    case "volume":
      return volumeDensities(mapOf(match));
    default:
      return new Float64Array(0);
  }
}

function joined(parts: readonly Float64Array[]): Float64Array {
  return Float64Array.from(parts.flatMap((values) => [...values]));
}

/** The scale with its ends marked where the match has values beyond them, which the ends' colours stand for. */
export function markedScale(view: View, match: Match, bandwidth: number, limit: number, dark: boolean): Scale | null {
  const scale = scaleOf(view, limit, dark);
  if (!scale) return null;
  let [least, most] = [0, 0];
  for (const value of valuesOf(view, match, bandwidth)) {
    const part = scale.part(value);
    if (part < least) least = part;
    if (part > most) most = part;
  }
  return clipped(scale, least, most);
}

/** A quarter of a doubling at least: smaller changes cannot be told from noise. */
function doublings(sizes: ArrayLike<number>): number {
  const reached = quantile(sizes, 0.98);
  return [0.25, 0.5, 1, 2, 3, 4, 6].find((step) => step >= reached) ?? 8;
}

export function scaleOf(view: View, limit: number, dark: boolean): Scale | null {
  switch (view) {
    case "stretch":
      return factors("Length after / before", dark, limit);
    case "determinant":
      return factors("Area after / before", dark, limit);
    case "curvature":
      return signed("Curvature", "per box side", dark, limit);
    case "band":
      return amounts("Weight η of the shell", "", 1);
    case "mismatch":
      return amounts("|d₂∘φ − d₁|", "cells", limit);
    case "stretching":
      return amounts("Stretching energy, W", "", limit);
    case "bending":
      return amounts("Bending energy, |S|²", "per side²", limit);
    case "volume":
      return amounts("Volume energy, W", "", limit);
    default:
      return null;
  }
}

/** Parts of the matched curve, by length of the reference, in even bins of the stretch's scale. */
export function histogram(match: Match, scale: Scale, bins: number): number[] {
  const out = new Array<number>(bins).fill(0);
  const values = stretches(match);
  let whole = 0;
  match.curves.reference.forEach((loop, l) => {
    for (let i = 0, j = loop.length - 2; i < loop.length; j = i, i += 2) {
      const length = Math.hypot(loop[i] - loop[j], loop[i + 1] - loop[j + 1]);
      out[place(scale.part((values[l][i / 2] + values[l][j / 2]) / 2), bins)] += length;
      whole += length;
    }
  });
  return out.map((length) => length / whole);
}

export function drawView(
  view: View,
  context: CanvasRenderingContext2D,
  frame: Frame,
  colours: Theme,
  scene: ViewScene,
): void {
  const { match, morph } = scene;
  const { ratio } = frame;
  const scale = scaleOf(view, scene.limit, colours.dark);
  const moved = movedLoops(match, morph);
  if (isAlong(view)) {
    outline(context, frame, match.curves.template, colours.template, 5 * ratio, 0.35);
    const { own, moving } = alongOf(view, scene, scale);
    const table = scale?.colours.map(css) ?? [];
    if (own) coloured(context, frame, colours, match.curves.reference, own, table, 3);
    else outline(context, frame, match.curves.reference, colours.muted, ratio, 0.8);
    coloured(context, frame, colours, moved, moving, table, 6);
    return;
  }
  context.drawImage(rasterOf(view, context, frame, colours, scene), 0, 0, frame.width, frame.height);
  const inReference = view === "pullback";
  const still = inReference ? match.curves.reference : match.curves.template;
  outline(context, frame, still, inReference ? colours.reference : colours.template, 4 * ratio, 0.7);
  if (inReference) return;
  outline(context, frame, moved, colours.paper, 3.5 * ratio, 0.9);
  outline(context, frame, moved, colours.ink, 1.5 * ratio, 1);
}

type AlongView = "stretch" | "curvature" | "stretching" | "bending";

/** Whether the view colours the curve, and nothing of the plane. */
export function isAlong(view: View): view is AlongView {
  return view === "stretch" || view === "curvature" || view === "stretching" || view === "bending";
}

/** Places 0…1 on the scale, for each point of the curve where it is and, if it has colours there, where it was. */
export function alongOf(view: AlongView, { match, morph }: ViewScene, scale: Scale | null) {
  const placed = (loops: readonly Float64Array[]) => (scale ? loops.map((values) => values.map(scale.part)) : loops);
  if (view === "curvature") {
    const { reference, partner } = bothCurvatures(match);
    return { own: placed(reference), moving: placed(partner) };
  }
  return { own: null, moving: placed(view === "stretch" ? stretches(match, morph) : costs(view, match, morph)) };
}

/** What the curve costs at each of its points. The target's curvature is met at the end of the way only. */
function costs(view: "stretching" | "bending", match: Match, morph: number): Float64Array[] {
  if (view === "stretching") return stretches(match, morph).map((values) => values.map(stretchingAt));
  const { reference, partner } = bothCurvatures(match);
  return stretches(match).map((values, l) => values.map((s, i) => bendingAt(s, reference[l][i], partner[l][i])));
}

function outline(
  context: CanvasRenderingContext2D,
  frame: Frame,
  loops: readonly Float64Array[],
  colour: string,
  width: number,
  opacity: number,
): void {
  context.beginPath();
  for (const loop of loops) trace(context, frame, loop, true);
  context.strokeStyle = colour;
  context.lineJoin = "round";
  context.lineWidth = width;
  context.globalAlpha = opacity;
  context.stroke();
  context.globalAlpha = 1;
}

/** The middle of a diverging scale is near the paper's colour: a dark edge keeps the curve in sight. */
function coloured(
  context: CanvasRenderingContext2D,
  frame: Frame,
  colours: Theme,
  loops: readonly Float64Array[],
  places: readonly Float64Array[],
  table: readonly string[],
  width: number,
): void {
  outline(context, frame, loops, colours.ink, (width + 2) * frame.ratio, 1);
  // The table is no cycle: its last entry stands for all beyond.
  const parts = places.map((values) => values.map((part) => place(part, table.length) / table.length + 1e-6));
  strokeColoured(
    context,
    frame,
    loops.map((points, i) => ({ points, parts: parts[i] })),
    table,
    width * frame.ratio,
  );
}

/** The last picture of each canvas, so that a mark moving over it does not cost it anew. */
const painted = new WeakMap<object, { readonly key: readonly unknown[]; readonly canvas: OffscreenCanvas }>();

function rasterOf(
  view: View,
  context: CanvasRenderingContext2D,
  frame: Frame,
  { dark }: Theme,
  scene: ViewScene,
): OffscreenCanvas {
  const { match, morph, bandwidth, limit, picture } = scene;
  const key = [view, match.deformation, morph, bandwidth, limit, picture, dark, frame.width];
  const before = painted.get(context.canvas);
  if (before?.key.every((value, i) => value === key[i])) return before.canvas;
  const canvas = pixelsOf(view, frame, dark, scene);
  painted.set(context.canvas, { key, canvas });
  return canvas;
}

/** What a view paints that is made of pixels rather than lines. */
export function pixelsOf(view: View, frame: Frame, dark: boolean, scene: ViewScene): OffscreenCanvas {
  const { match, morph, bandwidth, picture } = scene;
  const scale = scaleOf(view, scene.limit, dark);
  // The eye wants no more than two pixels for a CSS pixel here; the browser's own smoothing does the rest.
  const coarser = Math.max(1, frame.ratio / FINENESS);
  const width = Math.round(frame.width / coarser);
  const height = Math.round(frame.height / coarser);
  const raster: Raster = { ...frame, width, height, scale: frame.scale / coarser };
  const data = new Uint8ClampedArray(4 * width * height);
  const map = movedGrid(match, morph);
  if (view === "image") carried(raster, map, (pixel, x, y) => sample(picture, x, y, data, pixel));
  else if (view === "pullback") pulledBack(raster, map, (pixel, x, y) => sample(picture, x, y, data, pixel));
  else if (scale) {
    const { cells, values, d1 } = fieldOf(view, scene);
    carried(raster, map, (pixel, x, y) => {
      // Its own border is smooth, that of the cells it cuts is not.
      if (view === "mismatch" && d1 && Math.abs(valueAt(d1, cells, x, y)) > bandwidth) return;
      const value = valueAt(values, cells, x, y);
      if (Number.isNaN(value)) return;
      const [red, green, blue] = scale.colours[place(scale.part(value))];
      data[4 * pixel] = red;
      data[4 * pixel + 1] = green;
      data[4 * pixel + 2] = blue;
      data[4 * pixel + 3] = 255;
    });
  }
  const canvas = new OffscreenCanvas(width, height);
  canvas.getContext("2d")?.putImageData(new ImageData(data, width, height), 0, 0);
  return canvas;
}

function mismatchWithin(match: Match, bandwidth: number): Float64Array {
  const { values, d1 } = mismatchAt(match, 1, bandwidth);
  return values.filter((_, node) => Math.abs(d1[node]) < bandwidth);
}

type Field = { readonly cells: number; readonly values: Float64Array; readonly d1?: Float64Array };

/** Nodal values on the undeformed grid, in the units of the view's scale. */
function fieldOf(view: View, { match, morph, bandwidth }: ViewScene): Field {
  const map = movedGrid(match, morph);
  if (view === "determinant") return { cells: map.cells, values: logDeterminants(map).map((log) => 2 ** log) };
  if (view === "mismatch") return mismatchAt(match, morph, bandwidth);
  if (view === "volume") return { cells: map.cells, values: atNodes(volumeDensities(map), map.cells) };
  const cells = Math.min(map.cells, FIELD_CELLS);
  return { cells, values: bandWeights(distances(match.curves.reference, cells), bandwidth) };
}

function mismatchAt(match: Match, morph: number, bandwidth: number): Required<Field> {
  const map = thinned(movedGrid(match, morph), FIELD_CELLS);
  const d1 = distances(match.curves.reference, map.cells);
  const lengths = mismatches(map, match.curves.template, d1, bandwidth);
  return { cells: map.cells, values: lengths.map((length) => length * 2 ** match.level), d1 };
}

export function mapOf(match: Match) {
  return { cells: 2 ** match.level, deformation: match.deformation };
}

function stretches(match: Match, morph = 1): Float64Array[] {
  const moves = movedLoops(match, morph);
  return match.curves.reference.map((loop, l) => {
    const moved = moves[l];
    return Float64Array.from({ length: loop.length / 2 }, (_, i) => stretch(loop, moved, i));
  });
}

type Curvatures = { readonly reference: readonly Float64Array[]; readonly partner: readonly Float64Array[] };
const known = new WeakMap<object, Curvatures>();

/** At every point of the reference, and of the template at the place nearest to its partner. */
export function bothCurvatures(match: Match): Curvatures {
  const before = known.get(match.deformation);
  if (before) return before;
  const { reference, template, matched } = match.curves;
  const reach = CURVATURE_CELLS / 2 ** match.level;
  const own = reference.map((loop) => curvatures(loop, reach));
  const theirs = template.map((loop) => curvatures(loop, reach));
  const partner = matched.map((loop) =>
    Float64Array.from({ length: loop.length / 2 }, (_, i) => {
      const at = nearest(template, loop[2 * i], loop[2 * i + 1]);
      return at ? theirs[at.loop][at.point] : Number.NaN;
    }),
  );
  const both = { reference: own, partner };
  known.set(match.deformation, both);
  return both;
}
