/** Draws a match in every way but the deformed grid. Knows plain arrays only; fetched when first asked for. */

import { type Frame, trace } from "./canvas";
import { strokeColoured } from "./curve";
import { valueAt } from "./field";
import { scaleOf } from "./limits";
import { bothCurvatures, costs, fieldOf, stretches } from "./measured";
import { movedGrid, movedLoops } from "./morph";
import type { View } from "./names";
import type { Theme } from "./palette";
import { carried, type Picture, pulledBack, type Raster, sample } from "./raster";
import type { Match } from "./result";
import { css, place, type Scale } from "./scales";

export { histogram, limitOf, markedScale, scaleOf } from "./limits";

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
  const key = [
    view,
    match.deformation,
    morph,
    bandwidth,
    limit,
    picture,
    dark,
    frame.width,
    frame.left,
    frame.bottom,
    frame.scale,
  ];
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
