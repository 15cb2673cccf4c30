/** An experiment's pair as a link to the page. */

import { encode } from "../link/text";
import { type Chosen, FIELDS, withSetting } from "../settings";
import type { Experiment, Shape } from "./experiment";

/** Points a loop in a link: what the eye and a grid of 129² tell apart. */
const POINTS = 160;

/** Settings that the page does not offer are left to its defaults. */
export function linkTo({ reference, template, settings }: ReturnType<Experiment["example"]>): string {
  let chosen: Chosen = {};
  for (const field of FIELDS) {
    const value = settings[field.name];
    if (value !== undefined) chosen = withSetting(chosen, field, value as number | string | boolean);
  }
  return encode({ reference: loops(reference), template: loops(template), pins: [], settings: chosen, preset: null });
}

function loops(shape: Shape): Float64Array[] {
  return shape.kind === "curves" ? shape.loops.map(thinned) : [];
}

function thinned(loop: Float64Array): Float64Array {
  const count = loop.length / 2;
  const kept = Math.min(count, POINTS);
  return Float64Array.from({ length: 2 * kept }, (_, k) => loop[2 * Math.floor(((k >> 1) * count) / kept) + (k % 2)]);
}
