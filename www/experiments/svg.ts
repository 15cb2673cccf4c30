/**
 * Figures as SVG text: panels of shapes and deformed grids, and charts. Coordinates are rounded to a tenth of a pixel.
 * Every figure brings its paper along and follows the reader's light or dark scheme.
 */

import { gridLines } from "../view/grid";
import { plain, power, withPower } from "../words/numbers";
import { INDEX, withMinus } from "./experiment";

export type Loops = readonly Float64Array[];

const STYLE = `
  text { font: 12px system-ui, "Segoe UI", sans-serif; fill: #1b2130 }
  .paper { fill: #fffefb } .frame { fill: none; stroke: #d8d6cd } .grid { fill: none; stroke: #9aa2b3; stroke-width: .6 }
  .reference { fill: none; stroke: #2b5fd0; stroke-width: 1.2 } .matched { fill: none; stroke: #2b5fd0; stroke-width: 2 }
  .template { fill: none; stroke: #d97a35; stroke-width: 4; opacity: .55 } .tick { stroke: #2b5fd0; stroke-width: .9; opacity: .7 }
  .s0 { stroke: #1b2130 } .s1 { stroke: #0072b2 } .s2 { stroke: #d55e00 } .s3 { stroke: #009e73 } .s4 { stroke: #cc79a7 } .s5 { stroke: #b8860b }
  .series { fill: none; stroke-width: 1.8; stroke-linejoin: round }
  @media (prefers-color-scheme: dark) {
    text { fill: #e7e9ef } .paper { fill: #181c24 } .frame { stroke: #3a4150 } .grid { stroke: #5d6679 }
    .reference, .matched, .tick { stroke: #7ca6ff } .s0 { stroke: #e7e9ef } .s1 { stroke: #56b4e9 } .s2 { stroke: #f09a62 } .s3 { stroke: #3ecfa0 }
  }`.replace(/\n */g, "\n");

