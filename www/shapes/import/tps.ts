/** The specimens of a TPS file as shapes: each curve an outline, its landmarks beside it. */

import { readTps, type Specimen } from "../../morphometrics/tps";
import { bounds, type Loop } from "../geometry";
import { type Choice, type FoundShapes, ImportError } from "./found";
import { choicesFrom, shapeFromLoops } from "./loops";

/** Curves whose ends lie nearer to each other than this part of the specimen go on in one another. */
const TOUCHING = 1e-4;

export function readTpsShapes(text: string): FoundShapes {
  const notes = new Set<string>();
  const choices = choicesFrom(readTps(text), nameOf, (specimen, name) => choice(specimen, name, notes));
  return { kind: "shapes", choices, notes: [...notes] };
}

function nameOf({ id, image }: Specimen, index: number): string {
  return id || image?.replace(/\.\w+$/, "") || `Specimen ${index + 1}`;
}

function choice({ image, landmarks, curves, scale }: Specimen, name: string, notes: Set<string>): Choice {
  const drawn = curves.map(present).filter((curve) => curve.length > 0);
  const points = present(landmarks);
  if (drawn.length === 0 && points.length < 6) {
    throw new ImportError(
      `${name} has no outline: no curve, and of its ${landmarks.length / 2} landmarks ${points.length / 2} are there (negative coordinates mean a missing point).`,
    );
  }
  if (drawn.length === 0) notes.add("Without curves the landmarks themselves, in their order, are the outline.");
  const shape = shapeFromLoops(name, drawn.length > 0 ? chained(drawn) : [points]);
  return { ...shape, marks: { landmarks: drawn.length > 0 ? landmarks : new Float64Array(), image, scale } };
}

/** Without the points that are missing. */
function present(points: Float64Array): Float64Array {
  return points.filter((_, i) => !Number.isNaN(points[i]));
}

/** Open curves that begin where the one before ends make one outline. */
function chained(curves: readonly Float64Array[]): Loop[] {
  const box = bounds(curves);
  const reach = box ? TOUCHING * Math.max(box.right - box.left, box.top - box.bottom) : 0;
  /** From the last point of one to the first of the other. */
  const touch = (a: Float64Array, b: Float64Array) =>
    Math.hypot(a[a.length - 2] - b[0], a[a.length - 1] - b[1]) <= reach;
  const out: Float64Array[] = [];
  for (const curve of curves) {
    const last = out.at(-1);
    if (last && !touch(last, last) && touch(last, curve)) out[out.length - 1] = joined(last, curve.subarray(2));
    else out.push(curve);
  }
  // The last point is joined to the first; where it repeats it, it goes.
  return out.map((loop) => (loop.length > 6 && touch(loop, loop) ? loop.subarray(0, -2) : loop));
}

function joined(a: Float64Array, b: Float64Array): Float64Array {
  const out = new Float64Array(a.length + b.length);
  out.set(a);
  out.set(b, a.length);
  return out;
}
