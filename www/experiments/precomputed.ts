/** Reads the document that `npm run reproduce` writes back into blocks: what the page opens with. */

import type { Block } from "./experiment";

/** The blocks of each chapter by its title. Figures have no drawing: it lies in a file of its own. */
export function readDocument(text: string): ReadonlyMap<string, readonly Block[]> {
  const chapters = text.split(/^## /m).slice(1);
  return new Map(
    chapters.map((chapter) => {
      const [title, ...parts] = chapter.split("\n\n").map((part) => part.trim());
      return [title, parts.flatMap(blockOf)];
    }),
  );
}

function blockOf(part: string): Block[] {
  // What the experiment is, the page says itself.
  if (part === "" || /^\*\*(In the paper|Here)\.\*\*/.test(part)) return [];
  const figure = /^!\[(.*)\]\(figures\/(.*)\.svg\)$/s.exec(part);
  if (figure) return [{ kind: "figure", name: figure[2], svg: "", caption: figure[1] }];
  // The caption again, under its figure.
  if (/^\*[^*].*\*$/s.test(part)) return [];
  if (!part.startsWith("|")) return [{ kind: "text", text: part }];
  const [head, , ...rows] = part.split("\n").map(cellsOf);
  return [{ kind: "table", head, rows }];
}

function cellsOf(line: string): string[] {
  return line
    .slice(1, -1)
    .split(/(?<!\\)\|/)
    .map((cell) => cell.trim().replaceAll("\\|", "|"));
}
