/** What closed polygons enclose under a fill rule, as loops that neither cross nor overlap. */

import { Clipper, type Path64, type Paths64, FillRule as Rule } from "clipper2-ts";
import type { Loop, Shape } from "../geometry";
import { bounds } from "../geometry";
import { outlined } from "./raster";

export type FillRule = "nonzero" | "evenodd";

export type Region = { readonly loops: Shape; readonly rule: FillRule };

/** Clipper works on integers; products of two of these stay exact. */
const STEPS = 2 ** 24;

/** What a sweep may cost: a second or two. Units: edges that are alive, summed over the points passed. */
const MOST_WORK = 4e6;

/**
 * The union of the regions: bodies counter-clockwise, holes clockwise. Rounds to 2⁻²⁴ of the longer side of the box
 * around everything, or to a sample of `outlined` where they are too tangled for an exact sweep.
 */
export function united(regions: readonly Region[], report: (done: number) => void = () => {}): Shape {
  const box = bounds(regions.flatMap(({ loops }) => loops));
  if (!box) return [];
  const extent = Math.max(box.right - box.left, box.top - box.bottom);
  if (!(extent > 0)) return [];
  if (isTangled(regions)) return outlined(regions, report);
  const scale = STEPS / extent;
  const filled = regions.map(({ loops, rule }) =>
    Clipper.union(
      loops.map((loop) => integers(loop, box.left, box.bottom, scale)),
      rule === "evenodd" ? Rule.EvenOdd : Rule.NonZero,
    ),
  );
  const all: Paths64 = filled.length === 1 ? filled[0] : Clipper.union(filled.flat(), Rule.NonZero);
  return all.map((path) => coordinates(path, box.left, box.bottom, scale));
}

/** Whether a sweep from bottom to top, which passes every point and looks at all edges alive there, would take long. */
export function isTangled(regions: readonly Region[]): boolean {
  const count = regions.reduce((sum, { loops }) => sum + loops.reduce((all, loop) => all + loop.length / 2, 0), 0);
  // Each edge is alive for at most all points.
  if (count * count <= MOST_WORK) return false;
  const heights = new Float64Array(count);
  let k = 0;
  for (const { loops } of regions) {
    for (const loop of loops) {
      for (let i = 1; i < loop.length; i += 2) {
        heights[k] = loop[i];
        k += 1;
      }
    }
  }
  heights.sort();
  let work = 0;
  for (const { loops } of regions) {
    for (const loop of loops) {
      let before = rank(heights, loop[loop.length - 1]);
      for (let i = 1; i < loop.length; i += 2) {
        const now = rank(heights, loop[i]);
        work += Math.abs(now - before);
        before = now;
      }
    }
  }
  return work > MOST_WORK;
}

/** How many of the sorted values are smaller. */
function rank(sorted: Float64Array, value: number): number {
  let [low, high] = [0, sorted.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (sorted[middle] < value) low = middle + 1;
    else high = middle;
  }
  return low;
}

function integers(loop: Loop, left: number, bottom: number, scale: number): Path64 {
  const path: Path64 = [];
  for (let i = 0; i < loop.length; i += 2) {
    path.push({ x: Math.round((loop[i] - left) * scale), y: Math.round((loop[i + 1] - bottom) * scale) });
  }
  return path;
}

function coordinates(path: Path64, left: number, bottom: number, scale: number): Loop {
  const loop = new Float64Array(2 * path.length);
  path.forEach(({ x, y }, i) => {
    loop[2 * i] = left + Number(x) / scale;
    loop[2 * i + 1] = bottom + Number(y) / scale;
  });
  return loop;
}
