/**
 * Draws a match: the undeformed reference with its band, the deformed grid over the template, and the matched curve
 * in the colours of the reference. Knows plain arrays only.
 */

import { type Frame, pixelX, pixelY, trace } from "./canvas";
import { arcLengthParts, type ColouredLoop, strokeColoured, ticksOf } from "./curve";
import { gridLines } from "./grid";
import { movedGrid, movedLoops } from "./morph";
import { onCycle, type Theme } from "./palette";

export type Match = {
  /** The grid has 2^level cells a side. */
  readonly level: number;
  /** φ at the nodes, x y a node, x fastest, domain units. */
  readonly deformation: Float64Array;
  /** Zero sets and φ(reference), closed; `matched[i]` has the points of `reference[i]`, moved. */
  readonly curves: {
    readonly reference: readonly Float64Array[];
    readonly template: readonly Float64Array[];
    readonly matched: readonly Float64Array[];
  };
};

/** The match of a frame of the solver. */
export function matchOf({
  status,
  deformation,
  curves,
}: Omit<Match, "level"> & { status: Pick<Match, "level"> }): Match {
  return { level: status.level, deformation, curves };
}

type Point = { readonly x: number; readonly y: number };

export type ResultScene = {
  readonly reference: readonly Float64Array[];
  readonly template: readonly Float64Array[];
  readonly pins: readonly { readonly reference: Point; readonly template: Point }[];
  /** Null before the first frame of a run: the identity is shown. */
  readonly match: Match | null;
  /** 0 shows the identity, 1 the match; between them see morph.ts. */
  readonly morph: number;
  /** Half width of the band around the reference. */
  readonly bandwidth: number;
  /** Stretches of the target that the match has not come to, open polylines. */
  readonly missed?: readonly Float64Array[];
};

export function drawResult(context: CanvasRenderingContext2D, frame: Frame, colours: Theme, scene: ResultScene): void {
  const { ratio } = frame;
  const { match, morph } = scene;
  const reference = match ? match.curves.reference : scene.reference;
  const template = match ? match.curves.template : scene.template;

  context.beginPath();
  for (const loop of template) trace(context, frame, loop, true);
  context.fillStyle = colours.template;
  context.globalAlpha = 0.14;
  // The solver's zero sets run either way; a hole is where they enclose twice.
  context.fill(match ? "evenodd" : "nonzero");
  context.globalAlpha = 1;

  drawGrid(context, frame, colours, match ? match.level : 5, match && movedGrid(match, morph).deformation);
  drawBand(context, frame, colours, reference, scene.bandwidth);

  context.globalAlpha = match ? 0.4 : 0.7;
  context.beginPath();
  for (const loop of template) trace(context, frame, loop, true);
  context.strokeStyle = colours.template;
  context.lineWidth = (match ? 6.5 : 2.25) * ratio;
  context.lineJoin = "round";
  context.stroke();
  context.globalAlpha = 1;

  drawMissed(context, frame, colours, scene.missed ?? []);

  const parts = arcLengthParts(reference);
  if (!match) {
    strokeColoured(context, frame, zip(reference, parts), colours.cycle, 2.5 * ratio);
    return;
  }
  const moved = movedLoops(match, morph);
  context.globalAlpha = 0.75;
  drawTicks(context, frame, colours, match, parts, moved);
  strokeColoured(context, frame, zip(reference, parts), colours.cycle, 1.5 * ratio);
  context.globalAlpha = 1;
  strokeColoured(context, frame, zip(moved, parts), colours.cycle, 3.25 * ratio);
}

/** Dashed, so that it is told from what is reached without colours too. */
export function drawMissed(
  context: CanvasRenderingContext2D,
  frame: Frame,
  colours: Theme,
  missed: readonly Float64Array[],
): void {
  context.beginPath();
  for (const line of missed) trace(context, frame, line, false);
  context.strokeStyle = colours.warning;
  context.lineWidth = 2.5 * frame.ratio;
  context.setLineDash([6 * frame.ratio, 4 * frame.ratio]);
  context.stroke();
  context.setLineDash([]);
}

export function zip(loops: readonly Float64Array[], parts: readonly Float64Array[]): ColouredLoop[] {
  return loops.map((points, i) => ({ points, parts: parts[i] }));
}

function drawGrid(
  context: CanvasRenderingContext2D,
  frame: Frame,
  colours: Theme,
  level: number,
  deformation: Float64Array | null,
): void {
  const cells = 2 ** level;
  const side = cells + 1;
  const lines = gridLines(level);
  context.strokeStyle = colours.grid;
  context.lineJoin = "round";
  for (const border of [false, true]) {
    context.beginPath();
    for (const { first, step, isBorder } of lines) {
      if (isBorder !== border) continue;
      for (let k = 0; k <= cells; k += 1) {
        const node = first + k * step;
        const x = deformation ? deformation[2 * node] : (node % side) / cells;
        const y = deformation ? deformation[2 * node + 1] : Math.floor(node / side) / cells;
        if (k === 0) context.moveTo(pixelX(frame, x), pixelY(frame, y));
        else context.lineTo(pixelX(frame, x), pixelY(frame, y));
      }
    }
    context.lineWidth = (border ? 1.5 : 0.9) * frame.ratio;
    context.stroke();
  }
}

function drawBand(
  context: CanvasRenderingContext2D,
  frame: Frame,
  colours: Theme,
  reference: readonly Float64Array[],
  bandwidth: number,
): void {
  context.beginPath();
  for (const loop of reference) trace(context, frame, loop, true);
  context.strokeStyle = colours.reference;
  context.lineWidth = 2 * bandwidth * frame.scale;
  context.lineJoin = "round";
  context.globalAlpha = 0.09;
  context.stroke();
  context.globalAlpha = 1;
}

function drawTicks(
  context: CanvasRenderingContext2D,
  frame: Frame,
  colours: Theme,
  match: Match,
  parts: readonly Float64Array[],
  moved: readonly Float64Array[],
): void {
  context.lineWidth = frame.ratio;
  match.curves.reference.forEach((from, l) => {
    const to = moved[l];
    for (const i of ticksOf(parts[l])) {
      context.beginPath();
      context.strokeStyle = onCycle(colours.cycle, parts[l][i]);
      context.moveTo(pixelX(frame, from[2 * i]), pixelY(frame, from[2 * i + 1]));
      context.lineTo(pixelX(frame, to[2 * i]), pixelY(frame, to[2 * i + 1]));
      context.stroke();
    }
  });
}
