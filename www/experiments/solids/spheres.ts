/** Table 1 on spheres: how the deviation of the area ratio falls with the spacing. */

import { type Context, cells, type Settings, type SolidExperiment, seconds, small, table, text } from "../experiment";
import { order } from "../measure";
import { PAPER } from "../paper";
import { charts } from "../svg";
import { layerRatio } from "./measure";
import { sphere } from "./shapes";
import { nodes, solveSolid } from "./solve";

export const RADIUS = 0.16;
/** Of the areas: the ratio of the perimeters of the paper's shapes. */
export const RATIO = 2.38;
const TARGET = RADIUS * Math.sqrt(RATIO);

export const SHELL: Partial<Settings> = { ...PAPER, bending: 0, bandwidth: 0.05 };
const VOLUME: Partial<Settings> = {
  ...PAPER,
  membrane: 0,
  bending: 0,
  volume: 1,
  interior: 1e-3,
  penalty: 1e5,
  halving: false,
  bandwidth: 0.05,
};

const FIRST = 4;

export type SphereRow = {
  readonly level: number;
  readonly mean: number;
  readonly deviation: number;
  /** On M1 itself. */
  readonly surface: number;
  readonly mismatch: number;
  readonly leastDeterminant: number;
  readonly millis: number;
};

/** A cascade of its own for every level. */
export async function sphereRatios(
  context: Context,
  settings: Partial<Settings>,
  finest: number,
  progress: (level: number) => void | Promise<void> = () => {},
): Promise<SphereRow[]> {
  const rows: SphereRow[] = [];
  for (let level = FIRST; level <= finest; level += 1) {
    await progress(level);
    const { end } = await solveSolid(context, {
      reference: sphere(RADIUS),
      template: sphere(TARGET),
      settings: { coarsest: 4, finest: level, ...settings },
    });
    rows.push({
      level,
      ...layerRatio(level, end.deformation, RADIUS),
      surface: end.status.stretch.deviation,
      mismatch: end.status.mismatch.max,
      leastDeterminant: end.status.leastDeterminant,
      millis: end.millis,
    });
  }
  return rows;
}

/** The deviation of a map that takes every concentric sphere evenly onto one at the same distance from the template. */
export function law(level: number): number {
  return ((2 * (RATIO - Math.sqrt(RATIO))) / Math.sqrt(3) / 2 ** level) * (1 / RADIUS);
}

export const spheresExperiment: SolidExperiment = {
  id: "spheres",
  title: "Surfaces, Table 1: the area ratio evens out under refinement",
  paper:
    "A circle is matched with an ellipse 2.38 times as long: with the thin shell the deviation of the tangential strain halves with every refinement, with volume energy alone it does not fall.",
  setup: `Sphere of radius ${RADIUS} to one of ${RATIO} times its area, both in the middle of the box. Shell: α_bend = 0, σ = 0.05, otherwise the paper's settings; volume only: ξ = 1, ζ = 10⁻³, 1/ε = 10⁵ on all levels, α_mem = α_bend = 0. Every row is the end of a cascade of its own from 17³ on. Measured: the standard deviation, by volume, of the area ratio |cof Dφ n| over all Gauss points with |d₁| < h; and that of the matched surface itself.`,
  example: { reference: "sphere", template: "ellipsoid", settings: { ...PAPER, bending: 0 } },
  hasShortForm: true,
  async run(context, size) {
    const finest = size === "full" ? 6 : 5;
    const count = finest - FIRST + 1;
    const shell = await sphereRatios(context, SHELL, finest, (level) =>
      context.progress((level - FIRST) / count / 2, `thin shell, ${nodes(level)}`),
    );
    const volume = await sphereRatios(context, VOLUME, finest, (level) =>
      context.progress(0.5 + (level - FIRST) / count / 2, `volume only, ${nodes(level)}`),
    );
    const curve = (name: string, values: readonly number[]) => ({
      name,
      points: values.map((value, i) => [2 ** (FIRST + i), value] as const),
    });
    const [last, lastVolume] = [shell[shell.length - 1], volume[volume.length - 1]];
    return [
      table(
        [
          "nodes",
          "shell: deviation",
          "order",
          "law",
          "on the surface",
          "max mismatch, cells",
          "time",
          "volume only: deviation",
          "on the surface",
          "max mismatch, cells",
          "least det Dφ",
        ],
        shell.map((row, i) => [
          nodes(row.level),
          row.deviation.toFixed(4),
          i === 0 ? "" : order(shell[i - 1].deviation, row.deviation).toFixed(2),
          law(row.level).toFixed(4),
          row.surface.toFixed(4),
          cells(row.mismatch),
          seconds(row.millis),
          volume[i].deviation.toFixed(4),
          volume[i].surface.toFixed(4),
          cells(volume[i].mismatch),
          small(volume[i].leastDeterminant),
        ]),
      ),
      {
        kind: "figure",
        name: "surface-spheres",
        caption: "Standard deviation of the area ratio over cells a side.",
        svg: charts([
          {
            title: "Table 1 on spheres",
            x: "cells a side",
            y: "standard deviation of the area ratio",
            logX: true,
            logY: true,
            series: [
              curve(
                "thin shell",
                shell.map(({ deviation }) => deviation),
              ),
              curve(
                "law",
                shell.map(({ level }) => law(level)),
              ),
              curve(
                "volume only",
                volume.map(({ deviation }) => deviation),
              ),
            ],
          },
        ]),
      },
      text(
        `The law. If every concentric sphere is stretched evenly and keeps its distance, the area ratio at distance s is ((R + s)/(r + s))², over |s| < h with the deviation 2(q² − q)/√3 · h/r, q² = ${RATIO}. As with curves, what falls like h is mostly the thickness of the layer over which the ratio is taken: on ${nodes(last.level)} the measured value is ${(last.deviation / law(last.level)).toFixed(2)} times the law, and on the surface itself the deviation is ${last.surface.toFixed(4)}. Volume energy alone ends there at ${lastVolume.deviation.toFixed(4)}, ${(lastVolume.deviation / last.deviation).toFixed(1)} times as much, and ${lastVolume.surface.toFixed(4)} on the surface.`,
      ),
    ];
  },
};
