/**
 * What each term of the energy pulls at: minus its derivative by φ at every node. The solver gives derivatives of its
 * whole energy only, so each term is asked for alone, with the weights that it has on the match's level.
 */

import type { Settings, Shape, Status } from "../protocol";
import { FIELDS } from "../settings";
import { KEPT_LEVEL } from "../trail";

export type Term = "membrane" | "bending" | "mismatch" | "volume";
export const FORCES: readonly Term[] = ["membrane", "bending", "mismatch", "volume"];

export type Job = {
  readonly reference: Shape;
  readonly template: Shape;
  readonly settings: Partial<Settings>;
  readonly level: number;
  /** φ at the nodes of the level. */
  readonly deformation: Float64Array;
};

/** Forces at the nodes of the kept level (see trail.ts): each the sum over the finer nodes around it. */
export type Forces = Readonly<Record<Term, Float64Array>>;

/** The part of the solver that is needed here. */
export type Evaluator = {
  create(
    reference: Shape,
    template: Shape,
    settings: Partial<Settings>,
  ): Promise<{
    evaluate(deformation: Float64Array): { readonly energies: Status["energies"]; readonly gradient: Float64Array };
    free(): void;
  }>;
};

/** Levels that the cascade begins at unless the settings say otherwise. */
const COARSEST = 4;

/** The match's settings on its level alone: δ and ε have been halved on the way to it. */
export function onLevel(settings: Partial<Settings>, level: number): Partial<Settings> {
  const initial = (name: "thickness" | "penalty") =>
    Number(settings[name] ?? FIELDS.find((field) => field.name === name)?.initial);
  const halvings = settings.halving === false ? 0 : level - (settings.coarsest ?? COARSEST);
  return {
    ...settings,
    coarsest: level,
    finest: level,
    thickness: initial("thickness") / 2 ** halvings,
    penalty: initial("penalty") * 2 ** halvings,
  };
}

/** The least that the solver takes for terms that may not be left out. */
const LEAST = { penalty: 1e-6, volume: 1e-9 };

/** One term's settings: the others left out, or as good as. */
function alone(settings: Partial<Settings>, term: Term): Partial<Settings> {
  return {
    ...settings,
    // φ is given: nothing is to be searched for.
    align: "none",
    pinWeight: 0,
    ...(term === "membrane" ? {} : { membrane: 0 }),
    ...(term === "bending" ? {} : { bending: 0 }),
    ...(term === "mismatch" ? {} : { penalty: LEAST.penalty }),
    ...(term === "volume" ? {} : { volume: LEAST.volume }),
  };
}

export async function forcesOf(solver: Evaluator, job: Job): Promise<Forces> {
  const found: Partial<Record<Term, Float64Array>> = {};
  const settings = onLevel(job.settings, job.level);
  for (const term of FORCES) {
    const registration = await solver.create(job.reference, job.template, alone(settings, term));
    try {
      found[term] = gathered(registration.evaluate(job.deformation).gradient, job.level);
    } finally {
      registration.free();
    }
  }
  return found as Forces;
}

/** Minus the gradient, summed over the nodes nearest to each kept one. */
export function gathered(gradient: Float64Array, level: number): Float64Array {
  const stride = 2 ** Math.max(0, level - KEPT_LEVEL);
  const from = 2 ** level + 1;
  const side = 2 ** Math.min(level, KEPT_LEVEL) + 1;
  const out = new Float64Array(2 * side * side);
  for (let j = 0; j < from; j += 1) {
    for (let i = 0; i < from; i += 1) {
      const node = 2 * (Math.round(j / stride) * side + Math.round(i / stride));
      out[node] -= gradient[2 * (j * from + i)];
      out[node + 1] -= gradient[2 * (j * from + i) + 1];
    }
  }
  return out;
}
