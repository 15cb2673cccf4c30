/** Fig. 6, top: which rotation of an octahedron is found, and what finds it. */

import { picture } from "../../space/picture";
import { type Context, cells, type Settings, type SolidExperiment, seconds, small, table, text } from "../experiment";
import { PAPER } from "../paper";
import { panels } from "../svg";
import { turnFound } from "./measure";
import { turnedOctahedron } from "./shapes";
import { nodes, type SolidEnd, solveSolid } from "./solve";

/** Turned by exactly 45° about one of its corners an octahedron is symmetric about the start: half a degree decides. */
export const ANGLES = [15, 24, 30, 44.5] as const;
const SHOWN = 30;

export type Turned = { readonly found: number; readonly end: SolidEnd };

export async function turn(
  context: Context,
  angle: number,
  finest: number,
  settings: Partial<Settings>,
): Promise<Turned> {
  const reference = turnedOctahedron(0);
  const { end } = await solveSolid(context, {
    reference,
    template: turnedOctahedron(angle),
    settings: { ...PAPER, coarsest: 4, finest, ...settings },
  });
  return { found: turnFound(reference.positions, end.matched), end };
}

export const MODELS: readonly { readonly name: string; readonly settings: Partial<Settings> }[] = [
  { name: "no bending, α_bend = 0", settings: { bending: 0 } },
  { name: "relative shape operator (3), α_bend = 1", settings: { bending: 1 } },
  { name: "mean curvature (10), weight 1", settings: { bendingModel: "mean-curvature", bending: 1 } },
  { name: "mean curvature (10), weight 0.01", settings: { bendingModel: "mean-curvature", bending: 0.01 } },
];

export const turnExperiment: SolidExperiment = {
  id: "octahedron",
  title: "Surfaces, Fig. 6 (top): a turned octahedron",
  paper:
    "A rounded octahedron is matched with itself turned. With the relative shape operator (3) edges find edges and corners find corners; without bending, and with the mean curvature of eq. (10), they do not.",
  setup: `The l¹ ball of a smoothed absolute value, turned about the axis through two of its corners by ${ANGLES.slice(0, -1).join("°, ")}° and ${ANGLES.at(-1)}°, from the identity, with the paper's settings. At 45° the start is symmetric, so half a degree is taken off. Measured: the rotation about that axis that takes the vertices of M1 to their partners best in the least squares sense.`,
  example: { reference: "octahedron", template: "octahedron-turned", settings: { ...PAPER } },
  hasShortForm: true,
  async run(context, size) {
    const finest = 5;
    const angles = size === "full" ? ANGLES : ([SHOWN] as const);
    const rows: string[][] = [];
    const shown: { name: string; turned: Turned }[] = [];
    const found = new Map<string, readonly Turned[]>();
    for (const [row, { name, settings }] of MODELS.entries()) {
      const all: Turned[] = [];
      for (const [column, angle] of angles.entries()) {
        await context.progress((row * angles.length + column) / (MODELS.length * angles.length), `${name}, ${angle}°`);
        const turned = await turn(context, angle, finest, settings);
        all.push(turned);
        if (angle === SHOWN) shown.push({ name, turned });
      }
      found.set(name, all);
      rows.push([
        name,
        nodes(finest),
        ...all.map(
          ({ found, end: { status, millis } }) =>
            `${found.toFixed(2)}° (${cells(status.mismatch.max)} cells, det ${small(status.leastDeterminant)}, ${seconds(millis)})`,
        ),
      ]);
    }
    const { positions, indices } = turnedOctahedron(0);
    const target = turnedOctahedron(SHOWN);
    const pose = { azimuth: 0.35, elevation: 0.55, zoom: 1.25, right: 0, up: 0 };
    return [
      table(["model", "nodes", ...angles.map((angle) => `${angle}°: found (max mismatch, least det, time)`)], rows),
      {
        kind: "figure",
        name: "surface-octahedron",
        caption: `Turned by ${SHOWN}°: equal colours and lines are matched points; the first picture is the reference turned, where every point should end.`,
        svg: panels(
          [
            {
              title: `Turned by ${SHOWN}°`,
              picture: await picture({ positions: target.positions, indices, places: positions }, 200, pose),
            },
            ...(await Promise.all(
              shown.map(async ({ name, turned }) => ({
                title: name.replace(/, α_bend = \d$/, "").replace(", weight", ","),
                note: `found ${turned.found.toFixed(2)}°`,
                picture: await picture({ positions: turned.end.matched, indices, places: positions }, 200, pose),
              })),
            )),
          ],
          3,
          200,
        ),
      },
      text(words(angles, found)),
    ];
  },
};

/** What the numbers say, from the numbers. */
export function words(angles: readonly number[], found: ReadonlyMap<string, readonly Turned[]>): string {
  const off = (name: string) => (found.get(name) ?? []).map(({ found }, k) => Math.abs(found - angles[k]));
  const [none, operator, mean, weak] = MODELS.map(({ name }) => off(name));
  const within = (all: readonly number[], degrees: number) =>
    angles.filter((_, k) => all[k] <= degrees).map((angle) => `${angle}°`);
  const list = (names: readonly string[]) => (names.length === 0 ? "none of the angles" : names.join(", "));
  return [
    `Within half a degree are, with (3): ${list(within(operator, 0.5))}; with (10) of weight 1: ${list(within(mean, 0.5))}; of weight 0.01: ${list(within(weak, 0.5))}; without bending: ${list(within(none, 0.5))}.`,
    `Without bending the surface slides onto the turned one the shortest way and is ${Math.min(...none).toFixed(1)}° or more off.`,
    "A rotation costs no energy, but nothing drives towards it unless curvature is compared.",
  ].join(" ");
}
