/** What can be measured along a matched curve: stretch, curvature, partners, distances. Plain arrays, domain units. */

import { type Loop, nearestPart } from "../shapes/geometry";

/** A closed polyline's arc length at every point, and its whole length last. */
function lengths(loop: Loop): Float64Array {
  const count = loop.length / 2;
  const out = new Float64Array(count + 1);
  for (let i = 0; i < count; i += 1) {
    const j = (i + 1) % count;
    out[i + 1] = out[i] + Math.hypot(loop[2 * j] - loop[2 * i], loop[2 * j + 1] - loop[2 * i + 1]);
  }
  return out;
}

/** Places next to each other along the loop nearer than `reach` to point i along it, with their signed arc length. */
function window(loop: Loop, arc: Float64Array, i: number, reach: number): { at: number; s: number }[] {
  const count = loop.length / 2;
  const whole = arc[count];
  const out = [{ at: i, s: 0 }];
  for (const direction of [1, -1]) {
    for (let k = 1; k < count / 2; k += 1) {
      const at = (i + direction * k + count) % count;
      const apart = (direction * (arc[at] - arc[i]) + whole) % whole;
      out.push({ at, s: direction * apart });
      // Two neighbours at least, however far they are.
      if (apart > reach) break;
    }
  }
  return out;
}

/**
 * Signed curvature at point i: positive where a counter-clockwise loop is convex. Units: 1/length.
 *
 * From the quadratics x(s), y(s) that fit the points within `reach` along the curve best: κ = (x′ y″ − y′ x″) / |c′|³.
 * Points of extracted curves lie unevenly, and three of them alone would give noise.
 */
export function curvature(loop: Loop, i: number, reach: number, arc = lengths(loop)): number {
  // Normal equations of the fit of 1, s, s² to both coordinates.
  const m = new Float64Array(5);
  const x = new Float64Array(3);
  const y = new Float64Array(3);
  for (const { at, s } of window(loop, arc, i, reach)) {
    const u = s / reach;
    let power = 1;
    for (let k = 0; k < 5; k += 1) {
      m[k] += power;
      if (k < 3) {
        x[k] += power * (loop[2 * at] - loop[2 * i]);
        y[k] += power * (loop[2 * at + 1] - loop[2 * i + 1]);
      }
      power *= u;
    }
  }
  const a = quadratic(m, x);
  const b = quadratic(m, y);
  const speed = Math.hypot(a[1], b[1]);
  return speed > 0 ? (2 * (a[1] * b[2] - b[1] * a[2])) / speed ** 3 : 0;
}

/** The coefficients of 1, s, s² for moments m and right-hand side r; by Cramer's rule. */
function quadratic(m: Float64Array, r: Float64Array): [number, number, number] {
  const det = (a: number[], b: number[], c: number[]) =>
    a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) + c[0] * (a[1] * b[2] - a[2] * b[1]);
  const columns = [
    [m[0], m[1], m[2]],
    [m[1], m[2], m[3]],
    [m[2], m[3], m[4]],
  ];
  const whole = det(columns[0], columns[1], columns[2]);
  const right = [...r];
  return [
    det(right, columns[1], columns[2]) / whole,
    det(columns[0], right, columns[2]) / whole,
    det(columns[0], columns[1], right) / whole,
  ];
}

/** Curvature at every point, for loops that run counter-clockwise around what they enclose. */
export function curvatures(loop: Loop, reach: number): Float64Array {
  const arc = lengths(loop);
  const sign = area(loop) < 0 ? -1 : 1;
  return Float64Array.from({ length: loop.length / 2 }, (_, i) => sign * curvature(loop, i, reach, arc));
}

export function area(loop: Loop): number {
  let twice = 0;
  for (let i = 0, j = loop.length - 2; i < loop.length; j = i, i += 2) {
    twice += loop[j] * loop[i + 1] - loop[i] * loop[j + 1];
  }
  return twice / 2;
}

/** The length around point i after, over before. */
export function stretch(loop: Loop, moved: Loop, i: number): number {
  const n = loop.length / 2;
  const [before, after] = [(i + n - 1) % n, (i + 1) % n];
  const span = (points: Loop) =>
    Math.hypot(points[2 * i] - points[2 * before], points[2 * i + 1] - points[2 * before + 1]) +
    Math.hypot(points[2 * after] - points[2 * i], points[2 * after + 1] - points[2 * i + 1]);
  return span(moved) / span(loop);
}

export type Nearest = {
  readonly loop: number;
  /** The nearer end of the edge. */
  readonly point: number;
  /** From point `edge` to the next, and the part 0…1 of the way. */
  readonly edge: number;
  readonly part: number;
  readonly distance: number;
};

/** The nearest place on the closed polylines; null without any. */
export function nearest(loops: readonly Loop[], x: number, y: number): Nearest | null {
  let best: Nearest | null = null;
  for (let l = 0; l < loops.length; l += 1) {
    const loop = loops[l];
    const n = loop.length;
    for (let j = 0; j < n; j += 2) {
      const i = (j + 2) % n;
      const u = loop[i] - loop[j];
      const v = loop[i + 1] - loop[j + 1];
      const a = x - loop[j];
      const b = y - loop[j + 1];
      const t = nearestPart(u, v, a, b);
      const distance = Math.hypot(a - t * u, b - t * v);
      if (!best || distance < best.distance) {
        best = { loop: l, point: (t < 0.5 ? j : i) / 2, edge: j / 2, part: t, distance };
      }
    }
  }
  return best;
}

/** Distance to the closed polylines, negative where they enclose an odd number of times. */
export function signedDistance(loops: readonly Loop[], x: number, y: number): number {
  let square = Infinity;
  let inside = false;
  for (const loop of loops) {
    for (let i = 0, j = loop.length - 2; i < loop.length; j = i, i += 2) {
      const u = loop[i] - loop[j];
      const v = loop[i + 1] - loop[j + 1];
      const a = x - loop[j];
      const b = y - loop[j + 1];
      const t = nearestPart(u, v, a, b);
      const p = a - t * u;
      const q = b - t * v;
      if (p * p + q * q < square) square = p * p + q * q;
      if (loop[i + 1] > y !== loop[j + 1] > y && x < loop[j] + (u * b) / v) inside = !inside;
    }
  }
  return inside ? -Math.sqrt(square) : Math.sqrt(square);
}
