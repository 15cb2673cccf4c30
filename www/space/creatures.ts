/** Creatures of round limbs, grown together smoothly: surfaces with features, each in two poses. */

import type { Mesh } from "./forms";
import { zeroSetOfBox } from "./nets";
import { dot, minus, type Vector } from "./solid";

/** A rod with round ends. */
type Limb = { readonly from: Vector; readonly to: Vector; readonly radius: number };

/** How far limbs grow into one another. */
const BLEND = 0.035;
const CELLS = 64;

/** Left and right: the given one and its image across the plane x = 0. */
function both(limb: Limb): Limb[] {
  const image = ([x, y, z]: Vector): Vector => [-x, y, z];
  return [limb, { ...limb, from: image(limb.from), to: image(limb.to) }];
}

const limb = (radius: number, ...joints: Vector[]): Limb[] =>
  joints.slice(1).map((to, k) => ({ from: joints[k], to, radius }));

const TRUNK = [
  ...limb(0.078, [0, 0.26, 0], [0, 0.26, 0]),
  ...limb(0.045, [0, 0.2, 0], [0, 0.14, 0]),
  ...limb(0.088, [0, 0.08, 0], [0, -0.06, 0]),
];
const arm = (...joints: Vector[]) => limb(0.047, [0.06, 0.11, 0], ...joints);
const leg = (...joints: Vector[]) => limb(0.055, [0.045, -0.1, 0], ...joints);
const mirrored = (limbs: readonly Limb[]) => limbs.map((each) => both(each)[1]);

const FIGURE = [...TRUNK, ...arm([0.26, 0.06, 0]).flatMap(both), ...leg([0.1, -0.3, 0]).flatMap(both)];
const WAVING = [
  ...TRUNK,
  ...arm([0.17, 0.1, 0.03], [0.25, 0.24, 0.03]),
  ...mirrored(arm([0.22, -0.03, 0.06])),
  ...leg([0.1, -0.3, -0.05]),
  ...mirrored(leg([0.1, -0.29, 0.09])),
];

const BODY = limb(0.095, [-0.13, 0.04, 0], [0.12, 0.04, 0]);
const foot = (x: number, z: number, forward: number) =>
  limb(0.046, [x, 0, 0.85 * z], [x + 0.4 * forward, -0.12, z], [x + forward, -0.25, z]);

const HOUND = [
  ...BODY,
  ...limb(0.055, [0.14, 0.08, 0], [0.22, 0.2, 0]),
  ...limb(0.06, [0.22, 0.21, 0], [0.3, 0.18, 0]),
  ...limb(0.036, [-0.17, 0.08, 0], [-0.3, 0.2, 0]),
  ...[-0.08, 0.08].flatMap((z) => [...foot(-0.13, z, 0), ...foot(0.13, z, 0)]),
];
const TROTTING = [
  ...BODY,
  ...limb(0.055, [0.14, 0.08, 0], [0.24, 0.16, 0.03]),
  ...limb(0.06, [0.24, 0.17, 0.03], [0.31, 0.12, 0.07]),
  ...limb(0.036, [-0.17, 0.08, 0], [-0.32, 0.13, -0.05]),
  ...foot(-0.13, 0.08, 0.07),
  ...foot(-0.13, -0.08, -0.07),
  ...foot(0.13, 0.08, -0.07),
  ...foot(0.13, -0.08, 0.07),
];

export const figure = () => grown(FIGURE);
export const waving = () => grown(WAVING);
export const hound = () => grown(HOUND);
export const trotting = () => grown(TROTTING);

/** Farther from a limb than this it has no part in the surface. */
const REACH = 0.1;

/** The surface of the limbs, around the origin. */
function grown(limbs: readonly Limb[]): Mesh {
  const side = CELLS + 1;
  const sums = new Float64Array(side ** 3);
  for (const limb of limbs) {
    const [x, y, z] = [0, 1, 2].map((axis) => {
      const [low, high] = [Math.min, Math.max].map((most) => most(limb.from[axis], limb.to[axis]));
      const wide = limb.radius + REACH;
      const node = (at: number) => Math.min(CELLS, Math.max(0, Math.round(CELLS * (at + 0.5))));
      return [node(low - wide), node(high + wide)] as const;
    });
    for (let k = z[0]; k <= z[1]; k += 1)
      for (let j = y[0]; j <= y[1]; j += 1)
        for (let i = x[0]; i <= x[1]; i += 1)
          sums[(k * side + j) * side + i] += weight(limb, [i / CELLS - 0.5, j / CELLS - 0.5, k / CELLS - 0.5]);
  }
  const { positions, indices } = zeroSetOfBox(
    CELLS,
    sums.map((sum) => (sum > 0 ? level(sum) : 1)),
  );
  for (let k = 0; k < positions.length; k += 3) {
    const placed: Vector = [positions[k] - 0.5, positions[k + 1] - 0.5, positions[k + 2] - 0.5];
    positions.set(settled(limbs, placed), k);
  }
  return { positions, indices };
}

/** The point drawn onto the surface: a net passes near it only. */
function settled(limbs: readonly Limb[], point: Vector): Vector {
  const step = 1e-4;
  let at = point;
  for (let round = 0; round < 3; round += 1) {
    const value = distance(limbs, at);
    const slope = [0, 1, 2].map((axis) => {
      const beside = at.map((x, k) => (k === axis ? x + step : x)) as unknown as Vector;
      return (distance(limbs, beside) - value) / step;
    }) as unknown as Vector;
    const share = value / dot(slope, slope);
    at = at.map((x, axis) => x - share * slope[axis]) as unknown as Vector;
  }
  return at;
}

/** About the distance to the limbs' surface, negative inside: a smooth least of theirs. */
function distance(limbs: readonly Limb[], point: Vector): number {
  let sum = 0;
  for (const limb of limbs) sum += weight(limb, point);
  return level(sum);
}

function level(sum: number): number {
  return (-BLEND / 3) * Math.log(sum);
}

function weight({ from, to, radius }: Limb, point: Vector): number {
  const [along, away] = [minus(to, from), minus(point, from)];
  const part = Math.min(1, Math.max(0, dot(along, away) / (dot(along, along) || 1)));
  const gap = Math.hypot(away[0] - part * along[0], away[1] - part * along[1], away[2] - part * along[2]);
  return Math.exp((radius - gap) / (BLEND / 3));
}
