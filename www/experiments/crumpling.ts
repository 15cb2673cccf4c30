/** Fig. 5: a circle that has to shrink much crumples instead; and what cures it. */

import { type Context, cells, type Experiment, type Settings, small, table, text } from "./experiment";
import { length } from "./measure";
import { PAPER } from "./paper";
import { circle } from "./shapes";
import { type LevelEnd, solve } from "./solve";
import { panels } from "./svg";

const RADIUS = 0.3;
export const RATIOS = [1.2, 1.5, 2, 2.5] as const;

export type Crumple = {
  readonly ratio: number;
  /** Length of the matched curve over the target's, less 1. */
  readonly excess: number;
  readonly end: LevelEnd;
};

/** What it is computed with. */
export const WAYS = {
  bare: { name: "α_bend = 0", settings: { ...PAPER, bending: 0 } },
  bent: { name: "α_bend = 1", settings: PAPER },
  projected: { name: "compression projected", settings: { ...PAPER, membraneModel: "projected" } },
  defaults: { name: "the defaults", settings: {} },
} as const satisfies Record<string, { name: string; settings: Partial<Settings> }>;

/** 33² nodes, circle of radius 0.3 to one `ratio` times smaller. */
export async function crumple(context: Context, ratio: number, way: keyof typeof WAYS): Promise<Crumple> {
  const { end } = await solve(context, {
    reference: circle(RADIUS),
    template: circle(RADIUS / ratio),
    settings: { ...WAYS[way].settings, coarsest: 4, finest: 5 },
  });
  return { ratio, excess: length(end.curves.matched) / ((2 * Math.PI * RADIUS) / ratio) - 1, end };
}

function percent(share: number): string {
  const tenths = Math.round(1000 * share) / 10;
  // No minus in front of zero.
  return `${(tenths || 0).toFixed(1)} %`;
}

export const crumplingExperiment: Experiment = {
  id: "crumpling",
  title: "Fig. 5: crumpling under strong shrinking",
  paper:
    "On 33² nodes a circle matched with a much smaller one does not shrink: it folds up in waves within the band and keeps much of its length. The distance term cannot tell a smooth curve from a crumpled one closer than the grid's resolution.",
  setup: `Circle of radius ${RADIUS} to one smaller by the ratio, 17² then 33² nodes, the paper's settings with α_bend = 0 and 1; the same with compression measured along the target (projected); and the defaults. Measured: the length of the matched curve over the small circle's perimeter, less 1.`,
  example: () => ({ reference: circle(RADIUS), template: circle(RADIUS / 2), settings: { ...PAPER, finest: 5 } }),
  hasShortForm: false,
  async run(context) {
    const runs: (Crumple & { name: string })[] = [];
    const ways = Object.keys(WAYS) as (keyof typeof WAYS)[];
    for (const way of ways)
      for (const ratio of RATIOS) {
        const { name } = WAYS[way];
        await context.progress(runs.length / (ways.length * RATIOS.length), `${name}, ratio ${ratio}`);
        runs.push({ ...(await crumple(context, ratio, way)), name });
      }
    return [
      table(
        ["with", "ratio", "excess", "max mismatch, cells", "least det Dφ"],
        runs.map(({ name, ratio, excess, end }) => [
          name,
          String(ratio),
          percent(excess),
          cells(end.status.mismatch.max),
          small(end.status.leastDeterminant),
        ]),
      ),
      {
        kind: "figure",
        name: "crumpling",
        caption: "Matched curves (blue) over the small circles (orange); the thin circle is the reference.",
        svg: panels(
          runs.map(({ name, ratio, excess, end }) => ({
            title: `ratio ${ratio}, ${name}`,
            note: `excess ${percent(excess)}`,
            ...end.curves,
          })),
          4,
          190,
        ),
      },
      text(
        "Why: W_mem punishes compression and W_vol shrinking of area, while within half a cell of the small circle the curve may wander at no cost. A wave of that amplitude keeps the length. At a ratio of 1.2 plain shrinking is still the cheaper way. Bending takes some of the excess off, not most of it: δ³ is small beside δ, and the waves are as short as the grid allows. The lengths also show what the mismatch cannot: a curve half a cell off everywhere may be half as long again as it should be.",
      ),
      text(
        "Two cures. Projected compression is how much shorter the shell becomes along the target, not along itself: a wave that keeps the length is compressed all the same and saves nothing, so the circle shrinks. With the defaults it is the search that avoids the waves: where the target is much shorter, it is matched the other way round, by stretching, which has no waves, and the inverse is refined.",
      ),
    ];
  },
};
