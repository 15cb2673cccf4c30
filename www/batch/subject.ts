/** A shape of a batch: where it lies in the box, and the way back to the units of its file. */

import type { Similarity } from "../shapes/geometry";
import type { Offered } from "../shapes/import/content";
import type { Prepared } from "../shapes/import/fit";
import { isInBox, MOST_PINS, type Shapes } from "../shapes/pins";
import { batch as say } from "../words/batch";

export type Subject = {
  readonly name: string;
  /** In the box. */
  readonly shape: Shapes["reference"];
  /** From the file's units to the box. */
  readonly box: Similarity;
  /** In the box; NaN twice where one is missing. */
  readonly landmarks: Float64Array;
  readonly image: string | null;
  /** True units in one of the file's. */
  readonly scale: number | null;
};

export function subjectOf(name: string, { marks }: Pick<Offered, "marks">, { shape, box }: Prepared): Subject {
  const { landmarks = new Float64Array(), image = null, scale = null } = marks ?? {};
  return { name, shape, box, landmarks: placed(landmarks, box), image, scale };
}

function placed(points: Float64Array, { a, b, x, y }: Similarity): Float64Array {
  return points.map((value, i) =>
    i % 2 === 0 ? a * value - b * points[i + 1] + x : b * points[i - 1] + a * value + y,
  );
}

/** Points of the box in the units of the subject's file. */
export function own(points: Float64Array, { a, b, x, y }: Similarity): Float64Array {
  const square = a * a + b * b;
  return points.map((value, i) => {
    const [u, v] = i % 2 === 0 ? [value - x, points[i + 1] - y] : [points[i - 1] - x, value - y];
    return (i % 2 === 0 ? a * u + b * v : a * v - b * u) / square;
  });
}

/** Landmarks of equal number tied to each other, those that are there on both; and what there is to say of it. */
export function tied(reference: Subject, target: Subject): Pick<Shapes, "pins"> & { readonly note: string | null } {
  const [p, q] = [reference.landmarks, target.landmarks];
  if (p.length === 0 || q.length === 0) return { pins: [], note: null };
  if (p.length !== q.length) return { pins: [], note: say.unlike(p.length / 2, q.length / 2) };
  const pins = Array.from({ length: p.length / 2 }, (_, i) => ({
    reference: { x: p[2 * i], y: p[2 * i + 1] },
    template: { x: q[2 * i], y: q[2 * i + 1] },
  })).filter((pin) => [pin.reference, pin.template].every(({ x, y }) => isInBox(x) && isInBox(y)));
  const note = pins.length > MOST_PINS ? say.firstLandmarks(pins.length, MOST_PINS) : null;
  return { pins: pins.slice(0, MOST_PINS), note };
}
