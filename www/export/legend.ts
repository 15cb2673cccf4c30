/** The legend of a view, for pictures and drawings that leave the page: over their lower right corner. */

import type { Square } from "../view/framing";
import type { View } from "../view/names";
import type { Theme } from "../view/palette";
import { css, type Scale } from "../view/scales";
import { later } from "../words/later";

/** A legend's units: so many across the picture, whatever it shows, and so many between the legend and its edge. */
export const ACROSS = 1100;
export const EDGE = 50;

const WIDTH = 330;
const BAR = 16;
const LINE = 26;
const TEXT = 20;
const PAD = 16;

/** A line's colours from left to right, and what it stands for. */
type Entry = { readonly colours: readonly string[]; readonly width: number; readonly text: string };

export type Legend = { readonly scale: Scale | null; readonly entries: readonly Entry[] };

export function legendOf(view: View, scale: Scale | null, colours: Theme, isMissed = false): Legend {
  const { template, reference, matched, missed } = later.legend;
  const target: Entry[] = [{ colours: [colours.template], width: 6, text: template }];
  if (isMissed) target.push({ colours: [colours.warning], width: 4, text: missed });
  if (view !== "grid") return { scale, entries: target };
  return {
    scale: null,
    entries: [
      { colours: colours.cycle, width: 3, text: reference },
      { colours: colours.cycle, width: 7, text: matched },
      ...target,
    ],
  };
}

type Box = { readonly left: number; readonly top: number; readonly height: number };

function boxOf({ scale, entries }: Legend): Box {
  const height = 2 * PAD + (scale ? BAR + 2 * LINE : 0) + LINE * entries.length;
  return { left: 1000 - WIDTH, top: 1000 - height, height };
}

function titled({ title, unit }: Scale): string {
  return unit ? `${title} (${unit})` : title;
}

/** `unit` device pixels a unit, from the origin `(x, y)`. */
export function drawLegend(
  context: CanvasRenderingContext2D,
  legend: Legend,
  colours: Theme,
  unit: number,
  x: number,
  y: number,
): void {
  const { left, top, height } = boxOf(legend);
  context.save();
  context.translate(x, y);
  context.scale(unit, unit);
  context.globalAlpha = 0.9;
  context.fillStyle = colours.paper;
  context.fillRect(left, top, WIDTH, height);
  context.globalAlpha = 1;
  context.strokeStyle = colours.frame;
  context.lineWidth = 1.5;
  context.strokeRect(left, top, WIDTH, height);
  context.font = `${TEXT}px system-ui, sans-serif`;
  context.textBaseline = "middle";
  const bar = (stops: readonly string[], from: number, across: number, at: number, thick: number) => {
    const gradient = context.createLinearGradient(from, 0, from + across, 0);
    stops.forEach((colour, i) => {
      gradient.addColorStop(stops.length > 1 ? i / (stops.length - 1) : 0, colour);
    });
    context.fillStyle = gradient;
    context.fillRect(from, at, across, thick);
  };
  let line = top + PAD;
  if (legend.scale) {
    const across = WIDTH - 4 * PAD;
    bar(legend.scale.colours.map(css), left + 2 * PAD, across, line, BAR);
    context.fillStyle = colours.ink;
    context.textAlign = "center";
    for (const { part, text } of legend.scale.ticks)
      context.fillText(text, left + 2 * PAD + part * across, line + BAR + LINE / 2);
    context.fillText(titled(legend.scale), left + WIDTH / 2, line + BAR + 1.5 * LINE, WIDTH - 2 * PAD);
    line += BAR + 2 * LINE;
  }
  context.textAlign = "left";
  for (const { colours: stops, width, text } of legend.entries) {
    bar(stops, left + PAD, 50, line + LINE / 2 - width / 2, width);
    context.fillStyle = colours.ink;
    context.fillText(text, left + PAD + 62, line + LINE / 2, WIDTH - 2 * PAD - 62);
    line += LINE;
  }
  context.restore();
}

/** The same for a drawing that shows the square, its units a thousandth of the box's side. */
export function legendSvg(legend: Legend, colours: Theme, { left: x, bottom, size }: Square): string {
  const { left, top, height } = boxOf(legend);
  const gradients: string[] = [];
  const parts: string[] = [
    `<rect x="${left}" y="${top}" width="${WIDTH}" height="${height}" fill="${colours.paper}" fill-opacity="0.9" stroke="${colours.frame}" stroke-width="1.5"/>`,
  ];
  const bar = (stops: readonly string[], x: number, across: number, y: number, thick: number) => {
    let paint = stops[0];
    if (stops.length > 1) {
      const id = `legend-${gradients.length}`;
      const few = Array.from({ length: 25 }, (_, i) => stops[Math.round((i / 24) * (stops.length - 1))]);
      gradients.push(
        `<linearGradient id="${id}">${few.map((colour, i) => `<stop offset="${(i / 24).toFixed(3)}" stop-color="${colour}"/>`).join("")}</linearGradient>`,
      );
      paint = `url(#${id})`;
    }
    parts.push(`<rect x="${x}" y="${y}" width="${across}" height="${thick}" fill="${paint}"/>`);
  };
  const text = (x: number, y: number, words: string, anchor: string) =>
    parts.push(`<text x="${x}" y="${y}" text-anchor="${anchor}" dominant-baseline="central">${escaped(words)}</text>`);
  let line = top + PAD;
  if (legend.scale) {
    const across = WIDTH - 4 * PAD;
    bar(legend.scale.colours.map(css), left + 2 * PAD, across, line, BAR);
    for (const tick of legend.scale.ticks)
      text(left + 2 * PAD + tick.part * across, line + BAR + LINE / 2, tick.text, "middle");
    text(left + WIDTH / 2, line + BAR + 1.5 * LINE, titled(legend.scale), "middle");
    line += BAR + 2 * LINE;
  }
  for (const { colours: stops, width, text: words } of legend.entries) {
    bar(stops, left + PAD, 50, line + LINE / 2 - width / 2, width);
    text(left + PAD + 62, line + LINE / 2, words, "start");
    line += LINE;
  }
  const scale = (1000 * size) / ACROSS;
  const [right, down] = [1000 * x + EDGE * scale, 1000 * (1 - bottom - size) + EDGE * scale];
  const place = `translate(${right.toFixed(3)} ${down.toFixed(3)}) scale(${scale.toFixed(5)})`;
  return `<g id="legend" transform="${place}" font-family="system-ui, sans-serif" font-size="${TEXT}" fill="${colours.ink}"><defs>${gradients.join("")}</defs>${parts.join("")}</g>`;
}

function escaped(text: string): string {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");
}
