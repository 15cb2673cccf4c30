/** Fig. 6 in 2D: which rotation is found, and what finds it. */

import { type Context, cells, type Experiment, nodes, type Settings, seconds, table, text } from "./experiment";
import { rotationAngle } from "./measure";
import { PAPER } from "./paper";
import { roundedSquare } from "./shapes";
import { type LevelEnd, solve } from "./solve";
import { panels } from "./svg";

/** Turned by exactly 45° the square is symmetric about the start, which is then a saddle: half a degree decides. */
export const ANGLES = [15, 30, 40, 44.5] as const;

/** The gradient method takes a minute on 129² where Newton takes a second; on 33² neither finds 40°. */
const FINEST = { full: { newton: 7, ncg: 6 }, short: { newton: 6, ncg: 6 } } as const;

export type Found = { readonly angle: number; readonly found: number; readonly end: LevelEnd };

/** A rounded square of half side 0.12 and corner radius 0.08, matched with itself turned by `angle` degrees. */
export async function rotate(
  context: Context,
  angle: number,
  finest: number,
  settings: Partial<Settings>,
): Promise<Found> {
  const { end } = await solve(context, {
    reference: roundedSquare(0.12, 0.08, 0),
    template: roundedSquare(0.12, 0.08, angle),
    settings: { ...PAPER, coarsest: 4, finest, ...settings },
  });
  return { angle, found: rotationAngle(end.curves), end };
}

const SHAPE_OPERATOR: Partial<Settings> = { bending: 1 };

const MODELS: readonly { readonly name: string; readonly settings: Partial<Settings> }[] = [
  { name: "no bending, α_bend = 0", settings: { bending: 0 } },
  { name: "relative shape operator (3), α_bend = 1", settings: SHAPE_OPERATOR },
  { name: "mean curvature (10), weight 1", settings: { bendingModel: "mean-curvature", bending: 1 } },
  { name: "mean curvature (10), weight 0.01", settings: { bendingModel: "mean-curvature", bending: 0.01 } },
];

/** Energies of the rotated start and of a match, on one level with the δ and ε that a cascade from 17² has there. */
export async function energyOf(
  context: Context,
  angle: number,
  level: number,
  settings: Partial<Settings>,
  deformation: Float64Array,
): Promise<{ match: number; rotation: number }> {
  const registration = await context.solver.create(roundedSquare(0.12, 0.08, 0), roundedSquare(0.12, 0.08, angle), {
    ...PAPER,
    thickness: 0.5 / 2 ** (level - 4),
    penalty: 1e3 * 2 ** (level - 4),
    ...settings,
    coarsest: level,
    finest: level,
  });
  try {
    const [cos, sin] = [Math.cos((angle * Math.PI) / 180), Math.sin((angle * Math.PI) / 180)];
    const turned = registration.deformation();
    for (let i = 0; i < turned.length; i += 2) {
      const [x, y] = [turned[i] - 0.5, turned[i + 1] - 0.5];
      turned[i] = 0.5 + cos * x - sin * y;
      turned[i + 1] = 0.5 + sin * x + cos * y;
    }
    return {
      match: registration.evaluate(deformation).energies.total,
      rotation: registration.evaluate(turned).energies.total,
    };
  } finally {
    registration.free();
  }
}

export type Saddle = {
  /** Degrees. */
  readonly found: number;
  readonly energies: { readonly match: number; readonly rotation: number };
};

/** Of Newton's method and the gradient method, on the finest levels of each. */
export function saddleWords(
  [newton, gradient]: readonly Saddle[],
  finest: { readonly newton: number; readonly ncg: number },
): string {
  const energy = (value: number) => value.toPrecision(6);
  const { newton: fine, ncg: coarse } = finest;
  const rotation =
    fine === coarse
      ? `${energy(newton.energies.rotation)} there`
      : `${energy(newton.energies.rotation)} on ${nodes(fine)} and ${energy(gradient.energies.rotation)} on ${nodes(coarse)}`;
  const ends = [newton, gradient].filter(({ energies }) => energies.match > energies.rotation * (1 + 1e-3));
  const meaning =
    ends.length === 0
      ? "neither end lies above it: the corners have been found."
      : `${ends.length === 2 ? "both ends lie" : ends[0] === newton ? "Newton's end lies" : "the gradient method's end lies"} above it: there the corners have been caught half way, and the similarity start is what helps.`;
  return `At 44.5° the start is all but symmetric, and how a search leaves a saddle is decided by little: with bending Newton's method ends at ${newton.found.toFixed(2)}° with the energy ${energy(newton.energies.match)} on ${nodes(fine)}, the gradient method at ${gradient.found.toFixed(2)}° with ${energy(gradient.energies.match)} on ${nodes(coarse)}. The rotation has ${rotation}; ${meaning}`;
}

