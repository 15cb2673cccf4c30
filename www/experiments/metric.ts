/** The metric: energy over iterations and over time for Sobolev gradients of several β and for Newton's method. */

import { type Context, type Experiment, nodes, type Settings, seconds, small, table, text } from "./experiment";
import { PAPER } from "./paper";
import { circle, ellipse } from "./shapes";
import { type Solution, solve } from "./solve";
import { charts } from "./svg";

export const METRICS: readonly { readonly name: string; readonly settings: Partial<Settings> }[] = [
  { name: "β = h, nearly L²", settings: { minimizer: "ncg", sobolev: 0 } },
  { name: "β from 0.1", settings: { minimizer: "ncg", sobolev: 0.1 } },
  { name: "β from 0.5", settings: { minimizer: "ncg", sobolev: 0.5 } },
  { name: "β from 2", settings: { minimizer: "ncg", sobolev: 2 } },
  { name: "Newton", settings: { minimizer: "newton" } },
];

/** One level from the identity, with the δ and ε a cascade has there, so that all minimise the same energy. */
export async function descend(context: Context, level: number, settings: Partial<Settings>): Promise<Solution> {
  return solve(context, {
    reference: circle(0.2),
    template: ellipse(0.3, 0.22),
    settings: {
      ...PAPER,
      coarsest: level,
      finest: level,
      thickness: 0.5 / 2 ** (level - 4),
      penalty: 1e3 * 2 ** (level - 4),
      tolerance: 1e-12,
      ...settings,
    },
    maxIterations: 1500,
  });
}

/** Relative gap to the least energy that counts as converged in the table. */
const GAP = 1e-3;

function lastGap(gap: number): string {
  return gap > 0 ? small(gap) : "0 (the least)";
}

export const metricExperiment: Experiment = {
  id: "metric",
  title: "The metric: L², Sobolev, Newton",
  paper:
    "The gradient is taken in the metric (1 − β²/2 Δ)⁻¹ with β halved as the search goes on: large regions move together at first. The paper uses it with Fletcher–Reeves directions and shows no comparison.",
  setup:
    "Circle of radius 0.2 to an ellipse with half axes 0.3 and 0.22, on a single level of 65² nodes (33² in the short form) from the identity, with the δ and ε that a cascade from 17² has there, tolerance 10⁻¹², at most 1500 iterations. β is halved whenever the energy stalls, down to h. The first curve starts at β = h, where the metric is as close to L² as this implementation goes. Shown: the energy less the least one found, over iterations and over time.",
  example: () => ({
    reference: circle(0.2),
    template: ellipse(0.3, 0.22),
    settings: { ...PAPER, finest: 6, minimizer: "ncg" },
  }),
  hasShortForm: true,
  async run(context, size) {
    const level = size === "full" ? 6 : 5;
    const runs: { name: string; solution: Solution }[] = [];
    for (const [i, { name, settings }] of METRICS.entries()) {
      await context.progress(i / METRICS.length, name);
      runs.push({ name, solution: await descend(context, level, settings) });
    }
    const least = Math.min(...runs.flatMap(({ solution }) => solution.moments.map(({ energy }) => energy)));
    const gap = (energy: number) => (energy - least) / least;
    const reached = ({ moments }: Solution) => moments.findIndex(({ energy }) => gap(energy) < GAP);
    const series = (across: (index: number, millis: number) => number) =>
      runs.map(({ name, solution }) => ({
        name,
        points: solution.moments.map(({ millis, energy }, i) => [across(i + 1, millis), gap(energy)] as const),
      }));
    return [
      table(
        ["", `iterations to a gap of ${GAP}`, "time to it", "iterations in all", "last gap"],
        runs.map(({ name, solution }) => {
          const at = reached(solution);
          return [
            name,
            at < 0 ? "not reached" : String(at + 1),
            at < 0 ? "" : seconds(solution.moments[at].millis),
            String(solution.iterations),
            lastGap(gap(solution.end.status.energies.total)),
          ];
        }),
      ),
      {
        kind: "figure",
        name: "metric",
        caption: `Relative gap to the least energy on ${nodes(level)} nodes.`,
        svg: charts([
          {
            title: "over iterations",
            x: "iteration",
            y: "relative gap",
            logX: true,
            logY: true,
            series: series((i) => i),
          },
          {
            title: "over time",
            x: "milliseconds",
            y: "relative gap",
            logX: true,
            logY: true,
            series: series((_, millis) => millis),
          },
        ]),
      },
      text(
        "Where β is small at once, the gradient sees little more than the cells next to the curve, and the plane follows only slowly. A large β moves the plane as a whole first and leaves the details for when it has been halved; much too large a β wastes iterations until then. Newton's method brings the metric that the energy itself prescribes, and multigrid makes it affordable: a few dear iterations instead of hundreds of cheap ones.",
      ),
    ];
  },
};
