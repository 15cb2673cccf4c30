/** The lines of a deformed grid that are drawn: whatever draws them, on a screen or on paper, asks here. */

/** Lines a direction; of finer grids every second, fourth, … is drawn. */
export const LINES = 32;

/** A line along x or y by its nodes: the first one's number, and from each to the next. */
export type GridLine = { readonly first: number; readonly step: number; readonly isBorder: boolean };

/** Of a grid of 2^level cells a side, whose nodes are numbered with x fastest. */
export function gridLines(level: number, most = LINES): readonly GridLine[] {
  const cells = 2 ** level;
  const lines: GridLine[] = [];
  for (let line = 0; line <= cells; line += Math.max(1, cells / most)) {
    const isBorder = line === 0 || line === cells;
    lines.push({ first: line * (cells + 1), step: 1, isBorder }, { first: line, step: cells + 1, isBorder });
  }
  return lines;
}
