/** Matches consecutive shapes of a file of polygons. */

import type { Loop } from "../shapes/geometry";
import { type Block, type Context, nodes, seconds, small, table, text } from "./experiment";
import { curves } from "./shapes";
import { solve } from "./solve";

export type Polygon = {
  readonly name: string;
  readonly points: Loop;
  /** The thinnest neck or gap in 1/128, where the file tells (`narrowest_h`). */
  readonly narrowest: number | null;
};

/** Reads `[{ "name": …, "points": [[x, y], …] }, …]`; throws with a sentence that says what is wrong and where. */
export function readPolygons(json: string): Polygon[] {
  let data: unknown;
  try {
    data = JSON.parse(json);
  } catch (problem) {
    throw new Error(`the file is not JSON (${(problem as Error).message})`);
  }
  if (!Array.isArray(data) || data.length < 2) throw new Error("the file must hold an array of at least two polygons");
  return data.map((entry: unknown, i) => {
    const { name = `shape ${i + 1}`, points, narrowest_h } = (entry ?? {}) as Record<string, unknown>;
    const usable =
      Array.isArray(points) &&
      points.length >= 3 &&
      points.every((p) => Array.isArray(p) && p.length === 2 && p.every((x) => Number.isFinite(x)));
    if (!usable) throw new Error(`polygon ${i + 1} needs "points": at least three pairs of numbers [x, y]`);
    return {
      name: String(name),
      points: Float64Array.from((points as number[][]).flat()),
      narrowest: typeof narrowest_h === "number" ? narrowest_h : null,
    };
  });
}

const FINEST = 7;

export type Pair = { readonly from: Polygon; readonly to: Polygon; readonly resolved: boolean };

/** Below two cells a grid cannot tell the two flanks of a neck from one. */
const LEAST_CELLS = 2;

/** A pair is resolved unless one of its shapes is known to be too narrow somewhere for 129². */
export function consecutive(polygons: readonly Polygon[]): Pair[] {
  const resolved = ({ narrowest }: Polygon) => narrowest === null || narrowest > LEAST_CELLS;
  return polygons.slice(1).map((to, i) => ({ from: polygons[i], to, resolved: resolved(polygons[i]) && resolved(to) }));
}

/** The table of all consecutive pairs on 129² with the page's defaults. */
export async function matchPolygons(context: Context, polygons: readonly Polygon[]): Promise<Block[]> {
  const pairs = consecutive(polygons);
  const rows: string[][] = [];
  let [resolved, matched] = [0, 0];
  for (const [i, pair] of pairs.entries()) {
    await context.progress(i / pairs.length, `${pair.from.name} → ${pair.to.name}`);
    const { end, iterations } = await solve(context, {
      reference: curves(pair.from.points),
      template: curves(pair.to.points),
      settings: { coarsest: 4, finest: FINEST, align: "similarity" },
    });
    const { mismatch, cover, leastDeterminant, stretch } = end.status;
    const fits = mismatch.max < 0.5 && cover.max <= 1 && leastDeterminant > 0;
    if (pair.resolved) {
      resolved += 1;
      if (fits) matched += 1;
    }
    rows.push([
      pair.from.name,
      pair.to.name,
      [pair.from, pair.to].map(({ narrowest }) => narrowest?.toFixed(1) ?? "–").join(" / "),
      seconds(end.millis),
      String(iterations),
      mismatch.mean.toFixed(3),
      mismatch.max.toFixed(3),
      cover.max.toFixed(3),
      small(leastDeterminant),
      `${stretch.mean.toFixed(2)} ± ${stretch.deviation.toFixed(2)}`,
      fits ? "yes" : pair.resolved ? "no" : "no (not resolved)",
    ]);
  }
  return [
    text(
      `Consecutive shapes of the file are matched on 17² to ${nodes(FINEST)} nodes with the page's defaults, the similarity start included. Narrowest is the thinnest neck or gap of either shape in cells of ${nodes(FINEST)}, as the file gives it (– where it gives none); below two cells a grid cannot tell two flanks from one. Of ${resolved} pairs that can be resolved, ${matched} match within half a cell everywhere and miss no part of the second shape by more than a cell; no cell of any match is folded.`,
    ),
    table(
      [
        "from",
        "to",
        "narrowest, cells",
        "time",
        "iterations",
        "mean mismatch, cells",
        "max",
        "target missed by",
        "least det Dφ",
        "stretch",
        "fits",
      ],
      rows,
    ),
  ];
}
