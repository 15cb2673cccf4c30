/** An iteration of the past as a match that every view can draw. */

import { KEPT_LEVEL } from "../trail";
import { mapped } from "./field";
import type { Match } from "./result";

type Past = { readonly level: number; readonly kept?: Float32Array };

/** The reference's curves carried by the kept deformation; null where none was kept. */
export function matchAt({ level, kept }: Past, { reference, template }: Match["curves"]): Match | null {
  if (!kept) return null;
  const shown = Math.min(level, KEPT_LEVEL);
  const deformation = Float64Array.from(kept);
  const map = { cells: 2 ** shown, deformation };
  const matched = reference.map((loop) => {
    const out = new Float64Array(loop.length);
    for (let i = 0; i < loop.length; i += 2) out.set(mapped(map, loop[i], loop[i + 1]), i);
    return out;
  });
  return { level: shown, deformation, curves: { reference, template, matched } };
}
