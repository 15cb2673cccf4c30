/**
 * Points of the reference tied to points of the template. A pin may lie anywhere in the box; one set near a curve lies
 * on it and stays there while the curve is pulled.
 */

import type { Point, Shape } from "./geometry";

export type Pin = { readonly reference: Point; readonly template: Point };

/** Both shapes with what ties them. */
export type Shapes = { readonly reference: Shape; readonly template: Shape; readonly pins: readonly Pin[] };

/** More could not be told apart; the solver takes a thousand. */
export const MOST_PINS = 99;

/** The solver's list: x y on the reference, x y on the template, pin by pin. */
export function flat(pins: readonly Pin[]): Float64Array {
  return Float64Array.from(pins.flatMap(({ reference: p, template: q }) => [p.x, p.y, q.x, q.y]));
}

/** The inverse of `flat`. */
export function pinsFrom(numbers: ArrayLike<number>): Pin[] {
  return Array.from({ length: numbers.length / 4 }, (_, i) => ({
    reference: { x: numbers[4 * i], y: numbers[4 * i + 1] },
    template: { x: numbers[4 * i + 2], y: numbers[4 * i + 3] },
  }));
}

export function isInBox(coordinate: number): boolean {
  return coordinate >= 0 && coordinate <= 1;
}
