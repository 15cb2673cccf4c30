/** What ε, δ, σ, ξ and θ each do: one changed at a time. */

import { type Context, cells, type Experiment, type Settings, small, table, text } from "./experiment";
import { length } from "./measure";
import { PAPER } from "./paper";
import { example } from "./shapes";
import { type LevelEnd, solve } from "./solve";

type Sweep = {
  readonly name: string;
  readonly field: "penalty" | "thickness" | "bandwidth" | "volume" | "vertexShare";
  readonly values: readonly number[];
  readonly see: string;
};

export const SWEEPS: readonly Sweep[] = [
  {
    name: "1/ε on 17²",
    field: "penalty",
    values: [10, 100, 1e3, 1e4, 1e5],
    see: "The penalty pulls the curve onto the target: the mismatch falls as 1/ε grows, and the curve becomes as long as the target. Too small a penalty lets the shell cut off the features; a larger one than needed brings the cells closer to folding.",
  },
  {
    name: "δ on 17²",
    field: "thickness",
    values: [0.05, 0.2, 0.5, 1, 2],
    see: "A thin shell is nearly a membrane and spreads the stretch evenly. With thickness bending, which goes with δ³, gains on the membrane: curved parts look for curved parts, and the stretch in between has to differ. A shell too thick for the penalty does not reach the target at all.",
  },
  {
    name: "σ",
    field: "bandwidth",
    values: [0.03, 0.05, 0.1, 0.2],
    see: "The width of the band hardly changes the matched curve. But all offset curves within the band resist stretching like the curve itself, so a wide one brings more of the plane close to folding.",
  },
  {
    name: "ξ",
    field: "volume",
    values: [1e-5, 1e-4, 1e-3, 1e-2, 1e-1],
    see: "The volume term keeps the plane in one piece: more of it keeps the cells further from folding, while the curve hardly notices. With next to none the search may come to rest against folds before it has arrived.",
  },
  {
    name: "θ",
    field: "vertexShare",
    values: [0, 0.02, 0.1, 0.25, 0.5],
    see: "The share of the volume term taken at the corners: with 0 the energy does not see a corner closing, the search runs against the fold and ends there. Any share from 0.02 on avoids it.",
  },
];

export function sweepOne(context: Context, finest: number, settings: Partial<Settings>): Promise<LevelEnd> {
  return solve(context, { ...example("hand"), settings: { ...PAPER, coarsest: 4, finest, ...settings } }).then(
    ({ end }) => end,
  );
}

export const sweepExperiment: Experiment = {
  id: "sweep",
  title: "What ε, δ, σ, ξ and θ do",
  paper: "The paper gives its parameters' values without a study of them.",
  setup:
    "The page's example “Hand → spread hand”, 17² to 65² nodes, one setting changed at a time and the others as in the paper (1/ε = 10³, δ = 0.5, σ = 0.05, ξ = 10⁻³, θ = 0.25).",
  example: () => ({ ...example("hand"), settings: { ...PAPER, finest: 6 } }),
  hasShortForm: false,
  async run(context) {
    const blocks = [];
    const count = SWEEPS.reduce((sum, { values }) => sum + values.length, 0);
    let done = 0;
    for (const { name, field, values, see } of SWEEPS) {
      const rows: string[][] = [];
      for (const value of values) {
        await context.progress(done / count, `${name} = ${value}`);
        const { status, curves } = await sweepOne(context, 6, { [field]: value });
        rows.push([
          String(value),
          cells(status.mismatch.mean),
          cells(status.mismatch.max),
          `${status.stretch.mean.toFixed(3)} ± ${status.stretch.deviation.toFixed(3)}`,
          (length(curves.matched) / length(curves.template)).toFixed(3),
          small(status.leastDeterminant),
        ]);
        done += 1;
      }
      blocks.push(
        text(see),
        table([name, "mean mismatch, cells", "max", "stretch", "length / target's", "least det Dφ"], rows),
      );
    }
    return blocks;
  },
};