export const rotationExperiment: Experiment = {
  id: "rotation",
  title: "Fig. 6 in 2D: a turned square",
  paper:
    "Shapes that differ by a rotation: with the bending energy (3) corners find corners. Without it, or with the mean curvature of eq. (10) in its place, they do not.",
  setup:
    "Rounded square, half side 0.12, corner radius 0.08, matched with itself turned by 15°, 30°, 40° and 44.5°, from the identity, with the paper's settings otherwise. At 45° the start is symmetric and nothing tells left from right, so half a degree is taken off. Measured: the rotation that takes the points of M1 to their partners best in the least squares sense; both minimisers.",
  example: () => ({
    reference: roundedSquare(0.12, 0.08, 0),
    template: roundedSquare(0.12, 0.08, 30),
    settings: { ...PAPER, finest: 7 },
  }),
  hasShortForm: true,
  async run(context, size) {
    const rows: string[][] = [];
    const shown: { name: string; found: number; end: LevelEnd; energies: { match: number; rotation: number } }[] = [];
    const saddle: Saddle[] = [];
    const total = 2 * MODELS.length * ANGLES.length;
    let done = 0;
    for (const minimizer of ["newton", "ncg"] as const) {
      const finest = FINEST[size][minimizer];
      for (const { name, settings } of MODELS) {
        const row = [name, minimizer, nodes(finest)];
        for (const angle of ANGLES) {
          await context.progress(done / total, `${name}, ${minimizer}, ${angle}°`);
          const { found, end } = await rotate(context, angle, finest, { ...settings, minimizer });
          row.push(`${found.toFixed(2)}° (${cells(end.status.mismatch.max)} cells, ${seconds(end.millis)})`);
          done += 1;
          const energies = () => energyOf(context, angle, finest, settings, end.deformation);
          if (angle === 30 && minimizer === "newton") shown.push({ name, found, end, energies: await energies() });
          if (angle === 44.5 && settings === SHAPE_OPERATOR) saddle.push({ found, energies: await energies() });
        }
        rows.push(row);
      }
    }
    return [
      table(["model", "minimiser", "nodes", ...ANGLES.map((angle) => `${angle}°: found (max mismatch, time)`)], rows),
      {
        kind: "figure",
        name: "rotation",
        caption: "Turned by 30°, Newton: ticks join equally spaced points of the reference with their partners.",
        svg: panels(
          shown.map(({ name, found, end }) => ({
            title: name,
            note: `found ${found.toFixed(2)}°`,
            level: end.status.level,
            lines: 16,
            deformation: end.deformation,
            reference: end.curves.reference,
            template: end.curves.template,
            matched: end.curves.matched,
            ticks: true,
          })),
          2,
          290,
        ),
      },
      text(
        `Without bending both minimisers leave the curve within a degree of where it started: it slides onto the target the shortest way. The rotation would do better, but hardly: on the finest level the match found has the energy ${shown[0].energies.match.toPrecision(6)}, the exact rotation by 30° ${shown[0].energies.rotation.toPrecision(6)}. A rotation costs membrane and volume nothing either, so a thorough minimiser may drift towards it; nothing drives it there within any sensible tolerance. With bending the same two numbers are ${shown[1].energies.match.toPrecision(6)} for the match found and ${shown[1].energies.rotation.toPrecision(6)} for the rotation. What bending adds is the force, not the minimum.`,
      ),
      text(saddleWords(saddle, FINEST[size])),
      text(
        "Eq. (10) carries no factor δ³, so with weight 1 it outweighs the other terms: rotations up to 40° are met less exactly and with ten times the mismatch or more, and at 44.5° the curve does not reach the target. Reduced to 0.01 it finds every rotation in 2D, where the mean curvature is all the curvature there is; the case against it is made by surfaces.",
      ),
    ];
  },
};
