/** Path data as polylines: every command of SVG, curves flattened to a tolerance. */

import svgpath from "svgpath";
import { ImportError, MOST_NUMBER } from "./found";
import { applied, type Matrix } from "./transform";

/** Absolute commands M L H V C Q Z with their numbers; arcs and smooth curves have become C and Q. */
export type Commands = readonly (readonly [string, ...number[]])[];

/** A subpath: x y x y …, and whether it ends where it begins. */
export type Subpath = { readonly points: Float64Array; readonly closed: boolean };

/** More pieces than this a curve never needs. */
const MOST_PIECES = 2000;

export function parsePath(data: string): Commands {
  const path = svgpath(data) as ReturnType<typeof svgpath> & { readonly err?: string };
  if (path.err) {
    throw new ImportError(`Path data cannot be read (${path.err.replace(/^SvgPath: /, "")}); save the drawing again.`);
  }
  const commands: (readonly [string, ...number[]])[] = [];
  path
    .abs()
    .unshort()
    .unarc()
    .iterate((segment) => {
      commands.push([...segment] as [string, ...number[]]);
    });
  const isUsual = (part: string | number) => typeof part === "string" || Math.abs(part) <= MOST_NUMBER;
  if (!commands.every((command) => command.every(isUsual)))
    throw new ImportError("Path data holds a number that is too large to be computed with; take another unit.");
  return commands;
}

/** The box around all control points under the matrix: left, bottom, right, top; null without points. */
export function controlBounds(commands: Commands, matrix: Matrix): readonly [number, number, number, number] | null {
  let [left, low, right, high] = [Infinity, Infinity, -Infinity, -Infinity];
  walk(commands, (points) => {
    for (let i = 0; i < points.length; i += 2) {
      const [x, y] = applied(matrix, points[i], points[i + 1]);
      left = Math.min(left, x);
      low = Math.min(low, y);
      right = Math.max(right, x);
      high = Math.max(high, y);
    }
  });
  return left <= right && low <= high ? [left, low, right, high] : null;
}

/**
 * The subpaths under the matrix, nowhere further than `tolerance` from the curves.
 *
 * A Bézier curve cut into n equal parameter steps is at most max |B″| / 8 n² from its chords, and |B″| is at most
 * k (k − 1) times the largest second difference of its control points, k its degree.
 */
export function flattened(commands: Commands, matrix: Matrix, tolerance: number): Subpath[] {
  const found: Subpath[] = [];
  let points: number[] = [];
  const end = (closed: boolean) => {
    const last = points.length - 2;
    const back = last >= 4 && Math.hypot(points[0] - points[last], points[1] - points[last + 1]) <= tolerance;
    if (back) points.length = last;
    if (points.length >= 6) found.push({ points: Float64Array.from(points), closed: closed || back });
    points = [];
  };
  walk(commands, (control, kind) => {
    if (kind === "Z") {
      end(true);
      return;
    }
    const moved: number[] = [];
    for (let i = 0; i < control.length; i += 2) moved.push(...applied(matrix, control[i], control[i + 1]));
    if (kind === "M") {
      end(false);
      points.push(...moved);
      return;
    }
    if (points.length === 0) points.push(moved[0], moved[1]);
    append(points, moved, tolerance);
  });
  end(false);
  return found;
}

/** Calls `visit` with each command's control points, beginning with the current point (but for M). */
function walk(commands: Commands, visit: (points: readonly number[], kind: string) => void): void {
  let [x, y, startX, startY] = [0, 0, 0, 0];
  for (const [kind, ...numbers] of commands) {
    if (kind === "M") {
      [x, y] = numbers;
      [startX, startY] = [x, y];
      visit([x, y], "M");
    } else if (kind === "Z" || kind === "z") {
      visit([], "Z");
      [x, y] = [startX, startY];
    } else {
      const to = kind === "H" ? [numbers[0], y] : kind === "V" ? [x, numbers[0]] : numbers;
      visit([x, y, ...to], kind);
      [x, y] = to.slice(-2);
    }
  }
}

/** Adds a line (4 numbers), a quadratic (6) or a cubic (8) without its first point. */
function append(points: number[], control: readonly number[], tolerance: number): void {
  const degree = control.length / 2 - 1;
  let bend = 0;
  for (let i = 0; i + 5 < control.length; i += 2) {
    const x = control[i] - 2 * control[i + 2] + control[i + 4];
    const y = control[i + 1] - 2 * control[i + 3] + control[i + 5];
    bend = Math.max(bend, Math.hypot(x, y));
  }
  const needed = Math.ceil(Math.sqrt((degree * (degree - 1) * bend) / (8 * tolerance)));
  const pieces = Math.min(MOST_PIECES, Math.max(1, needed));
  for (let piece = 1; piece <= pieces; piece += 1) {
    const t = piece / pieces;
    const p = control.slice();
    // De Casteljau: stable, and the same for every degree.
    for (let level = degree; level > 0; level -= 1) {
      for (let i = 0; i < 2 * level; i += 1) p[i] += t * (p[i + 2] - p[i]);
    }
    if (piece === pieces) points.push(control[2 * degree], control[2 * degree + 1]);
    else points.push(p[0], p[1]);
  }
}
