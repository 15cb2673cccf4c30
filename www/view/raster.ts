/** Pictures and fields carried along by a deformation, pixel by pixel. */

import { type GridMap, mapped } from "./field";

export type Picture = {
  readonly width: number;
  readonly height: number;
  readonly data: Uint8ClampedArray<ArrayBuffer>;
};

/** Where pixels lie: domain units, y up; `scale` pixels a unit. */
export type Raster = {
  readonly left: number;
  readonly bottom: number;
  readonly scale: number;
  readonly width: number;
  readonly height: number;
};

/**
 * For every pixel in φ of the box, calls `paint` with its index and the point of the box that φ takes to its middle.
 * Each cell is taken as two triangles, on which the inverse is linear.
 */
export function carried(raster: Raster, map: GridMap, paint: (pixel: number, x: number, y: number) => void): void {
  const { cells } = map;
  const side = cells + 1;
  for (let j = 0; j < cells; j += 1) {
    for (let i = 0; i < cells; i += 1) {
      const a = j * side + i;
      triangle(raster, map, a, a + 1, a + side + 1, paint);
      triangle(raster, map, a, a + side + 1, a + side, paint);
    }
  }
}

function triangle(
  { left, bottom, scale, width, height }: Raster,
  { cells, deformation: d }: GridMap,
  a: number,
  b: number,
  c: number,
  paint: (pixel: number, x: number, y: number) => void,
): void {
  const side = cells + 1;
  const px = (node: number) => (d[2 * node] - left) * scale - 0.5;
  const py = (node: number) => height - (d[2 * node + 1] - bottom) * scale - 0.5;
  const ax = px(a);
  const ay = py(a);
  const ux = px(b) - ax;
  const uy = py(b) - ay;
  const vx = px(c) - ax;
  const vy = py(c) - ay;
  const twice = ux * vy - uy * vx;
  if (twice === 0) return;
  const x0 = a % side;
  const y0 = (a - x0) / side;
  const bx = (b % side) - x0;
  const by = Math.floor(b / side) - y0;
  const cx = (c % side) - x0;
  const cy = Math.floor(c / side) - y0;
  const top = Math.max(0, Math.ceil(ay + Math.min(0, uy, vy)));
  const low = Math.min(height - 1, Math.floor(ay + Math.max(0, uy, vy)));
  const first = Math.max(0, Math.ceil(ax + Math.min(0, ux, vx)));
  const last = Math.min(width - 1, Math.floor(ax + Math.max(0, ux, vx)));
  for (let row = top; row <= low; row += 1) {
    for (let column = first; column <= last; column += 1) {
      const p = column - ax;
      const q = row - ay;
      const s = (p * vy - q * vx) / twice;
      const t = (ux * q - uy * p) / twice;
      // A hair beyond the edges: neither triangle may leave a pixel on their common edge to the other.
      if (s < -1e-6 || t < -1e-6 || s + t > 1 + 1e-6) continue;
      paint(row * width + column, (x0 + s * bx + t * cx) / cells, (y0 + s * by + t * cy) / cells);
    }
  }
}

/** For every pixel in the box, calls `paint` with its index and where φ takes its middle. */
export function pulledBack(raster: Raster, map: GridMap, paint: (pixel: number, x: number, y: number) => void): void {
  const { left, bottom, scale, width, height } = raster;
  for (let row = 0; row < height; row += 1) {
    const y = bottom + (height - row - 0.5) / scale;
    if (y < 0 || y > 1) continue;
    for (let column = 0; column < width; column += 1) {
      const x = left + (column + 0.5) / scale;
      if (x >= 0 && x <= 1) paint(row * width + column, ...mapped(map, x, y));
    }
  }
}

/** Copies the picture's colour at a point of the box into four bytes; beyond the picture nothing is written. */
export function sample(picture: Picture, x: number, y: number, into: Uint8ClampedArray, pixel: number): void {
  if (x < 0 || x > 1 || y < 0 || y > 1) return;
  const { width, height, data } = picture;
  const u = Math.min(width - 1, Math.max(0, x * width - 0.5));
  const v = Math.min(height - 1, Math.max(0, (1 - y) * height - 0.5));
  const i = Math.min(width - 2, Math.floor(u));
  const j = Math.min(height - 2, Math.floor(v));
  const s = u - i;
  const t = v - j;
  const a = 4 * (j * width + i);
  const b = a + 4 * width;
  for (let k = 0; k < 4; k += 1) {
    into[4 * pixel + k] =
      (1 - t) * ((1 - s) * data[a + k] + s * data[a + 4 + k]) + t * ((1 - s) * data[b + k] + s * data[b + 4 + k]);
  }
}
