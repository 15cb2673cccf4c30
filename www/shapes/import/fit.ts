/** From loops of any size to a shape that can be drawn, edited and matched: placed in the box, with few even points. */

import {
  averaged,
  bounds,
  FITTED_SIZE,
  type Loop,
  perimeter,
  resampled,
  type Shape,
  type Similarity,
  signedArea,
  transformed,
} from "../geometry";
import { divided, thinned } from "../thin";
import { ImportError } from "./found";
import { chosenParts, type Holes, type Parts } from "./parts";
import { united } from "./region";

/** A cell of the grid on which shapes are matched by default. */
export const CELL = 1 / 128;

/** Points a loop has at most: those that carry its form, and as many again to make long edges short. */
export const MOST_POINTS = 600;
const MOST_CORNERS = 360;
const PIECES = MOST_POINTS - MOST_CORNERS;

/** Smaller loops than these stay out, the largest first. */
const MOST_LOOPS = 60;

/** Which loop lies in which is asked of each pair: of the largest only. */
const MOST_ASKED = 240;

/** A thousandth of a cell: nobody sees it, and no energy feels it. */
const FINEST = CELL / 1000;

/** Points that a loop is rounded with, at most; a curve as long as two hundred boxes has as many. */
const MOST_EVEN = 50_000;

export type Placement = "fit" | "asIs";

export type Prepared = {
  readonly shape: Shape;
  readonly notes: readonly string[];
  /** From the loops' own coordinates to the box. */
  readonly box: Similarity;
};

export type Wishes = {
  readonly parts: Parts;
  readonly holes: Holes;
  readonly placement: Placement;
  /** Details up to about this many cells are rounded off; 0 leaves all as it is. */
  readonly smoothing: number;
};

/** Throws when nothing is left that a grid could see. */
export function prepared(loops: Shape, { parts, holes, placement, smoothing }: Wishes): Prepared {
  const chosen = chosenParts(largest(loops, MOST_ASKED), parts, holes);
  let box = placement === "fit" ? centring(chosen) : IN_PLACE;
  let shape: Shape = transformed(chosen, box).filter(isSizeable);
  const specks = chosen.length - shape.length;
  if (specks > 0 && placement === "fit" && shape.length > 0) {
    // Specks far out have made the rest smaller than it need be.
    const sizeable = chosen.filter((loop) => isSizeable(transformed([loop], box)[0]));
    box = centring(sizeable);
    shape = transformed(sizeable, box);
  }
  if (shape.length === 0) {
    throw new ImportError("Nothing is left that is larger than a cell of the grid; scale the shape up.");
  }
  const notes: string[] = [];
  if (specks > 0)
    notes.push(`${counted(specks, "speck")} smaller than a cell ${specks === 1 ? "is" : "are"} left out.`);
  if (shape.length > MOST_LOOPS) {
    const before = loops.length > MOST_ASKED ? loops.length : shape.length;
    notes.push(`Of ${before} loops the ${MOST_LOOPS} largest are taken.`);
    shape = largest(shape, MOST_LOOPS);
  }
  if (smoothing > 0) {
    // Where a neck is thinner than that, its two sides may come to cross.
    const smooth = shape.map((loop) => rounded(loop, smoothing * CELL));
    shape = united([{ loops: smooth, rule: "nonzero" }]).filter(isSizeable);
  }
  let coarsest = 0;
  const simple = shape.map((loop) => {
    const { points, tolerance } = simplified(loop);
    coarsest = Math.max(coarsest, tolerance);
    return points;
  });
  if (coarsest > CELL / 4) notes.push(`Details finer than ${(coarsest / CELL).toFixed(1)} cells are smoothed away.`);
  return { shape: simple, notes, box };
}

const IN_PLACE: Similarity = { a: 1, b: 0, x: 0, y: 0 };

/** Scales and centres as the page's own Fit does. */
function centring(shape: Shape): Similarity {
  const box = bounds(shape);
  const extent = box ? Math.max(box.right - box.left, box.top - box.bottom) : 0;
  if (!box || !(extent > 0)) return IN_PLACE;
  const a = FITTED_SIZE / extent;
  return { a, b: 0, x: 0.5 - (a * (box.left + box.right)) / 2, y: 0.5 - (a * (box.bottom + box.top)) / 2 };
}

/**
 * The loop convolved along its length with a Gaussian of the given width (standard deviation): k rounds of
 * [1 2 1] / 4 on points a step s apart have the variance k s² / 2.
 */
export function rounded(loop: Loop, width: number): Loop {
  const count = Math.min(MOST_EVEN, Math.max(16, Math.ceil(perimeter(loop) / Math.min(width / 2, CELL / 2))));
  const step = perimeter(loop) / count;
  const rounds = Math.round(2 * (width / step) ** 2);
  let current = resampled(loop, count);
  for (let round = 0; round < rounds; round += 1) current = averaged(current, 0.5);
  return current;
}

/** Larger than a cell both in area and along each side. */
function isSizeable(loop: Loop): boolean {
  const box = bounds([loop]);
  return (
    box !== null &&
    Math.abs(signedArea(loop)) >= CELL * CELL &&
    Math.max(box.right - box.left, box.top - box.bottom) >= CELL
  );
}

/** At most so many loops, those that enclose most. */
function largest(shape: Shape, most: number): Shape {
  if (shape.length <= most) return shape;
  const size = (loop: Loop) => Math.abs(signedArea(loop));
  return [...shape].sort((a, b) => size(b) - size(a)).slice(0, most);
}

function counted(count: number, noun: string): string {
  return `${count} ${noun}${count === 1 ? "" : "s"}`;
}

/**
 * The loop with at most `MOST_POINTS` points, none of its old ones further than `tolerance` from it. Corners stay
 * corners; then long edges are divided, so that pulling the curve finds points everywhere.
 */
export function simplified(loop: Loop): { readonly points: Loop; readonly tolerance: number } {
  const { points, tolerance } = thinned(loop, FINEST, MOST_CORNERS);
  return { points: divided(points, perimeter(points) / PIECES), tolerance };
}
