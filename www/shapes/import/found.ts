/** What reading a file or a pasted text yields, before anything is chosen or placed. */

import type { Shape } from "../geometry";

/** What a file of morphometrics says beside the outline, in the same units. */
export type Marks = {
  /** x y x y …; NaN twice where one is missing. */
  readonly landmarks: Float64Array;
  readonly image: string | null;
  /** Lengths of the file times this are true ones; null where it does not say. */
  readonly scale: number | null;
};

/** One shape of a file. Loops are y up, bodies counter-clockwise and holes clockwise, in units of the file's own. */
export type Choice = {
  readonly name: string;
  readonly loops: Shape;
  /** The coordinates are the box's own, and the shape keeps its distance from the border. */
  readonly placed: boolean;
  /** Only its largest part is meant, such as a country's mainland. */
  readonly mainPart: boolean;
  /** Details up to about this many cells of the grid are better rounded off: coasts have them at any scale. */
  readonly smoothing: number;
  readonly marks?: Marks;
  /** Why it is none, among others that are some: then it has no loops. */
  readonly problem?: string;
};

/** A picture made small, without colour. */
export type Picture = {
  readonly width: number;
  readonly height: number;
  /** 0 is surely outside, 255 surely inside when not flipped; row 0 on top. */
  readonly ink: Uint8Array;
  /** Otsu's threshold on `ink`. */
  readonly threshold: number;
  /** Whether most of the picture's border is ink: then the shape is what is not. */
  readonly borderIsInk: boolean;
};

export type FoundShapes = {
  readonly kind: "shapes";
  readonly choices: readonly Choice[];
  readonly notes: readonly string[];
  /** The choices after the first are no shapes by themselves: parts of it, or what it was matched with. */
  readonly firstIsAll?: boolean;
};

export type Found =
  | FoundShapes
  | { readonly kind: "picture"; readonly picture: Picture; readonly notes: readonly string[] }
  /** JSON that this page has saved: to be read by whoever knows about matches. */
  | { readonly kind: "saved"; readonly content: unknown };

/** Of coordinates: the squares of what is computed with have to be numbers too. */
export const MOST_NUMBER = 1e100;

/** Input that cannot be taken: a sentence that says what is wrong and what to do. */
export class ImportError extends Error {
  override readonly name = "ImportError";
}
