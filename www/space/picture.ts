/** Pictures of surfaces without a screen: triangles painted into memory, then PNG as the address of an image. */

import { lensOf, type Pose, projected, START } from "./camera";
import { colours } from "./colours";
import { png } from "./png";
import { dot, normals, unit, type Vector } from "./solid";

export type Subject = {
  /** x y z a vertex. */
  readonly positions: ArrayLike<number>;
  readonly indices: Uint32Array;
  /** Where in the reference's box each vertex belongs: equal places look alike. */
  readonly places: ArrayLike<number>;
};

/** Samples a pixel and direction. */
const SAMPLES = 2;
/** Of the surface's own net, as in the page's views. */
const LINES = 14;
const INK = 0.38;
/** Half the width of a line, in its spacings. */
const LINE_WIDTH = 0.045;
const LIGHT: Vector = [-0.35, 0.45, 0.82];
/** Steps of a channel: more cannot be told apart on a curved surface, and fewer make smaller files. */
const STEP = 6;

/** A picture of equal colours, `side` pixels wide and high, as `data:` address. */
export async function picture({ positions, indices, places }: Subject, side: number, pose: Pose = START) {
  const size = side * SAMPLES;
  const lens = lensOf(pose);
  const { away, right, up } = lens;
  const count = positions.length / 3;
  const screen = new Float64Array(3 * count);
  const shade = new Float64Array(count);
  const paint = colours(places);
  const facing = normals(positions, indices);
  const light = unit(LIGHT);
  for (let v = 0; v < count; v += 1) {
    const [x, y, depth] = projected(lens, [positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]]);
    screen.set([(size / 2) * (1 + x), (size / 2) * (1 - y), depth], 3 * v);
    const n: Vector = [facing[3 * v], facing[3 * v + 1], facing[3 * v + 2]];
    shade[v] = Math.min(1, 0.6 + 0.45 * Math.max(0, dot([dot(n, right), dot(n, up), dot(n, away)], light)));
  }
  const depths = new Float64Array(size * size).fill(Number.POSITIVE_INFINITY);
  const canvas = new Float64Array(3 * size * size);
  for (let k = 0; k < indices.length; k += 3) {
    const corners = [indices[k], indices[k + 1], indices[k + 2]];
    const [ax, bx, cx] = corners.map((v) => screen[3 * v]);
    const [ay, by, cy] = corners.map((v) => screen[3 * v + 1]);
    const area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
    if (area === 0) continue;
    const [left, most] = [Math.max(0, Math.ceil(Math.min(ax, bx, cx))), Math.min(size - 1, Math.max(ax, bx, cx))];
    const [top, bottom] = [Math.max(0, Math.ceil(Math.min(ay, by, cy))), Math.min(size - 1, Math.max(ay, by, cy))];
    for (let y = top; y <= bottom; y += 1)
      for (let x = left; x <= most; x += 1) {
        const b = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / area;
        const c = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / area;
        const a = 1 - b - c;
        if (a < 0 || b < 0 || c < 0) continue;
        const mixed = (values: ArrayLike<number>, width: number, offset: number) =>
          a * values[width * corners[0] + offset] +
          b * values[width * corners[1] + offset] +
          c * values[width * corners[2] + offset];
        const depth = mixed(screen, 3, 2);
        const pixel = y * size + x;
        if (depth >= depths[pixel]) continue;
        depths[pixel] = depth;
        const isLine = [0, 1, 2].some((axis) => {
          const at = mixed(places, 3, axis) * LINES + 0.5;
          return Math.abs(at - Math.floor(at) - 0.5) > 0.5 - LINE_WIDTH;
        });
        const dim = mixed(shade, 1, 0) * (isLine ? 1 - INK : 1);
        for (let channel = 0; channel < 3; channel += 1)
          canvas[3 * pixel + channel] = 255 * dim * mixed(paint, 3, channel);
      }
  }
  return png(side, side, reduced(canvas, depths, side));
}

/** Samples as pixels, red green blue alpha: transparent where there is nothing. */
function reduced(canvas: Float64Array, depths: Float64Array, side: number): Uint8Array {
  const out = new Uint8Array(4 * side * side);
  for (let y = 0; y < side; y += 1)
    for (let x = 0; x < side; x += 1) {
      const sums = [0, 0, 0];
      let seen = 0;
      for (let sample = 0; sample < SAMPLES ** 2; sample += 1) {
        const row = y * SAMPLES + Math.floor(sample / SAMPLES);
        const pixel = row * side * SAMPLES + x * SAMPLES + (sample % SAMPLES);
        if (depths[pixel] === Number.POSITIVE_INFINITY) continue;
        seen += 1;
        for (let channel = 0; channel < 3; channel += 1) sums[channel] += canvas[3 * pixel + channel];
      }
      if (seen === 0) continue;
      const stepped = sums.map((sum) => Math.min(255, STEP * Math.round(sum / seen / STEP)));
      out.set([...stepped, Math.round((255 * seen) / SAMPLES ** 2)], 4 * (y * side + x));
    }
  return out;
}
