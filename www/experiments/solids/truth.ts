/** Pairs whose true correspondence is known: one mesh in two poses, by formulas or from two files. */

import type { Soup } from "../../space/files";
import { around } from "../../space/forms";
import type { Vector } from "../../space/solid";
import { type Block, type Context, cells, type SolidExperiment, seconds, small, table, text } from "../experiment";
import { errors } from "./measure";
import { bumpy, type MeshShape } from "./shapes";
import { nodes, type SolidEnd, solveSolid } from "./solve";

/** About the x axis, by 1.6 radians a box length. */
export function twisted([x, y, z]: Vector): Vector {
  return around(x, y, z, 1.6 * x);
}

/** Along an arc in the plane of x and y. */
function bent([x, y, z]: Vector): Vector {
  const radius = 0.6;
  const angle = x / radius;
  return [(radius + y) * Math.sin(angle), (radius + y) * Math.cos(angle) - radius + 0.03, z];
}

/** Drawn outwards above, and in below. */
function bulged([x, y, z]: Vector): Vector {
  const grow = 1 + 0.8 * y;
  return [grow * x, y, grow * z];
}

const POSES = [
  { name: "twist", move: twisted },
  { name: "bend", move: bent },
  { name: "bulge", move: bulged },
] as const;

export type Judged = {
  readonly end: SolidEnd;
  readonly iterations: number;
  /** Of the correspondence, in box lengths: at first, and in the end. */
  readonly before: ReturnType<typeof errors>;
  readonly after: ReturnType<typeof errors>;
};

/** Both meshes have the same numbering; `align: "none"` would be told where everything is. */
export async function judge(
  context: Context,
  reference: MeshShape,
  template: MeshShape,
  finest: number,
): Promise<Judged> {
  const { end, iterations } = await solveSolid(context, { reference, template, settings: { coarsest: 4, finest } });
  const truth = template.positions;
  return { end, iterations, before: errors(reference.positions, truth), after: errors(end.matched, truth) };
}

/** The longest side of the box around two meshes. */
const LONGEST = 0.72;

const HEAD = [
  "nodes",
  "error of the identity, mean / max",
  "of the match, mean / max",
  "share",
  "mismatch, mean / max, cells",
  "least det Dφ",
  "time",
];

function percent(share: number): string {
  return `${(100 * share).toFixed(1)} %`;
}

function row({ end: { status, millis }, before, after }: Judged): string[] {
  return [
    nodes(status.level),
    `${before.mean.toFixed(4)} / ${before.max.toFixed(4)}`,
    `${after.mean.toFixed(4)} / ${after.max.toFixed(4)}`,
    percent(after.mean / before.mean),
    `${cells(status.mismatch.mean)} / ${cells(status.mismatch.max)}`,
    small(status.leastDeterminant),
    seconds(millis),
  ];
}

export const truthExperiment: SolidExperiment = {
  id: "truth",
  title: "Surfaces beyond the paper: a known correspondence",
  paper: "The paper judges correspondences by eye.",
  setup:
    "A bumpy sphere and the same mesh moved by a formula: a twist, a bend, a bulge. The numbering tells where each vertex should end; the solver sees two surfaces only. Default settings. Error: the distance of a vertex's image from its namesake, in box lengths; share: the match's mean error over that of the identity.",
  example: { reference: "bar", template: "bar-twisted", settings: {} },
  hasShortForm: true,
  async run(context, size) {
    const levels = size === "full" ? [4, 5] : [4];
    const rows: string[][] = [];
    const shares: number[] = [];
    for (const [i, { name, move }] of POSES.entries())
      for (const [j, level] of levels.entries()) {
        await context.progress((i + j / levels.length) / POSES.length, `${name}, ${nodes(level)}`);
        const judged = await judge(context, bumpy(), bumpy(move), level);
        rows.push([name, ...row(judged)]);
        shares.push(judged.after.mean / judged.before.mean);
      }
    return [table(["pose", ...HEAD], rows), text(words(shares))];
  },
};

/** What the shares of the identity's error say. */
export function words(shares: readonly number[]): string {
  const [least, most] = [Math.min(...shares), Math.max(...shares)];
  return [
    `Between ${percent(least)} and ${percent(most)} of the identity's error are left, although the surfaces lie on one another to a small part of a cell.`,
    most > 1 ? "Where more than all is left, the match is no nearer to the formula than doing nothing." : "",
    "Nothing tells the solver the formula: the bumps are low, a bend or a bulge strains the surface, and what strains it least takes points elsewhere.",
  ]
    .filter(Boolean)
    .join(" ");
}

/** Moves and scales both alike, so that the box around them is in the middle and has room at the border. */
export function fittedTogether(one: Soup, other: Soup): readonly [MeshShape, MeshShape] {
  if (one.positions.length !== other.positions.length)
    throw new Error(
      `The meshes have ${one.positions.length / 3} and ${other.positions.length / 3} vertices; of one numbering they have as many.`,
    );
  const [least, most] = [[1, 1, 1].map(() => Infinity), [1, 1, 1].map(() => -Infinity)];
  for (const { positions } of [one, other])
    for (const [k, at] of positions.entries()) {
      least[k % 3] = Math.min(least[k % 3], at);
      most[k % 3] = Math.max(most[k % 3], at);
    }
  const scale = LONGEST / Math.max(...most.map((value, axis) => value - least[axis]));
  const placed = ({ positions, indices }: Soup): MeshShape => ({
    kind: "mesh",
    positions: positions.map((at, k) => 0.5 + scale * (at - (least[k % 3] + most[k % 3]) / 2)),
    indices,
  });
  return [placed(one), placed(other)];
}

/** Two meshes of one numbering, from files. */
export async function matchMeshes(
  context: Context,
  [reference, template]: readonly [MeshShape, MeshShape],
  finest: number,
): Promise<Block[]> {
  const rows: string[][] = [];
  for (let level = 5; level <= finest; level += 1) {
    await context.progress((level - 5) / (finest - 4), nodes(level));
    rows.push(row(await judge(context, reference, template, level)));
  }
  return [table(HEAD, rows)];
}
