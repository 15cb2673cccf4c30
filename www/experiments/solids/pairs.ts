/** Figs. 8 and 9: pairs of surfaces with features, matched as a thin shell and by volume energy alone. */

import { picture } from "../../space/picture";
import {
  type Block,
  type Context,
  cells,
  type Settings,
  type SolidExperiment,
  seconds,
  small,
  table,
  text,
} from "../experiment";
import { panels } from "../svg";
import { errors } from "./measure";
import { bumpy, creatures, type MeshShape } from "./shapes";
import { type SolidEnd, solveSolid } from "./solve";
import { twisted } from "./truth";

const PAIRS: readonly { readonly name: string; readonly shapes: () => readonly [MeshShape, MeshShape] }[] = [
  { name: "figure → waving figure", shapes: () => [creatures.figure(), creatures.waving()] },
  { name: "hound → trotting hound", shapes: () => [creatures.hound(), creatures.trotting()] },
  { name: "bumpy sphere → twisted", shapes: () => [bumpy(), bumpy(twisted)] },
];

/** The pair whose true correspondence its numbering tells. */
const KNOWN = 2;

export const MODES: readonly { readonly name: string; readonly settings: Partial<Settings> }[] = [
  { name: "thin shell", settings: {} },
  { name: "volume only", settings: { membrane: 0, bending: 0, tangency: 0 } },
];

export async function match(
  context: Context,
  [reference, template]: readonly [MeshShape, MeshShape],
  finest: number,
  settings: Partial<Settings>,
): Promise<SolidEnd> {
  const job = { reference, template, settings: { align: "none", coarsest: 4, finest, ...settings } as const };
  return (await solveSolid(context, job)).end;
}

export const pairsExperiment: SolidExperiment = {
  id: "pairs",
  title: "Surfaces, Figs. 8 and 9: thin shell against volume only",
  paper:
    "Pairs of complex surfaces are matched by the thin shell and by volume energy alone. Both bring one surface onto the other; only the shell carries features to features.",
  setup:
    "Pairs of the page's gallery and one whose correspondence is known, from the identity, with default weights; “volume only” leaves out membrane, bending and the mismatch's H¹ part. Distances both ways: of the moved reference to the target, and of the target to the moved reference; the least determinant is a certified bound (Bernstein coefficients). The area ratio is that of the matched surface.",
  example: { reference: "hound", template: "hound-trotting", settings: { align: "none" } },
  hasShortForm: true,
  async run(context, size) {
    const finest = size === "full" ? 5 : 4;
    const rows: string[][] = [];
    const shown = [];
    const errorsOfTruth: number[] = [];
    const fits = MODES.map(() => 0);
    for (const [i, { name, shapes }] of PAIRS.entries()) {
      const pair = shapes();
      const [reference] = pair;
      const { positions, indices } = reference;
      shown.push({ title: name, picture: await picture({ positions, indices, places: positions }, 200) });
      for (const [j, mode] of MODES.entries()) {
        await context.progress((i + j / MODES.length) / PAIRS.length, `${name}, ${mode.name}`);
        const { status, matched, millis } = await match(context, pair, finest, mode.settings);
        if (Math.max(status.mismatch.max, status.cover.max) <= 0.5) fits[j] += 1;
        if (i === KNOWN) errorsOfTruth.push(errors(matched, pair[1].positions).mean);
        rows.push([
          name,
          mode.name,
          `${cells(status.mismatch.mean)} / ${cells(status.mismatch.max)}`,
          `${cells(status.cover.mean)} / ${cells(status.cover.max)}`,
          small(status.leastDeterminant),
          `${status.stretch.mean.toFixed(2)} ± ${status.stretch.deviation.toFixed(2)}`,
          seconds(millis),
        ]);
        shown.push({
          title: mode.name,
          note: `area ratio ± ${status.stretch.deviation.toFixed(2)}`,
          picture: await picture({ positions: matched, indices, places: positions }, 200),
        });
      }
    }
    const blocks: Block[] = [
      table(
        [
          "pair",
          "energies",
          "to the target, mean / max, cells",
          "back, mean / max",
          "least det Dφ",
          "area ratio",
          "time",
        ],
        rows,
      ),
      {
        kind: "figure",
        name: "surface-pairs",
        caption: "The references, and what the thin shell and volume energy alone make of their colours and lines.",
        svg: panels(shown, 3, 200),
      },
      text(words(errorsOfTruth, fits)),
    ];
    return blocks;
  },
};

/**
 * What the numbers say: the errors of the pair whose correspondence is known, and how many pairs fit within half a cell
 * both ways, with the shell and without.
 */
export function words([shell, volume]: readonly number[], [fits, fitsWithout]: readonly number[]): string {
  const times = volume / shell;
  return [
    `Within half a cell both ways are ${fits} of ${PAIRS.length} pairs with the thin shell, ${fitsWithout} with volume energy alone.`,
    "Where both are, distances do not tell them apart, and what differs is where points go: the area ratio of volume energy alone swings more, for hardly anything holds points along the surface.",
    `On the twisted sphere, whose numbering tells where each vertex belongs, its mean error is ${volume.toFixed(4)} box lengths, that of the thin shell ${shell.toFixed(4)}${times > 1.05 ? `, ${times.toFixed(1)} times less` : ""}.`,
  ].join(" ");
}
