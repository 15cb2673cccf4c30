/** Points of the reference surface tied to points of the template's. No DOM. */

import type { Side } from "./session";
import { minus, type Vector } from "./solid";

export type Pin = Readonly<Record<Side, Vector>>;

/** More could not be told apart. */
export const MOST_PINS = 99;

/** The solver's list: x y z on the reference, x y z on the template, pin by pin. */
export function flat(pins: readonly Pin[]): Float64Array {
  return Float64Array.from(pins.flatMap(({ reference, template }) => [...reference, ...template]));
}

/** The inverse of `flat`. */
export function pinsFrom(numbers: readonly number[]): Pin[] {
  return Array.from({ length: numbers.length / 6 }, (_, i) => ({
    reference: vector(numbers, 6 * i),
    template: vector(numbers, 6 * i + 3),
  }));
}

export function withEnd(pins: readonly Pin[], index: number, side: Side, point: Vector): Pin[] {
  return pins.map((pin, i) => (i === index ? { ...pin, [side]: point } : pin));
}

export function without(pins: readonly Pin[], index: number): Pin[] {
  return pins.filter((_, i) => i !== index);
}

/** The roles exchanged. */
export function swapped(pins: readonly Pin[]): Pin[] {
  return pins.map(({ reference, template }) => ({ reference: template, template: reference }));
}

export function samePins(one: readonly Pin[], other: readonly Pin[]): boolean {
  return one === other || flat(one).join() === flat(other).join();
}

/** Where a point of the reference is after the match: it goes as the nearest vertex does. */
export function carried(point: Vector, positions: ArrayLike<number>, matched: ArrayLike<number>): Vector {
  let [nearest, least] = [0, Number.POSITIVE_INFINITY];
  for (let k = 0; k < positions.length; k += 3) {
    const square =
      (positions[k] - point[0]) ** 2 + (positions[k + 1] - point[1]) ** 2 + (positions[k + 2] - point[2]) ** 2;
    if (square < least) [nearest, least] = [k, square];
  }
  const [x, y, z] = [0, 1, 2].map((axis) => point[axis] + matched[nearest + axis] - positions[nearest + axis]);
  return [x, y, z];
}

/** How far the pin that ends farthest from its partner does, in box lengths. */
export function farthestOff(pins: readonly Pin[], positions: ArrayLike<number>, matched: ArrayLike<number>): number {
  return Math.max(
    0,
    ...pins.map(({ reference, template }) => Math.hypot(...minus(carried(reference, positions, matched), template))),
  );
}

function vector(numbers: readonly number[], from: number): Vector {
  return [numbers[from], numbers[from + 1], numbers[from + 2]];
}
