/** The cascade: the match after each level, and what a single fine level does instead. */

import { type Context, cells, type Experiment, nodes, type Settings, seconds, small, table, text } from "./experiment";
import { PAPER } from "./paper";
import { example } from "./shapes";
import { type LevelEnd, solve } from "./solve";
import { panels } from "./svg";

const COARSEST = 4;

export async function cascade(context: Context, finest: number): Promise<readonly LevelEnd[]> {
  const { levels } = await solve(context, {
    ...example("hand"),
    settings: { ...PAPER, coarsest: COARSEST, finest },
    everyLevel: true,
  });
  return levels;
}

/** The finest level alone, with the given δ and 1/ε. */
export async function singleLevel(context: Context, finest: number, settings: Partial<Settings>): Promise<LevelEnd> {
  const { end } = await solve(context, {
    ...example("hand"),
    settings: { ...PAPER, coarsest: finest, finest, halving: false, ...settings },
  });
  return end;
}

export const cascadeExperiment: Experiment = {
  id: "cascade",
  title: "Algorithm 1: coarse to fine",
  paper:
    "Complex surfaces are matched level by level, δ and ε halved each time (Fig. 7): the coarse levels find the large motion, the fine ones the features.",
  setup:
    "The page's example “Hand → spread hand” with the paper's settings: 17² to 129² nodes, the state at the end of each level. Then the finest level alone, from the identity: once with the δ and ε that the cascade has there, once with those it starts with.",
  example: () => ({ ...example("hand"), settings: { ...PAPER, finest: 7 } }),
  hasShortForm: true,
  async run(context, size) {
    const finest = size === "full" ? 7 : 6;
    await context.progress(0, "cascade");
    const levels = await cascade(context, finest);
    const factor = 2 ** (finest - COARSEST);
    await context.progress(0.3, "one fine level, δ and ε of the cascade's end");
    const late = await singleLevel(context, finest, { thickness: 0.5 / factor, penalty: 1e3 * factor });
    await context.progress(0.6, "one fine level, δ and ε of the cascade's start");
    const early = await singleLevel(context, finest, { thickness: 0.5, penalty: 1e3 });
    const states = [
      ...levels.map((end) => ({ name: `cascade, ${nodes(end.status.level)}`, end })),
      { name: `${nodes(finest)} alone, late δ, ε`, end: late },
      { name: `${nodes(finest)} alone, early δ, ε`, end: early },
    ];
    // All in cells of the finest level, so that the rows can be compared.
    const inFinest = (end: LevelEnd, value: number) => cells(value * 2 ** (finest - end.status.level));
    return [
      table(
        ["", `mean mismatch, cells of ${nodes(finest)}`, "max", "least det Dφ", "stretch", "time since start"],
        states.map(({ name, end }) => [
          name,
          inFinest(end, end.status.mismatch.mean),
          inFinest(end, end.status.mismatch.max),
          small(end.status.leastDeterminant),
          `${end.status.stretch.mean.toFixed(2)} ± ${end.status.stretch.deviation.toFixed(2)}`,
          seconds(end.millis),
        ]),
      ),
      {
        kind: "figure",
        name: "cascade",
        caption: "The match after each level, and of the finest level alone. Blue: matched; orange: target.",
        svg: panels(
          states.map(({ name, end }) => ({
            title: name,
            note: `max mismatch ${inFinest(end, end.status.mismatch.max)} cells`,
            reference: end.curves.reference,
            template: end.curves.template,
            matched: end.curves.matched,
            ticks: true,
          })),
          3,
          260,
        ),
      },
      text(
        "A coarse level cannot resolve a finger's flank, so it moves fingers as wholes; the next level finds them in place. A single fine level sees flanks at once: it slides each to the nearest part of the target, or needs many more iterations to sort them out.",
      ),
    ];
  },
};
