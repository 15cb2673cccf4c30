/** Smoothing of one closed curve, up to an ellipse. */

import { type Loop, resampled, SAMPLES } from "../shapes/geometry";

/** At the slider's end: what is left then is hardly more than an ellipse. */
const MOST = 0.1;

/**
 * The heat flow of the curve's coordinates along its length, in which the first harmonic keeps its size, so that the
 * curve does not shrink: with c(t) = Σ cₙ e^{int} it is Σ cₙ e^{−τ(n² − 1)} e^{int} for n ≠ 0. `part` runs from 0, the
 * curve itself, to 1; τ = MOST · part⁴, so that fine and coarse details both have room on a slider.
 */
export function rounded(loop: Loop, part: number): Loop {
  if (part === 0) return loop;
  const even = isEven(loop) ? loop : resampled(loop, Math.max(SAMPLES, loop.length / 2));
  const time = MOST * part ** 4;
  const count = even.length / 2;
  const out = new Float64Array(even.length);
  for (let n = -Math.floor((count - 1) / 2); n <= count / 2; n += 1) {
    const weight = n === 0 ? 1 : Math.exp(-time * (n * n - 1));
    if (weight < 1e-9) continue;
    const [re, im] = coefficient(even, n);
    for (let k = 0; k < count; k += 1) {
      const t = (2 * Math.PI * ((n * k) % count)) / count;
      const [cos, sin] = [Math.cos(t), Math.sin(t)];
      out[2 * k] += weight * (re * cos - im * sin);
      out[2 * k + 1] += weight * (re * sin + im * cos);
    }
  }
  return out;
}

/** cₙ of x + iy. */
function coefficient(loop: Loop, n: number): readonly [number, number] {
  const count = loop.length / 2;
  let [re, im] = [0, 0];
  for (let k = 0; k < count; k += 1) {
    const t = (-2 * Math.PI * ((n * k) % count)) / count;
    const [cos, sin] = [Math.cos(t), Math.sin(t)];
    re += loop[2 * k] * cos - loop[2 * k + 1] * sin;
    im += loop[2 * k] * sin + loop[2 * k + 1] * cos;
  }
  return [re / count, im / count];
}

/** Whether the points are so many and so even that they need not be set anew. */
function isEven(loop: Loop): boolean {
  if (loop.length < 2 * SAMPLES) return false;
  let [shortest, longest] = [Infinity, 0];
  for (let i = 0, j = loop.length - 2; i < loop.length; j = i, i += 2) {
    const edge = Math.hypot(loop[i] - loop[j], loop[i + 1] - loop[j + 1]);
    shortest = Math.min(shortest, edge);
    longest = Math.max(longest, edge);
  }
  return longest < 1.5 * shortest;
}
