/**
 * Closed polygons in the unit box: what can be measured on them and done to them.
 *
 * A loop is x y x y …, domain units, y up, without repeating its first point. A shape is a list of loops; its inside
 * is where the winding number is not zero, so a hole runs the other way round than the loop around it.
 * Every function returns new arrays; loops are never changed in place.
 */

export type Loop = Float64Array;
export type Shape = readonly Loop[];
export type Point = { readonly x: number; readonly y: number };
export type Bounds = { readonly left: number; readonly right: number; readonly bottom: number; readonly top: number };

/** The matrix [a −b; b a] followed by a shift: every map that keeps angles and orientation. */
export type Similarity = { readonly a: number; readonly b: number; readonly x: number; readonly y: number };

/** Points a drawn loop is resampled to. */
export const SAMPLES = 200;

/** The part of the box's side that a fitted shape fills; leaves a fifth of the box free on either side. */
export const FITTED_SIZE = 0.6;

/** Cells of the finest grid that the solver keeps shapes from the border. */
export const CLEARANCE = 2;

/** The part 0…1 of the way (u, v) at which it comes nearest to (x, y). */
export function nearestPart(u: number, v: number, x: number, y: number): number {
  const square = u * u + v * v;
  return square > 0 ? Math.min(1, Math.max(0, (x * u + y * v) / square)) : 0;
}

/** Half the shoelace sum: positive when the loop runs counter-clockwise. Units: length². */
export function signedArea(loop: Loop): number {
  let twice = 0;
  for (let i = 0, j = loop.length - 2; i < loop.length; j = i, i += 2) {
    twice += loop[j] * loop[i + 1] - loop[i] * loop[j + 1];
  }
  return twice / 2;
}

export function perimeter(loop: Loop): number {
  let length = 0;
  for (let i = 0, j = loop.length - 2; i < loop.length; j = i, i += 2) {
    length += Math.hypot(loop[i] - loop[j], loop[i + 1] - loop[j + 1]);
  }
  return length;
}

/** The box around all loops; null for a shape without points. */
export function bounds(shape: Shape): Bounds | null {
  let left = Infinity;
  let right = -Infinity;
  let bottom = Infinity;
  let top = -Infinity;
  for (const loop of shape) {
    for (let i = 0; i < loop.length; i += 2) {
      left = Math.min(left, loop[i]);
      right = Math.max(right, loop[i]);
      bottom = Math.min(bottom, loop[i + 1]);
      top = Math.max(top, loop[i + 1]);
    }
  }
  return left <= right ? { left, right, bottom, top } : null;
}

/** The centre of gravity of the enclosed area, or of the box around the shape where no area is enclosed. */
export function centroid(shape: Shape): Point {
  let area = 0;
  let x = 0;
  let y = 0;
  for (const loop of shape) {
    for (let i = 0, j = loop.length - 2; i < loop.length; j = i, i += 2) {
      const cross = loop[j] * loop[i + 1] - loop[i] * loop[j + 1];
      area += cross / 2;
      x += ((loop[j] + loop[i]) * cross) / 6;
      y += ((loop[j + 1] + loop[i + 1]) * cross) / 6;
    }
  }
  if (Math.abs(area) > 1e-9) return { x: x / area, y: y / area };
  const box = bounds(shape);
  return box ? { x: (box.left + box.right) / 2, y: (box.bottom + box.top) / 2 } : { x: 0.5, y: 0.5 };
}

export function reversed(loop: Loop): Loop {
  const out = new Float64Array(loop.length);
  for (let i = 0; i < loop.length; i += 2) {
    out[i] = loop[loop.length - 2 - i];
    out[i + 1] = loop[loop.length - 1 - i];
  }
  return out;
}

export function transformed(shape: Shape, map: Similarity): Shape {
  return shape.map((loop) => {
    const out = new Float64Array(loop.length);
    for (let i = 0; i < loop.length; i += 2) {
      out[i] = map.a * loop[i] - map.b * loop[i + 1] + map.x;
      out[i + 1] = map.b * loop[i] + map.a * loop[i + 1] + map.y;
    }
    return out;
  });
}

/** Scales by `factor` and turns by `angle` (radians, counter-clockwise) about `centre`. */
export function about(centre: Point, factor: number, angle: number): Similarity {
  const a = factor * Math.cos(angle);
  const b = factor * Math.sin(angle);
  return { a, b, x: centre.x - a * centre.x + b * centre.y, y: centre.y - b * centre.x - a * centre.y };
}

export function shift(x: number, y: number): Similarity {
  return { a: 1, b: 0, x, y };
}

