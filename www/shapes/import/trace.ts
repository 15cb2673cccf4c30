/** The outline of a picture's ink at a threshold, between the pixels and smooth. */

import { type Loop, perimeter, resampled, type Shape, signedArea, smoothed } from "../geometry";
import type { Picture } from "./found";

/** Loops smaller than this are noise. Units: pixels². */
const LEAST_AREA = 6;

const SMOOTHING_PASSES = 3;

export type Traced = {
  /** Pixels, y up; bodies counter-clockwise, holes clockwise. */
  readonly loops: Shape;
  readonly noise: number;
  /** The shape goes on beyond the picture and is cut there. */
  readonly cut: boolean;
};

/** What is above the threshold is inside, or, flipped, what is below it. */
export function traced(picture: Picture, threshold: number, flipped: boolean): Traced {
  const { width, height, ink } = picture;
  // A frame of outside pixels closes what reaches the border; rows run upwards from here on.
  const columns = width + 2;
  const rows = height + 2;
  const level = new Float32Array(columns * rows).fill(-128);
  let onBorder = 0;
  for (let y = 0; y < height; y += 1) {
    for (let x = 0; x < width; x += 1) {
      const value = ink[(height - 1 - y) * width + x] - threshold;
      // Nowhere exactly zero: a pixel is inside or outside.
      const signed = (flipped ? -value : value) || -1e-3;
      level[(y + 1) * columns + x + 1] = signed;
      if (signed > 0 && (x === 0 || y === 0 || x === width - 1 || y === height - 1)) onBorder += 1;
    }
  }
  let noise = 0;
  const loops: Loop[] = [];
  for (const loop of zeroSet(level, columns, rows)) {
    if (Math.abs(signedArea(loop)) < LEAST_AREA) noise += 1;
    else loops.push(smoothed(resampled(loop, Math.max(16, Math.round(perimeter(loop)))), SMOOTHING_PASSES));
  }
  return { loops, noise, cut: onBorder > 2 };
}

/**
 * Marching squares: closed polylines between the positive and the negative nodes, linear along each edge, the
 * positive side on the left. Nodes x fastest, units of the spacing. Border nodes must be negative, and none zero.
 */
export function zeroSet(level: Float32Array, columns: number, rows: number): Loop[] {
  // Edge 2 n leads right from node n, edge 2 n + 1 up. Each crossed edge begins one piece and ends one.
  const next = new Int32Array(2 * columns * rows).fill(-1);
  for (let y = 0; y + 1 < rows; y += 1) {
    for (let x = 0; x + 1 < columns; x += 1) {
      const node = y * columns + x;
      const corners = [level[node], level[node + 1], level[node + columns + 1], level[node + columns]];
      const signs = corners.map((value) => value > 0);
      if (signs[0] === signs[1] && signs[1] === signs[2] && signs[2] === signs[3]) continue;
      const edges = [2 * node, 2 * (node + 1) + 1, 2 * (node + columns), 2 * node + 1];
      const leaving: number[] = [];
      const entering: number[] = [];
      // Counter-clockwise around the cell; a piece runs from where that leaves the inside to where it enters it.
      for (let k = 0; k < 4; k += 1) {
        if (signs[k] === signs[(k + 1) % 4]) continue;
        (signs[k] ? leaving : entering).push(k);
      }
      if (leaving.length === 1) next[edges[leaving[0]]] = edges[entering[0]];
      else {
        const joined = corners[0] + corners[1] + corners[2] + corners[3] > 0;
        // A saddle: its two inner corners are joined, or each is cut off by itself.
        for (const k of leaving) next[edges[k]] = edges[(k + (joined ? 1 : 3)) % 4];
      }
    }
  }
  const loops: Loop[] = [];
  for (let start = 0; start < next.length; start += 1) {
    if (next[start] < 0) continue;
    const points: number[] = [];
    let edge = start;
    while (next[edge] >= 0) {
      const node = edge >> 1;
      const up = (edge & 1) === 1;
      const other = up ? node + columns : node + 1;
      const part = level[node] / (level[node] - level[other]);
      const x = node % columns;
      const y = (node - x) / columns;
      points.push(x + (up ? 0 : part), y + (up ? part : 0));
      const following = next[edge];
      next[edge] = -1;
      edge = following;
    }
    loops.push(Float64Array.from(points));
  }
  return loops;
}
