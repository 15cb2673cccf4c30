/** Colours of vertices. Equal colours are matched points: a colour belongs to a place in the reference's box. */

import { rgbFromOklab } from "../view/palette";
import { place, type Scale } from "../view/scales";

/**
 * Of places in the box, x y z each, as red, green and blue from 0 to 1. Two directions in the box are the two hues of
 * OKLab, the third is lightness; places that differ look different, and stripes along the height help to compare. What
 * has no partner (not a number) is grey.
 */
export function colours(places: ArrayLike<number>): Float32Array {
  const out = new Float32Array(places.length);
  for (let k = 0; k < places.length; k += 3) {
    const [x, y, z] = [places[k] - 0.5, places[k + 1] - 0.5, places[k + 2] - 0.5];
    if (Number.isNaN(x + y + z)) {
      out.fill(0.5, k, k + 3);
      continue;
    }
    const chroma = (at: number) => 0.16 * Math.tanh(5.5 * at);
    const [r, g, b] = rgbFromOklab(0.68 + 0.2 * Math.tanh(4 * y), chroma(x), chroma(z));
    out.set([inside(r), inside(g), inside(b)], k);
  }
  return out;
}

/** Of numbers on a scale, one a vertex. */
export function scaleColours(values: ArrayLike<number>, scale: Scale): Float32Array {
  const out = new Float32Array(3 * values.length);
  for (let vertex = 0; vertex < values.length; vertex += 1) {
    const colour = scale.colours[place(scale.part(values[vertex]))] ?? [128, 128, 128];
    for (let channel = 0; channel < 3; channel += 1) out[3 * vertex + channel] = colour[channel] / 255;
  }
  return out;
}

export function plainColours(vertices: number, colour: readonly [number, number, number]): Float32Array {
  return Float32Array.from({ length: 3 * vertices }, (_, k) => colour[k % 3]);
}

function inside(channel: number): number {
  return Math.min(1, Math.max(0, channel));
}
