/** The views other than the grid as drawings: lines as paths, what is made of pixels as a picture beneath them. */

import type { Shape } from "../shapes/geometry";
import type { Square } from "../view/framing";
import { movedLoops } from "../view/morph";
import type { View } from "../view/names";
import type { Theme } from "../view/palette";
import { css, place as placed } from "../view/scales";
import { alongOf, isAlong, pixelsOf, scaleOf, type ViewScene } from "../view/views";
import { en } from "../words/en";
import { closedPath, head, missedPath, place, round, thickness, UNITS } from "./svg";

/** Pixels a side of what is made of pixels. */
const PIXELS = 1100;

export async function svgOf(
  view: View,
  scene: ViewScene & { readonly missed: Shape },
  square: Square,
  colours: Theme,
  legend: string,
): Promise<string> {
  const { reference, template, matched } = scene.match.curves;
  const moved = movedLoops(scene.match, scene.morph);
  const thick = thickness(square);
  const { left, bottom, size } = square;
  const [x, y, side] = [UNITS * left, UNITS * (1 - bottom - size), UNITS * size].map(round);
  const line = (loops: Shape, colour: string, width: number, more = "") =>
    `<path d="${closedPath(loops)}" fill="none" stroke="${colour}" stroke-width="${round(width * thick)}" stroke-linejoin="round"${more}/>`;
  const drawn = isAlong(view)
    ? along(view, scene, colours, moved, line, thick)
    : [
        `<image x="${x}" y="${y}" width="${side}" height="${side}" href="${await address(view, scene, square, colours)}"/>`,
        view === "pullback" ? line(reference, colours.reference, 8) : line(template, colours.template, 8),
        ...(view === "pullback" ? [] : [line(moved, colours.paper, 7), line(moved, colours.ink, 3)]),
      ];
  return [
    ...head(en.views[view], square, colours),
    ...drawn,
    view === "pullback" ? "" : missedPath(scene.missed, colours, thick),
    // By these the import finds the shapes again, as in the drawing of the grid.
    ...Object.entries({ reference, template, matched }).map(
      ([name, loops]) => `<path data-side="${name}" d="${closedPath(loops)}" fill="none" stroke="none"/>`,
    ),
    legend,
    "</svg>",
    "",
  ]
    .filter((text, i, all) => text !== "" || i === all.length - 1)
    .join("\n");
}

type Line = (loops: Shape, colour: string, width: number, more?: string) => string;

function along(
  view: Parameters<typeof alongOf>[0],
  scene: ViewScene,
  colours: Theme,
  moved: Shape,
  line: Line,
  thick: number,
): string[] {
  const { reference, template } = scene.match.curves;
  const scale = scaleOf(view, scene.limit, colours.dark);
  const { own, moving } = alongOf(view, scene, scale);
  const table = scale?.colours.map(css) ?? [];
  return [
    line(template, colours.template, 10, ' stroke-opacity="0.35"'),
    ...(own
      ? [line(reference, colours.ink, 8), pieces(reference, own, table, 6 * thick)]
      : [line(reference, colours.muted, 2, ' stroke-opacity="0.8"')]),
    line(moved, colours.ink, 14),
    pieces(moved, moving, table, 12 * thick),
  ];
}

/** One path for each stretch of equal colour. */
function pieces(loops: Shape, places: Shape, table: readonly string[], width: number): string {
  const out: string[] = [];
  loops.forEach((loop, l) => {
    const count = loop.length / 2;
    let [colour, path] = ["", ""];
    for (let i = 0; i <= count; i += 1) {
      const k = i % count;
      const next = i === count ? "" : table[placed(places[l][k], table.length)];
      const point = place(loop[2 * k], loop[2 * k + 1]);
      if (path) path += `L${point}`;
      if (next === colour) continue;
      if (path) out.push(`<path stroke="${colour}" d="${path}"/>`);
      [colour, path] = [next, `M${point}`];
    }
  });
  return `<g class="along" fill="none" stroke-width="${round(width)}" stroke-linejoin="round" stroke-linecap="round">${out.join("")}</g>`;
}

async function address(view: View, scene: ViewScene, { left, bottom, size }: Square, { dark }: Theme): Promise<string> {
  const frame = { left, bottom, scale: PIXELS / size, width: PIXELS, height: PIXELS, ratio: 2 };
  const blob = await pixelsOf(view, frame, dark, scene).convertToBlob({ type: "image/png" });
  let text = "";
  for (const byte of new Uint8Array(await blob.arrayBuffer())) text += String.fromCharCode(byte);
  return `data:image/png;base64,${btoa(text)}`;
}
