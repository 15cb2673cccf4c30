/** Fig. 7: a surface with features, the match after each level. */

import { picture } from "../../space/picture";
import { type Context, cells, type SolidExperiment, seconds, small, table, text } from "../experiment";
import { panels } from "../svg";
import { creatures } from "./shapes";
import { nodes, type SolidEnd, solveSolid } from "./solve";

const COARSEST = 4;

export async function cascade(context: Context, finest: number): Promise<readonly SolidEnd[]> {
  const { levels } = await solveSolid(context, {
    reference: creatures.figure(),
    template: creatures.waving(),
    settings: { align: "none", coarsest: COARSEST, finest },
    everyLevel: true,
  });
  return levels;
}

export const levelsExperiment: SolidExperiment = {
  id: "figure",
  title: "Surfaces, Fig. 7: level by level",
  paper:
    "A complex surface is matched with another pose of it on 17³ to 129³ nodes; pictures after each level show limbs found first and features last.",
  setup:
    "A figure of round limbs and the same figure waving (both of the page's gallery), 17³ to 65³ nodes in one cascade from the identity, with default weights. Shown and measured: the match at the end of each level.",
  example: { reference: "figure", template: "figure-waving", settings: { align: "none" } },
  hasShortForm: true,
  async run(context, size) {
    const finest = size === "full" ? 6 : 5;
    await context.progress(0, `17³ to ${nodes(finest)}`);
    const levels = await cascade(context, finest);
    const { positions, indices } = creatures.figure();
    const target = creatures.waving();
    const side = 220;
    // All in cells of the finest level, so that the rows can be compared.
    const inFinest = ({ status }: SolidEnd, value: number) => cells(value * 2 ** (finest - status.level));
    return [
      table(
        [
          "nodes",
          `mean mismatch, cells of ${nodes(finest)}`,
          "max",
          "target missed by, max",
          "least det Dφ",
          "area ratio",
          "time since start",
        ],
        levels.map((end) => [
          nodes(end.status.level),
          inFinest(end, end.status.mismatch.mean),
          inFinest(end, end.status.mismatch.max),
          inFinest(end, end.status.cover.max),
          small(end.status.leastDeterminant),
          `${end.status.stretch.mean.toFixed(2)} ± ${end.status.stretch.deviation.toFixed(2)}`,
          seconds(end.millis),
        ]),
      ),
      {
        kind: "figure",
        name: "surface-figure",
        caption:
          "The reference, the match after each level, and the target: equal colours and lines are matched points.",
        svg: panels(
          [
            { title: "Reference", picture: await picture({ positions, indices, places: positions }, side) },
            ...(await Promise.all(
              levels.map(async (end) => ({
                title: nodes(end.status.level),
                note: `${inFinest(end, end.status.mismatch.max)} cells off at most`,
                picture: await picture({ positions: end.matched, indices, places: positions }, side),
              })),
            )),
            {
              title: "Target",
              picture: await picture({ ...target, places: target.positions.map(() => Number.NaN) }, side),
            },
          ],
          3,
          side,
        ),
      },
      text(
        "Coarse grids see a trunk with stumps and move arms and legs as wholes; each finer one finds them closer to their places.",
      ),
    ];
  },
};