export function svg(width: number, height: number, ...parts: string[]): string {
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}">
<style>${STYLE}</style><rect class="paper" width="${width}" height="${height}"/>
${parts.join("\n")}
</svg>
`;
}

export type Panel = {
  readonly title: string;
  readonly note?: string;
  readonly level?: number;
  /** φ at the nodes of `level`: drawn as a deformed grid. */
  readonly deformation?: Float64Array;
  /** Grid lines a direction, a power of two; as many as in the page unless given. */
  readonly lines?: number;
  readonly reference?: Loops;
  readonly template?: Loops;
  readonly matched?: Loops;
  /** Lines from every so many points of the reference to their partners. */
  readonly ticks?: boolean;
  /** An image's address, instead of all that: surfaces are painted, not drawn. */
  readonly picture?: string;
};

const GAP = 12;
const HEAD = 22;
const FOOT = 20;

/** Panels of the unit box, `columns` a row, `size` pixels each. */
export function panels(list: readonly Panel[], columns: number, size: number): string {
  const rows = Math.ceil(list.length / columns);
  const foot = list.some((panel) => panel.note) ? FOOT : 0;
  const height = HEAD + size + foot;
  const window = windowOf(list);
  const parts = list.map((panel, i) => {
    const x = GAP + (i % columns) * (size + GAP);
    const y = GAP / 2 + Math.floor(i / columns) * (height + GAP);
    return `<g transform="translate(${x} ${y})">${onePanel(panel, size, window)}</g>`;
  });
  return svg(GAP + columns * (size + GAP), GAP + rows * (height + GAP), ...parts);
}

/** A square of the plane. */
type Window = { readonly left: number; readonly bottom: number; readonly side: number };

/** Around the curves, as a part of their extent. */
const AROUND = 0.12;

/** What all panels show, so that they can be compared: their curves, and a little around. The box where there are none. */
export function windowOf(list: readonly Panel[]): Window {
  const loops = list.flatMap(({ reference = [], template = [], matched = [] }) => [
    ...reference,
    ...template,
    ...matched,
  ]);
  let [left, right, bottom, top] = [Infinity, -Infinity, Infinity, -Infinity];
  for (const loop of loops) {
    for (let i = 0; i < loop.length; i += 2) {
      left = Math.min(left, loop[i]);
      right = Math.max(right, loop[i]);
      bottom = Math.min(bottom, loop[i + 1]);
      top = Math.max(top, loop[i + 1]);
    }
  }
  if (!(right > left)) return { left: 0, bottom: 0, side: 1 };
  const side = (1 + 2 * AROUND) * Math.max(right - left, top - bottom);
  return { left: (left + right - side) / 2, bottom: (bottom + top - side) / 2, side };
}

function onePanel(panel: Panel, size: number, { left, bottom, side }: Window): string {
  const place: Place = (x, y) => [((x - left) / side) * size, (1 - (y - bottom) / side) * size];
  const closed = (kind: string, loops: Loops = []) =>
    loops.length === 0 ? "" : `<path class="${kind}" d="${loops.map((loop) => outline(loop, place)).join("")}"/>`;
  const { level, deformation } = panel;
  const parts = [
    `<text x="0" y="14">${escaped(panel.title)}</text>`,
    `<rect class="frame" x="0" y="${HEAD}" width="${size}" height="${size}"/>`,
    // An svg of its own cuts off what the natural boundary lets out of the box.
    `<svg y="${HEAD}" width="${size}" height="${size}">`,
    level !== undefined && deformation
      ? `<path class="grid" d="${grid(level, deformation, panel.lines, place)}"/>`
      : "",
    closed("template", panel.template),
    closed("reference", panel.reference),
    closed("matched", panel.matched),
    panel.ticks ? ticks(panel, place) : "",
    panel.picture ? `<image href="${panel.picture}" width="${size}" height="${size}"/>` : "",
    "</svg>",
    panel.note ? `<text x="0" y="${HEAD + size + 15}">${escaped(panel.note)}</text>` : "",
  ];
  return parts.filter((part) => part !== "").join("\n");
}

type Place = (x: number, y: number) => readonly [number, number];

/** A polyline in tenths of a pixel, point by point from the one before: half as long as with whole coordinates. */
function polyline(points: readonly (readonly [number, number])[]): string {
  let path = "";
  let [x, y] = [0, 0];
  for (const [i, point] of points.entries()) {
    const [nextX, nextY] = [Math.round(10 * point[0]), Math.round(10 * point[1])];
    path += (i === 0 ? "M" : i === 1 ? "l" : "") + tenths(nextX - x, i > 1) + tenths(nextY - y, true);
    [x, y] = [nextX, nextY];
  }
  return path;
}

/** A count of tenths as a number, as short as SVG allows; `after` another number it brings its own separator. */
function tenths(count: number, after: boolean): string {
  const digits = String(count / 10).replace(/^(-?)0\./, "$1.");
  return after && !digits.startsWith("-") ? ` ${digits}` : digits;
}

/** At most this many points a loop: more cannot be told apart at a panel's size. */
const OUTLINE_POINTS = 160;

function outline(loop: Float64Array, place: Place): string {
  const count = loop.length / 2;
  const stride = Math.ceil(count / OUTLINE_POINTS);
  const points = [];
  for (let i = 0; i < count; i += stride) points.push(place(loop[2 * i], loop[2 * i + 1]));
  return `${polyline(points)}Z`;
}

/** Pieces of every grid line shown. */
const PIECES = 32;

function grid(level: number, deformation: Float64Array, lines: number | undefined, place: Place): string {
  const cells = 2 ** level;
  const stride = Math.max(1, cells / PIECES);
  return gridLines(level, lines)
    .map(({ first, step }) => {
      const points = [];
      for (let k = 0; k <= cells; k += stride) {
        const node = 2 * (first + k * step);
        points.push(place(deformation[node], deformation[node + 1]));
      }
      return polyline(points);
    })
    .join("");
}

function ticks({ reference = [], matched = [] }: Panel, place: Place): string {
  let path = "";
  reference.forEach((loop, l) => {
    const stride = 2 * Math.max(1, Math.floor(loop.length / 2 / 40));
    for (let i = 0; i < loop.length; i += stride)
      path += polyline([place(loop[i], loop[i + 1]), place(matched[l][i], matched[l][i + 1])]);
  });
  return `<path class="tick" d="${path}"/>`;
}

export type Series = { readonly name: string; readonly points: readonly (readonly [number, number])[] };

export type Chart = {
  readonly title: string;
  readonly x: string;
  readonly y: string;
  readonly series: readonly Series[];
  readonly logX?: boolean;
  readonly logY?: boolean;
};

const CHART = { width: 380, height: 300, left: 58, right: 24, top: 30, bottom: 44 };
/** Points a curve; a tenth of a pixel is all that can be seen. */
const CURVE_POINTS = 160;

/** Charts side by side, their common legend below. */
export function charts(list: readonly Chart[]): string {
  const names = list[0].series.map((series) => series.name);
  const perRow = Math.max(1, Math.floor((CHART.width * list.length - CHART.left) / 160));
  const legend = names.map((name, i) => {
    const [x, y] = [CHART.left + (i % perRow) * 160, CHART.height + 12 + 20 * Math.floor(i / perRow)];
    return `<path class="series s${i % 6}" d="M${x} ${y - 4}h22"${dash(i)}/><text x="${x + 28}" y="${y}">${escaped(name)}</text>`;
  });
  return svg(
    CHART.width * list.length,
    CHART.height + 10 + 20 * Math.ceil(names.length / perRow),
    ...list.map((chart, i) => `<g transform="translate(${i * CHART.width} 0)">${oneChart(chart)}</g>`),
    ...legend,
  );
}

function dash(i: number): string {
  return i < 6 ? "" : ' stroke-dasharray="5 3"';
}

function oneChart(chart: Chart): string {
  const across = axis(
    chart.series.flatMap(({ points }) => points.map(([x]) => x)),
    chart.logX ?? false,
  );
  const up = axis(
    chart.series.flatMap(({ points }) => points.map(([, y]) => y)),
    chart.logY ?? false,
  );
  const { left, top, bottom, right, width, height } = CHART;
  const x = (value: number) => left + across.part(value) * (width - left - right);
  const y = (value: number) => height - bottom - up.part(value) * (height - top - bottom);
  const parts = [
    `<text x="${left}" y="18">${escaped(chart.title)}</text>`,
    `<rect class="frame" x="${left}" y="${top}" width="${width - left - right}" height="${height - top - bottom}"/>`,
    `<text x="${(left + width - right) / 2}" y="${height - 8}" text-anchor="middle">${escaped(chart.x)}</text>`,
    `<text transform="translate(13 ${(top + height - bottom) / 2}) rotate(-90)" text-anchor="middle">${escaped(chart.y)}</text>`,
    ...across.ticks.map((value) => {
      const at = tenth(x(value));
      return `<path class="frame" d="M${at} ${top}V${height - bottom}"/><text x="${at}" y="${height - bottom + 16}" text-anchor="middle">${label(value)}</text>`;
    }),
    ...up.ticks.map((value) => {
      const at = tenth(y(value));
      return `<path class="frame" d="M${left} ${at}H${width - right}"/><text x="${left - 6}" y="${tenth(at + 4)}" text-anchor="end">${label(value)}</text>`;
    }),
    ...chart.series.map(({ points }, i) => {
      const shown = points.filter(([a, b]) => (!chart.logX || a > 0) && (!chart.logY || b > 0));
      const path = thinned(shown).map(([a, b], k) => `${k === 0 ? "M" : "L"}${tenth(x(a))} ${tenth(y(b))}`);
      return `<path class="series s${i % 6}"${dash(i)} d="${path.join("")}"/>`;
    }),
  ];
  return parts.join("\n");
}

function thinned<T>(points: readonly T[]): readonly T[] {
  const stride = Math.ceil(points.length / CURVE_POINTS);
  // The first points move fastest, and the last one is the result.
  return points.filter((_, i) => i < 20 || i % stride === 0 || i === points.length - 1);
}

type Axis = { readonly ticks: readonly number[]; readonly part: (value: number) => number };

function axis(values: readonly number[], logarithmic: boolean): Axis {
  const used = logarithmic ? values.filter((value) => value > 0) : [0, ...values];
  const scale = logarithmic ? Math.log10 : (value: number) => value;
  let low = used.reduce((a, b) => Math.min(a, b), Infinity);
  let high = used.reduce((a, b) => Math.max(a, b), -Infinity);
  const ticks: number[] = [];
  if (logarithmic) {
    [low, high] = [10 ** Math.floor(Math.log10(low)), 10 ** Math.ceil(Math.log10(high))];
    const decades = Math.round(Math.log10(high / low));
    const stride = Math.max(1, Math.ceil(decades / 8));
    for (let k = 0; k <= decades; k += stride) ticks.push(low * 10 ** k);
  } else {
    const step = niceStep((high - low) / 5);
    high = Math.ceil(high / step) * step;
    for (let value = Math.ceil(low / step) * step; value <= high * (1 + 1e-9); value += step) ticks.push(value);
  }
  const [from, to] = [scale(low), scale(high)];
  return { ticks, part: (value) => (scale(value) - from) / (to - from || 1) };
}

function niceStep(least: number): number {
  const decade = 10 ** Math.floor(Math.log10(least || 1));
  return [1, 2, 5, 10].map((factor) => factor * decade).find((step) => step >= least) ?? 10 * decade;
}

function label(value: number): string {
  if (value !== 0 && (Math.abs(value) < 0.01 || Math.abs(value) >= 1e5)) return power(value) ?? withPower(value, 0);
  return plain(value, 3);
}

function tenth(value: number): number {
  return Math.round(10 * value) / 10;
}

/** As text of a drawing: true minus signs, and indices below the line. */
export function escaped(words: string): string {
  const safe = withMinus(words).replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;");
  const [first, ...more] = safe.split(INDEX);
  const shifted = more.map((part, i) =>
    i % 2 === 0 ? `<tspan dy="3" font-size="9">${part}</tspan>` : part && `<tspan dy="-3">${part}</tspan>`,
  );
  return [first, ...shifted].join("");
}
