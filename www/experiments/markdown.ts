/** The experiments' outcome as one Markdown document. */

import type { Block, Study } from "./experiment";

export type Chapter = Pick<Study, "id" | "title" | "paper" | "setup"> & { readonly blocks: readonly Block[] };

/** Before the experiments with curves. */
export const OF_CURVES = `# The paper in 2D, reproduced

J. A. Iglesias, B. Berkels, M. Rumpf, O. Scherzer, “A Thin Shell Approach to the Registration of Implicit Surfaces”,
Vision, Modeling and Visualization 2013, doi:10.2312/PE.VMV.VMV13.089-096. Its experiments, carried over to curves in
the plane where they are about surfaces.

This file and its figures are written by \`npm run reproduce\`, every number in them by that run. The page
\`experiments.html\` computes the same live, from the same source (\`www/experiments\`). Lengths are in units of the box
[0,1]²; n² means n nodes a side; a cell is the spacing of the grid; mismatch is |d₂(φ)| along the reference. Times are
wall-clock times of one thread of WebAssembly in Node on the machine that wrote this file, busy with other work as it was;
the rest does not depend on the machine. “The paper's settings”: from the identity, α_bend = 1, ξ = 10⁻³, eq. (2) as it stands and no H¹ residual
(\`www/experiments/paper.ts\`); what is not named has its default (\`docs/settings.md\`).`;

/** … and with surfaces. */
export const OF_SURFACES = `# The paper's surfaces, reproduced

J. A. Iglesias, B. Berkels, M. Rumpf, O. Scherzer, “A Thin Shell Approach to the Registration of Implicit Surfaces”,
Vision, Modeling and Visualization 2013, doi:10.2312/PE.VMV.VMV13.089-096. Its experiments with surfaces; those carried
over to curves are in [paper.md](paper.md).

This file and its figures are written by \`npm run reproduce\`, every number in them by that run. The page
\`experiments.html\` computes the same live, from the same source (\`www/experiments/solids\`). Lengths are in units of the
box [0,1]³; n³ means n nodes a side; a cell is the spacing of the grid; mismatch is |d₂(φ)| along the reference. The least
determinant is a certified bound over whole cells. Times are wall-clock times of one thread of WebAssembly in Node on the
machine that wrote this file, busy with other work as it was; the rest does not depend on the machine. “The paper's
settings”: from the identity, α_bend = 1, ξ = 10⁻³, eq. (2) as it stands and no H¹ residual (\`www/experiments/paper.ts\`);
what is not named has its default (\`docs/settings.md\`).`;

export function document(head: string, chapters: readonly Chapter[]): string {
  return [
    head,
    ...chapters.map(({ title, paper, setup, blocks }) =>
      [`## ${title}`, `**In the paper.** ${paper}`, `**Here.** ${setup}`, ...blocks.map(block)]
        .filter((part) => !part.endsWith("** "))
        .join("\n\n"),
    ),
  ]
    .join("\n\n")
    .concat("\n");
}

function block(block: Block): string {
  if (block.kind === "text") return block.text;
  if (block.kind === "figure") return `![${block.caption}](figures/${block.name}.svg)\n\n*${block.caption}*`;
  const line = (cells: readonly string[]) => `| ${cells.map((cell) => cell.replaceAll("|", "\\|")).join(" | ")} |`;
  return [line(block.head), line(block.head.map(() => "---")), ...block.rows.map(line)].join("\n");
}
