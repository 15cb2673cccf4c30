/**
 * Colour scales for numbers: straight paths through OKLab, so that equal steps of the number are equal steps for the
 * eye. Both run between blue and yellow or orange, which every common colour blindness tells apart, and both change
 * their lightness on the way, so that they survive a grey print.
 */

import { plain } from "../words/numbers";
import { type Rgb, rgbFromOklab } from "./palette";

const STEPS = 256;

/** From dark blue to light yellow: lightness, green-red, blue-yellow. */
const DARK_BLUE: Rgb = [0.3, -0.01, -0.1];
const LIGHT_YELLOW: Rgb = [0.92, -0.02, 0.13];

const BLUE: Rgb = [0.5, -0.03, -0.14];
const ORANGE: Rgb = [0.55, 0.07, 0.11];
const PALE: Rgb = [0.96, 0, 0];
const LIGHT_BLUE: Rgb = [0.75, -0.05, -0.1];
const LIGHT_ORANGE: Rgb = [0.78, 0.05, 0.12];
const DIM: Rgb = [0.3, 0, 0];

export type Colour = readonly [red: number, green: number, blue: number];

/** For amounts from nothing up. */
export const SEQUENTIAL: readonly Colour[] = table((t) => mixed(DARK_BLUE, LIGHT_YELLOW, t));

/** For ratios and signed numbers: the middle stands for no change and goes with the page's background. */
export const DIVERGING = {
  light: table((t) => (t < 0.5 ? mixed(BLUE, PALE, 2 * t) : mixed(PALE, ORANGE, 2 * t - 1))),
  dark: table((t) => (t < 0.5 ? mixed(LIGHT_BLUE, DIM, 2 * t) : mixed(DIM, LIGHT_ORANGE, 2 * t - 1))),
};

export function mixed(from: Rgb, to: Rgb, t: number): Rgb {
  return [from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1]), from[2] + t * (to[2] - from[2])];
}

function table(path: (t: number) => Rgb): readonly Colour[] {
  return Array.from({ length: STEPS }, (_, i) => {
    const rgb = rgbFromOklab(...path(i / (STEPS - 1)));
    return rgb.map((channel) => Math.round(255 * Math.min(1, Math.max(0, channel)))) as unknown as Colour;
  });
}

/** Index into a table of the number's place 0…1; beyond the ends, the ends. */
export function place(part: number, length = STEPS): number {
  return Math.min(length - 1, Math.max(0, Math.round(part * (length - 1))));
}

export function css([red, green, blue]: Colour): string {
  return `rgb(${red} ${green} ${blue})`;
}

/** A scale with what its legend says. */
export type Scale = {
  readonly title: string;
  readonly unit: string;
  readonly colours: readonly Colour[];
  /** Where a value stands on the scale, 0 to 1 inside it. */
  readonly part: (value: number) => number;
  readonly ticks: readonly { readonly part: number; readonly text: string }[];
};

/** Values from 0 to `most`. */
export function amounts(title: string, unit: string, most: number): Scale {
  return {
    title,
    unit,
    colours: SEQUENTIAL,
    part: (value) => value / most,
    ticks: [0, 0.5, 1].map((part) => ({ part, text: plain(part * most, 2) })),
  };
}

/** Factors from 2^−doublings to 2^doublings, by their logarithm; 1 in the middle. */
export function factors(title: string, dark: boolean, doublings: number): Scale {
  return {
    title,
    unit: "×",
    colours: dark ? DIVERGING.dark : DIVERGING.light,
    part: (value) => (Math.log2(value) / doublings + 1) / 2,
    ticks: [-1, 0, 1].map((end) => ({ part: (end + 1) / 2, text: plain(2 ** (end * doublings), 2) })),
  };
}

/** Signed values from −most to most; 0 in the middle. */
export function signed(title: string, unit: string, dark: boolean, most: number): Scale {
  return {
    title,
    unit,
    colours: dark ? DIVERGING.dark : DIVERGING.light,
    part: (value) => (value / most + 1) / 2,
    ticks: [-1, 0, 1].map((end) => ({ part: (end + 1) / 2, text: plain(end * most, 2) })),
  };
}

/** Parts of the scale that rounding puts beyond its end. */
const HAIR = 1e-6;

/** The scale with “≤” and “≥” at its ends where there are values beyond: `least` and `most` are places on it. */
export function clipped(scale: Scale, least: number, most: number): Scale {
  const ticks = scale.ticks.map(({ part, text }) => {
    if (part === 0 && least < -HAIR) return { part, text: `≤ ${text}` };
    return part === 1 && most > 1 + HAIR ? { part, text: `≥ ${text}` } : { part, text };
  });
  return { ...scale, ticks };
}

/** 1, 2 or 5 times a power of ten, at least the value. */
export function roundUp(value: number): number {
  if (!(value > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  // Rounding makes 0.3 / 0.1 a little more than 3.
  const step = [1, 2, 5, 10].find((candidate) => candidate * power >= value * (1 - 1e-12)) ?? 10;
  return step * power;
}

/** The value below which the part `share` of all finite values lies; 0 for none. */
export function quantile(values: ArrayLike<number>, share: number): number {
  const sorted = Float64Array.from(Array.from(values).filter(Number.isFinite)).sort();
  return sorted.length === 0 ? 0 : sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
}
