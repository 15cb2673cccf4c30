/** Pixels to ink: how much of each pixel belongs to the shape, and where to cut (Otsu). */

import { ImportError, type Picture } from "./found";

/** Pixels less opaque than this are see-through; a picture with more than this part of them is cut by its alpha. */
const OPAQUE = 250;
const TRANSPARENT_SHARE = 0.002;

/** Pictures whose ink varies less than this hold no outline. */
const LEAST_CONTRAST = 10;

/** `rgba` as a canvas gives it, row 0 on top. Dark pixels are ink, or opaque ones where the picture has transparency. */
export function pictureFrom(rgba: Uint8ClampedArray, width: number, height: number): Picture {
  const count = width * height;
  let transparent = 0;
  for (let i = 0; i < count; i += 1) if (rgba[4 * i + 3] < OPAQUE) transparent += 1;
  const byAlpha = transparent > TRANSPARENT_SHARE * count && transparent < count;
  const raw = new Uint8Array(count);
  for (let i = 0; i < count; i += 1) {
    const [r, g, b, a] = [rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2], rgba[4 * i + 3]];
    // Rec. 709 luma, over white.
    const light = 0.2126 * r + 0.7152 * g + 0.0722 * b;
    raw[i] = byAlpha ? a : Math.round(((255 - light) * a) / 255);
  }
  const ink = blurred(raw, width, height);
  let [least, most] = [255, 0];
  for (const value of ink) {
    least = Math.min(least, value);
    most = Math.max(most, value);
  }
  if (most - least < LEAST_CONTRAST) {
    throw new ImportError("The picture is nearly uniform: there is no outline in it. Choose one with more contrast.");
  }
  const threshold = otsu(ink);
  return { width, height, ink, threshold, borderIsInk: borderShare(ink, width, height, threshold) > 0.5 };
}

/**
 * The threshold that maximises the variance between the two classes (Otsu, "A threshold selection method from
 * gray-level histograms", 1979): values above it are ink. The middle of the maximum where it is flat.
 */
export function otsu(values: Uint8Array): number {
  const histogram = new Float64Array(256);
  for (const value of values) histogram[value] += 1;
  let sum = 0;
  for (let i = 0; i < 256; i += 1) sum += i * histogram[i];
  let [below, sumBelow, best, first, last] = [0, 0, -1, 0, 0];
  for (let t = 0; t < 255; t += 1) {
    below += histogram[t];
    sumBelow += t * histogram[t];
    const above = values.length - below;
    if (below === 0 || above === 0) continue;
    const variance = below * above * (sumBelow / below - (sum - sumBelow) / above) ** 2;
    if (variance > best * (1 + 1e-12)) {
      best = variance;
      first = t;
      last = t;
    } else if (variance >= best * (1 - 1e-12)) last = t;
  }
  return (first + last + 1) / 2;
}

/** One round of [1 2 1] / 4 in either direction: takes the steps out of pictures without grey, and single pixels. */
export function blurred(values: Uint8Array, width: number, height: number): Uint8Array {
  const pass = (from: Uint8Array, stride: number, length: number, lines: number, between: number) => {
    const out = new Uint8Array(from.length);
    for (let line = 0; line < lines; line += 1) {
      for (let k = 0; k < length; k += 1) {
        const at = line * between + k * stride;
        const before = k > 0 ? from[at - stride] : from[at];
        const after = k < length - 1 ? from[at + stride] : from[at];
        out[at] = (before + 2 * from[at] + after + 2) >> 2;
      }
    }
    return out;
  };
  return pass(pass(values, 1, width, height, width), width, height, width, 1);
}

function borderShare(ink: Uint8Array, width: number, height: number, threshold: number): number {
  let [dark, all] = [0, 0];
  const look = (i: number) => {
    all += 1;
    if (ink[i] > threshold) dark += 1;
  };
  for (let x = 0; x < width; x += 1) {
    look(x);
    look((height - 1) * width + x);
  }
  for (let y = 0; y < height; y += 1) {
    look(y * width);
    look(y * width + width - 1);
  }
  return dark / all;
}
