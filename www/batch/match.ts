/** One reference matched with one target, and what morphometrics asks of the match. Who runs the solver is told. */

import { centroidSize, procrustesDistance } from "../morphometrics/configuration";
import { onOutline } from "../morphometrics/semilandmarks";
import { type Strains, strains } from "../morphometrics/strain";
import type { Curves, Status } from "../protocol";
import type { Chosen } from "../settings";
import { flat, type Pin } from "../shapes/pins";
import type * as Package from "../wasm/thinshell.js";
import { own, type Subject, tied } from "./subject";

/** What all targets of a batch are matched with. */
export type Plan = {
  readonly reference: Subject;
  /** Semilandmarks of the reference, in the box. */
  readonly points: Float64Array;
  readonly settings: Chosen;
};

export type Matched = {
  readonly status: Status;
  readonly deformation: Float64Array;
  readonly curves: Curves;
  readonly pins: readonly Pin[];
  readonly note: string | null;
  /** The reference's semilandmarks on the target, in the units of the target's file. */
  readonly points: Float64Array;
  /** Of these points, in true units where the file gives a scale. */
  readonly centroidSize: number;
  readonly procrustesDistance: number;
  /** What makes Dφ that of both shapes at one centroid size. */
  readonly factor: number;
};

/** Iterations between two looks at whether it is still wanted. */
const AT_ONCE = 4;

/** Calls `between` with each status on the way; what that throws ends it. */
export async function matched(
  { Registration }: Pick<typeof Package, "Registration">,
  { reference, points, settings }: Plan,
  target: Subject,
  between: (status: Status) => void | Promise<void>,
): Promise<Matched> {
  const { pins, note } = tied(reference, target);
  const registration = await Registration.create(
    { kind: "curves", loops: [...reference.shape] },
    { kind: "curves", loops: [...target.shape] },
    { ...settings, ...(pins.length > 0 && { pins: flat(pins) }) },
  );
  try {
    let status = await registration.step(AT_ONCE);
    while (!status.finished) {
      await between(status);
      status = await registration.step(AT_ONCE);
    }
    const carried = onOutline(registration.map(points), target.shape);
    const there = own(carried, target.box);
    return {
      status,
      deformation: registration.deformation(),
      curves: registration.curves(),
      pins,
      note,
      points: there,
      centroidSize: centroidSize(there) * (target.scale ?? 1),
      procrustesDistance: procrustesDistance(points, carried),
      factor: centroidSize(points) / centroidSize(carried),
    };
  } finally {
    registration.free();
  }
}

/** Of both shapes at one centroid size: what is left when size is taken out. */
export function strained({ deformation, factor }: Matched): Strains {
  return strains(deformation, factor);
}
