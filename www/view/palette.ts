/**
 * Colours: a cyclic scale for arc length, and the page's own colours read from its style sheet.
 *
 * The scale runs once round the hues of OKLab (Ottosson, "A perceptual color space for image processing", 2020). Its
 * lightness swings once as well, so that opposite points differ for colour-blind eyes too, and its parameter is the
 * length of the path in OKLab: equal steps along the curve are equal steps for the eye.
 */

export type Rgb = readonly [number, number, number];

const STEPS = 360;

/** Chroma that stays inside sRGB all the way round at the lightnesses used below. */
const CHROMA = 0.104;
const SWING = 0.07;

/** OKLab to gamma-coded sRGB, each channel 0 to 1 when inside the gamut. */
export function rgbFromOklab(lightness: number, a: number, b: number): Rgb {
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    coded(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
    coded(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
    coded(-0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s),
  ];
}

function coded(linear: number): number {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055;
}

/** The path in OKLab at angle t: lightest at the yellow hues, where sRGB has room for it. */
export function oklabOnCycle(middle: number, t: number): Rgb {
  return [middle + SWING * Math.cos(t - 1.9), CHROMA * Math.cos(t), CHROMA * Math.sin(t)];
}

/** `STEPS` colours at equal OKLab distances around the cycle. */
function cycle(middle: number): string[] {
  const fine = 20 * STEPS;
  const reached = new Float64Array(fine + 1);
  let before = oklabOnCycle(middle, 0);
  for (let i = 1; i <= fine; i += 1) {
    const here = oklabOnCycle(middle, (2 * Math.PI * i) / fine);
    reached[i] = reached[i - 1] + Math.hypot(here[0] - before[0], here[1] - before[1], here[2] - before[2]);
    before = here;
  }
  const colours: string[] = [];
  let i = 0;
  for (let k = 0; k < STEPS; k += 1) {
    while (reached[i] < (k / STEPS) * reached[fine]) i += 1;
    const [r, g, b] = rgbFromOklab(...oklabOnCycle(middle, (2 * Math.PI * i) / fine));
    colours.push(`rgb(${byte(r)} ${byte(g)} ${byte(b)})`);
  }
  return colours;
}

function byte(channel: number): number {
  return Math.round(255 * Math.min(1, Math.max(0, channel)));
}

export type Theme = {
  readonly dark: boolean;
  readonly paper: string;
  readonly ink: string;
  readonly muted: string;
  readonly grid: string;
  readonly frame: string;
  readonly reference: string;
  readonly template: string;
  readonly warning: string;
  /** Colours of the cyclic scale in order; index 0 follows the last. */
  readonly cycle: readonly string[];
};

/** The scale for either background. */
export const CYCLES = { light: cycle(0.62), dark: cycle(0.74) };

/** Reads the custom properties of style/base.css, so that canvases follow light and dark like the rest of the page. */
export function theme(element: Element = document.documentElement): Theme {
  const style = getComputedStyle(element);
  const dark = matchMedia("(prefers-color-scheme: dark)").matches;
  const colour = (name: string) => style.getPropertyValue(`--${name}`).trim();
  return {
    dark,
    paper: colour("canvas"),
    ink: colour("ink"),
    muted: colour("muted"),
    grid: colour("grid"),
    frame: colour("frame"),
    reference: colour("reference"),
    template: colour("template"),
    warning: colour("warning"),
    cycle: dark ? CYCLES.dark : CYCLES.light,
  };
}

/** The colour at a part 0…1 of the way round. */
export function onCycle(colours: readonly string[], part: number): string {
  const whole = part - Math.floor(part);
  return colours[Math.floor(whole * colours.length) % colours.length];
}
