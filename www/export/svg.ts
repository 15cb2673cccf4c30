/**
 * The result view as a drawing: every line a path. The box's side has 1000 units and y points down, as SVG has it.
 * Reference, template and matched curve carry `data-side`, by which the import finds them again, to 10⁻⁶ of the box.
 */

import { pinMarks } from "../pins/draw";
import type { Loop, Shape } from "../shapes/geometry";
import { arcLengthParts, ticksOf } from "../view/curve";
import type { Square } from "../view/framing";
import { type GridLine, gridLines } from "../view/grid";
import { movedGrid, movedLoops } from "../view/morph";
import { onCycle, type Theme } from "../view/palette";
import type { ResultScene } from "../view/result";
import { files } from "../words/files";

export const UNITS = 1000;

/** The drawing's own width; a line is as wide for it as for a picture of this many units. */
const WIDTH = 1100;

/** How wide a unit of the paper is in the drawing's. */
export function thickness({ size }: Square): number {
  return (UNITS * size) / WIDTH;
}

/** The beginning of a drawing that shows the square, as large whatever that is. */
export function head(title: string, { left, bottom, size }: Square, { paper }: Theme): readonly string[] {
  const [x, y, side] = [UNITS * left, UNITS * (1 - bottom - size), UNITS * size].map(round);
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="${x} ${y} ${side} ${side}" width="${WIDTH}" height="${WIDTH}" data-units-per-side="${UNITS}">`,
    `<title>${title}</title>`,
    `<rect x="${x}" y="${y}" width="${side}" height="${side}" fill="${paper}"/>`,
  ];
}

export function svg(scene: ResultScene, square: Square, colours: Theme, legend = ""): string {
  const { match, morph } = scene;
  const reference = match ? match.curves.reference : scene.reference;
  const moved = match ? movedLoops(match, morph) : reference;
  const parts = arcLengthParts(reference);
  const thick = thickness(square);
  const inked = (paint: string, width: number, more = "") =>
    `fill="none" stroke="${paint}" stroke-width="${round(width)}" stroke-linejoin="round"${more}`;
  const band = 2 * scene.bandwidth * UNITS;
  return [
    ...head(match ? files.matchTitle : files.shapesTitle, square, colours),
    `<path data-side="template" d="${closedPath(scene.template)}" fill="${colours.template}" fill-opacity="0.14" stroke="${colours.template}" stroke-opacity="0.4" stroke-width="${round((match ? 12 : 4) * thick)}" stroke-linejoin="round"/>`,
    `<path id="grid" d="${gridPath(scene)}" ${inked(colours.grid, 1.8 * thick)}/>`,
    `<path data-side="reference" d="${closedPath(scene.reference)}" ${inked(colours.reference, band, ' stroke-opacity="0.09"')}/>`,
    missedPath(scene.missed ?? [], colours, thick),
    match ? `<g id="partners" stroke-opacity="0.75">${ticks(reference, moved, parts, colours, 2 * thick)}</g>` : "",
    `<g id="arc-length" stroke-linecap="round" stroke-linejoin="round">`,
    ...reference.map((loop, l) => coloured(loop, parts[l], colours, (match ? 3 : 5) * thick)),
    ...(match ? moved.map((loop, l) => coloured(loop, parts[l], colours, 6 * thick)) : []),
    "</g>",
    pinsOf(scene, colours, thick),
    match ? `<path data-side="matched" d="${closedPath(moved)}" ${inked(colours.ink, 0.2 * thick)}/>` : "",
    legend,
    "</svg>",
    "",
  ]
    .filter((line, i, lines) => line !== "" || i === lines.length - 1)
    .join("\n");
}

export function round(value: number): number {
  return Math.round(1000 * value) / 1000;
}

export function place(x: number, y: number): string {
  return `${round(UNITS * x)} ${round(UNITS * (1 - y))}`;
}

export function closedPath(shape: Shape): string {
  return shape
    .map(
      (loop) => `M${Array.from({ length: loop.length / 2 }, (_, i) => place(loop[2 * i], loop[2 * i + 1])).join("L")}Z`,
    )
    .join("");
}

/** Dashed, as on the screen; nothing where nothing is missed. */
export function missedPath(missed: Shape, colours: Theme, thick: number): string {
  if (missed.length === 0) return "";
  const path = missed.map(openPath).join("");
  return `<path id="missed" d="${path}" fill="none" stroke="${colours.warning}" stroke-width="${round(5 * thick)}" stroke-linejoin="round" stroke-dasharray="${round(12 * thick)} ${round(8 * thick)}"/>`;
}

function openPath(line: Loop): string {
  return `M${Array.from({ length: line.length / 2 }, (_, i) => place(line[2 * i], line[2 * i + 1])).join("L")}`;
}

function gridPath({ match, morph }: ResultScene): string {
  const level = match ? match.level : 5;
  const cells = 2 ** level;
  const deformation = match && movedGrid(match, morph).deformation;
  const at = (node: number) =>
    deformation
      ? place(deformation[2 * node], deformation[2 * node + 1])
      : place((node % (cells + 1)) / cells, Math.floor(node / (cells + 1)) / cells);
  const path = ({ first, step }: GridLine) => Array.from({ length: cells + 1 }, (_, k) => at(first + k * step));
  return gridLines(level)
    .map((line) => `M${path(line).join("L")}`)
    .join("");
}

/** Circles and lines, no paths: the import takes those for shapes. */
function pinsOf({ pins, match, reference, morph }: ResultScene, colours: Theme, thick: number): string {
  if (pins.length === 0) return "";
  const marks = pinMarks(pins, match, reference, morph, colours.cycle).map(({ at, aim, colour }, i) => {
    const [x, y] = place(at.x, at.y).split(" ");
    const [u, v] = place(aim.x, aim.y).split(" ");
    return [
      `<line x1="${x}" y1="${y}" x2="${u}" y2="${v}" stroke="${colour}" stroke-width="${round(4 * thick)}"/>`,
      `<circle cx="${x}" cy="${y}" r="${round(16 * thick)}" fill="${colours.paper}" stroke="${colour}" stroke-width="${round(5 * thick)}"/>`,
      `<text x="${x}" y="${y}" dy="0.35em" fill="${colours.ink}">${i + 1}</text>`,
    ].join("");
  });
  return `<g id="pins" font-family="sans-serif" font-size="${round(20 * thick)}" font-weight="600" text-anchor="middle">${marks.join("")}</g>`;
}

/** One path for each stretch of equal colour. */
function coloured(loop: Loop, parts: Float64Array, colours: Theme, width: number): string {
  const count = parts.length;
  let out = "";
  let colour = "";
  for (let i = 0; i < count; i += 1) {
    const next = onCycle(colours.cycle, parts[i]);
    if (next !== colour) {
      if (colour) out += '"/>';
      colour = next;
      out += `<path fill="none" stroke="${colour}" stroke-width="${round(width)}" d="M${place(loop[2 * i], loop[2 * i + 1])}`;
    }
    const j = (i + 1) % count;
    out += `L${place(loop[2 * j], loop[2 * j + 1])}`;
  }
  return colour ? `${out}"/>` : out;
}

/** Lines from points of the reference, evenly spaced by arc length, to where they go. */
function ticks(from: Shape, to: Shape, parts: readonly Float64Array[], colours: Theme, width: number): string {
  let out = "";
  from.forEach((loop, l) => {
    for (const i of ticksOf(parts[l])) {
      const end = place(to[l][2 * i], to[l][2 * i + 1]);
      out += `<path stroke="${onCycle(colours.cycle, parts[l][i])}" stroke-width="${round(width)}" d="M${place(loop[2 * i], loop[2 * i + 1])}L${end}"/>`;
    }
  });
  return out;
}
