/** One point of the reference with its partner: the numbers there. Fetched when a point is first pointed at. */

import { area, curvature, nearest, signedDistance, stretch } from "./along";
import { determinantAt } from "./field";
import type { Probe } from "./probe";
import type { Match } from "./result";

export type LocalNumbers = {
  readonly x: number;
  readonly y: number;
  readonly partnerX: number;
  readonly partnerY: number;
  readonly stretch: number;
  readonly determinant: number;
  /** Of the reference here and of the template at the partner, per box side. */
  readonly curvature: number;
  readonly partnerCurvature: number;
  /** Of the partner to the template, in cells. */
  readonly distance: number;
};

/** Half width, in cells, of what curvature is fitted to. */
export const CURVATURE_CELLS = 3;

/** At the reference's point nearest to the probe; null for a match without curves. */
export function localNumbers(match: Match, probe: Probe): LocalNumbers | null {
  const { reference, matched, template } = match.curves;
  const here = nearest(reference, probe.x, probe.y);
  if (!here) return null;
  const i = here.point;
  const loop = reference[here.loop];
  const moved = matched[here.loop];
  const cells = 2 ** match.level;
  const [x, y] = [loop[2 * i], loop[2 * i + 1]];
  const [partnerX, partnerY] = [moved[2 * i], moved[2 * i + 1]];
  const there = nearest(template, partnerX, partnerY);
  const bend = (points: Float64Array, at: number) =>
    Math.sign(area(points)) * curvature(points, at, CURVATURE_CELLS / cells);
  return {
    x,
    y,
    partnerX,
    partnerY,
    stretch: stretch(loop, moved, i),
    determinant: determinantAt({ cells, deformation: match.deformation }, x, y),
    curvature: bend(loop, i),
    partnerCurvature: there ? bend(template[there.loop], there.point) : Number.NaN,
    distance: Math.abs(signedDistance(template, partnerX, partnerY)) * cells,
  };
}