/** What takes the first two points to the second two; null where the first are one, or there are no two. */
export function similarityTaking([a, b]: readonly Point[], [c, d]: readonly Point[]): Similarity | null {
  if (!a || !b || !c || !d) return null;
  const [x, y, u, v] = [b.x - a.x, b.y - a.y, d.x - c.x, d.y - c.y];
  const square = x * x + y * y;
  if (square === 0) return null;
  const [along, across] = [(x * u + y * v) / square, (x * v - y * u) / square];
  return { a: along, b: across, x: c.x - along * a.x + across * a.y, y: c.y - across * a.x - along * a.y };
}

/** Scales and centres the shape so that its longer side is `size`. A single point only moves to the middle. */
export function fitted(shape: Shape, size = FITTED_SIZE): Shape {
  const box = bounds(shape);
  if (!box) return shape;
  const extent = Math.max(box.right - box.left, box.top - box.bottom);
  const a = extent > 0 ? size / extent : 1;
  return transformed(shape, {
    a,
    b: 0,
    x: 0.5 - (a * (box.left + box.right)) / 2,
    y: 0.5 - (a * (box.bottom + box.top)) / 2,
  });
}

/** How often the shape winds around the point, counter-clockwise. */
export function winding(shape: Shape, { x, y }: Point): number {
  let turns = 0;
  for (const loop of shape) {
    for (let i = 0, j = loop.length - 2; i < loop.length; j = i, i += 2) {
      const up = loop[j + 1] <= y && loop[i + 1] > y;
      const down = loop[j + 1] > y && loop[i + 1] <= y;
      if (!up && !down) continue;
      const side = (loop[i] - loop[j]) * (y - loop[j + 1]) - (x - loop[j]) * (loop[i + 1] - loop[j + 1]);
      if (up && side > 0) turns += 1;
      if (down && side < 0) turns -= 1;
    }
  }
  return turns;
}

export function contains(shape: Shape, point: Point): boolean {
  return winding(shape, point) !== 0;
}

/** `count` points at equal arc length along the closed loop, starting at its first point. */
export function resampled(loop: Loop, count: number): Loop {
  const length = perimeter(loop);
  const out = new Float64Array(2 * count);
  const n = loop.length / 2;
  let travelled = 0;
  let i = 0;
  let step = edge(loop, 0);
  for (let k = 0; k < count; k += 1) {
    const target = (k * length) / count;
    while (i < n - 1 && travelled + step < target) {
      travelled += step;
      i += 1;
      step = edge(loop, i);
    }
    const s = step > 0 ? Math.min(1, (target - travelled) / step) : 0;
    const j = (i + 1) % n;
    out[2 * k] = loop[2 * i] + s * (loop[2 * j] - loop[2 * i]);
    out[2 * k + 1] = loop[2 * i + 1] + s * (loop[2 * j + 1] - loop[2 * i + 1]);
  }
  return out;
}

function edge(loop: Loop, i: number): number {
  const j = (i + 1) % (loop.length / 2);
  return Math.hypot(loop[2 * j] - loop[2 * i], loop[2 * j + 1] - loop[2 * i + 1]);
}

/**
 * Takes the hand's tremor out of an evenly sampled loop: `passes` rounds of averaging, each followed by a slightly
 * stronger step back, so that the curve does not shrink (Taubin, "A signal processing approach to fair surface
 * design", 1995).
 */
export function smoothed(loop: Loop, passes: number): Loop {
  let current = loop;
  for (let pass = 0; pass < passes; pass += 1) {
    current = averaged(averaged(current, 0.5), -0.53);
  }
  return current;
}

/** Every point moved by `weight` of the way to the middle of its neighbours. */
export function averaged(loop: Loop, weight: number): Loop {
  const size = loop.length;
  const out = new Float64Array(size);
  for (let i = 0; i < size; i += 1) {
    const middle = (loop[(i + size - 2) % size] + loop[(i + 2) % size]) / 2;
    out[i] = loop[i] + weight * (middle - loop[i]);
  }
  return out;
}

export type Nearest = { readonly loop: number; readonly vertex: number; readonly distance: number };

/** The vertex nearest to the point; null for a shape without points. */
export function nearestVertex(shape: Shape, point: Point): Nearest | null {
  let best: Nearest | null = null;
  for (let l = 0; l < shape.length; l += 1) {
    for (let i = 0; i < shape[l].length; i += 2) {
      const distance = Math.hypot(shape[l][i] - point.x, shape[l][i + 1] - point.y);
      if (!best || distance < best.distance) best = { loop: l, vertex: i / 2, distance };
    }
  }
  return best;
}
