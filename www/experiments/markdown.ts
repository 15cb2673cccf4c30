/** The experiments' outcome as one Markdown document. */

import type { Block, Experiment } from "./experiment";

export type Chapter = Pick<Experiment, "id" | "title" | "paper" | "setup"> & { readonly blocks: readonly Block[] };

const HEAD = `# The paper in 2D, reproduced

J. A. Iglesias, B. Berkels, M. Rumpf, O. Scherzer, “A Thin Shell Approach to the Registration of Implicit Surfaces”,
Vision, Modeling and Visualization 2013, doi:10.2312/PE.VMV.VMV13.089-096. Its experiments, carried over to curves in
the plane where they are about surfaces.

This file and its figures are written by \`npm run reproduce\`, every number in them by that run. The page
\`experiments.html\` computes the same live, from the same source (\`www/experiments\`). Lengths are in units of the box
[0,1]²; n² means n nodes a side; a cell is the spacing of the grid; mismatch is |d₂(φ)| along the reference. Times are
wall-clock times of one thread of WebAssembly in Node on the machine that wrote this file, the rest does not depend on
the machine. “The paper's settings”: from the identity, α_bend = 1, ξ = 10⁻³, eq. (2) as it stands and no H¹ residual
(\`www/experiments/paper.ts\`); what is not named has its default (\`docs/settings.md\`).`;

export function document(chapters: readonly Chapter[]): string {
  return [
    HEAD,
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
