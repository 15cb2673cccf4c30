/** What is saved: the page's shapes with the match that belongs to them. Plain data. */

import type { Curves, Status } from "../protocol";
import type { Chosen } from "../settings";
import type { Shapes } from "../shapes/pins";
import type { Match, ResultScene } from "../view/result";
import { missedBy } from "../view/unreached";

export type Saving = Shapes & {
  readonly settings: Chosen;
  readonly bandwidth: number;
  readonly match: { readonly status: Status; readonly deformation: Float64Array; readonly curves: Curves } | null;
};

/** As the result view shows it at a part `morph` of the deformation. */
export function sceneAt({ reference, template, pins, bandwidth, match }: Saving, morph: number): ResultScene {
  const shown: Match | null = match && {
    level: match.status.level,
    deformation: match.deformation,
    curves: match.curves,
  };
  return { reference, template, pins, match: shown, morph, bandwidth, missed: missedBy(match) };
}

/** Says what is in the file, and on which grid. */
export function fileName({ match }: Saving, extension: string): string {
  if (!match) return `thinshell-shapes.${extension}`;
  const side = 2 ** match.status.level + 1;
  return `thinshell-match-${side}x${side}.${extension}`;
}
