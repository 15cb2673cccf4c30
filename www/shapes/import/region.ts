/** What closed polygons enclose under a fill rule, as loops that neither cross nor overlap. */

import { Clipper, type Path64, type Paths64, FillRule as Rule } from "clipper2-ts";
import type { Loop, Shape } from "../geometry";
import { bounds } from "../geometry";

export type FillRule = "nonzero" | "evenodd";

/** Clipper works on integers; products of two of these stay exact. */
const STEPS = 2 ** 24;

/**
 * The union of the regions, each a list of polygons with its fill rule: bodies counter-clockwise, holes clockwise.
 * Rounds to 2⁻²⁴ of the longer side of the box around everything.
 */
export function united(regions: readonly { readonly loops: Shape; readonly rule: FillRule }[]): Shape {
  const box = bounds(regions.flatMap(({ loops }) => loops));
  if (!box) return [];
  const extent = Math.max(box.right - box.left, box.top - box.bottom);
  if (!(extent > 0)) return [];
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
