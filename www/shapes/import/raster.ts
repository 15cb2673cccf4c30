/**
 * What regions enclose, seen on a raster: the way out where an exact outline would take for ever. The cost is that of
 * the rows that edges cross, whatever else they cross.
 */

import { type Bounds, bounds, type Loop, type Shape } from "../geometry";
import { blurred } from "./ink";
import type { Region } from "./region";
import { traced } from "./trace";

/** Samples along the longer side: thirteen a cell of the default grid for a shape as large as Fit makes it. */
const SIDE = 1024;

/** Free samples around everything, so that no outline is cut. */
const MARGIN = 2;

/** The outline of the union to a sample; `report` is told the part that is done. */
export function outlined(regions: readonly Region[], report: (done: number) => void = () => {}): Shape {
  const box = bounds(regions.flatMap(({ loops }) => loops));
  const extent = box ? Math.max(box.right - box.left, box.top - box.bottom) : 0;
  if (!box || !(extent > 0)) return [];
  const raster = new Raster(box, extent / (SIDE - 2 * MARGIN));
  regions.forEach((region, i) => {
    raster.add(region);
    if (i % 64 === 0) report(i / regions.length);
  });
  return raster.outline();
}

class Raster {
  private readonly left: number;
  private readonly bottom: number;
  private readonly step: number;
  private readonly width: number;
  private readonly height: number;
  /** How many regions begin less how many end at each sample, from left to right; one column more for the ends. */
  private readonly changes: Int32Array;

  /** Sample (i, j) lies at the left lower corner of the box moved by (i − margin, j − margin) steps. */
  constructor(box: Bounds, step: number) {
    this.step = step;
    this.left = box.left - MARGIN * step;
    this.bottom = box.bottom - MARGIN * step;
    this.width = Math.ceil((box.right - box.left) / step) + 2 * MARGIN + 1;
    this.height = Math.ceil((box.top - box.bottom) / step) + 2 * MARGIN + 1;
    this.changes = new Int32Array((this.width + 1) * this.height);
  }

  add({ loops, rule }: Region): void {
    const inside = rule === "evenodd" ? (turns: number) => (turns & 1) === 1 : (turns: number) => turns !== 0;
    const crossings = loops.reduce((sum, loop) => sum + this.crossings(loop), 0);
    const columns = this.width + 1;
    if (crossings > columns * this.height) {
      // So many that a number for every sample is the shorter list.
      const turns = new Int32Array(this.changes.length);
      for (const loop of loops) {
        this.cross(loop, (at, turn) => {
          turns[at] += turn;
        });
      }
      for (let row = 0; row < this.height; row += 1) {
        let [sum, was] = [0, false];
        for (let at = row * columns; at < (row + 1) * columns; at += 1) {
          sum += turns[at];
          const is = inside(sum);
          if (is !== was) this.changes[at] += is ? 1 : -1;
          was = is;
        }
      }
      return;
    }
    // Each crossing as one number that sorts by place: the place, and which way.
    const found = new Float64Array(crossings);
    let count = 0;
    for (const loop of loops) {
      this.cross(loop, (at, turn) => {
        found[count] = 2 * at + (turn > 0 ? 1 : 0);
        count += 1;
      });
    }
    found.sort();
    let [sum, was] = [0, false];
    for (let k = 0; k < count; k += 1) {
      sum += found[k] % 2 === 1 ? 1 : -1;
      const is = inside(sum);
      if (is !== was) this.changes[Math.floor(found[k] / 2)] += is ? 1 : -1;
      was = is;
    }
  }

  outline(): Shape {
    const { width, height } = this;
    const ink = new Uint8Array(width * height);
    for (let row = 0; row < height; row += 1) {
      let sum = 0;
      for (let i = 0; i < width; i += 1) {
        sum += this.changes[row * (width + 1) + i];
        // Pictures have their first row on top.
        ink[(height - 1 - row) * width + i] = sum > 0 ? 255 : 0;
      }
    }
    const picture = { width, height, ink: blurred(ink, width, height), threshold: 127.5, borderIsInk: false };
    return traced(picture, picture.threshold, false).loops.map((loop) =>
      // Outlines of pictures have the first pixel at (1, 1).
      loop.map((value, k) => (k % 2 === 0 ? this.left : this.bottom) + (value - 1) * this.step),
    );
  }

  private crossings(loop: Loop): number {
    let count = 0;
    for (let i = 0, j = loop.length - 2; i < loop.length; j = i, i += 2) {
      count += Math.abs(this.row(loop[i + 1]) - this.row(loop[j + 1]));
    }
    return count;
  }

  /** Tells each row's first sample right of each edge, and whether the edge runs up (+1) or down there. */
  private cross(loop: Loop, tell: (at: number, turn: 1 | -1) => void): void {
    for (let i = 0, j = loop.length - 2; i < loop.length; j = i, i += 2) {
      const [from, to] = [this.row(loop[j + 1]), this.row(loop[i + 1])];
      if (from === to) continue;
      const slope = (loop[i] - loop[j]) / (loop[i + 1] - loop[j + 1]);
      for (let row = Math.min(from, to); row < Math.max(from, to); row += 1) {
        const x = loop[j] + slope * (this.bottom + row * this.step - loop[j + 1]);
        const column = Math.min(this.width, Math.max(0, Math.ceil((x - this.left) / this.step)));
        tell(row * (this.width + 1) + column, to > from ? 1 : -1);
      }
    }
  }

  /** The first row at or above y. */
  private row(y: number): number {
    return Math.ceil((y - this.bottom) / this.step);
  }
}
