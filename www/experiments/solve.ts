/** Runs a registration to its end and keeps what experiments look at. */

import type { Context, Settings, Shape, Status } from "./experiment";

export type Curves = {
  readonly reference: readonly Float64Array[];
  readonly template: readonly Float64Array[];
  readonly matched: readonly Float64Array[];
};

/** The state at the end of a level. */
export type LevelEnd = {
  readonly status: Status;
  /** φ at the nodes of the level, x y a node, x fastest. */
  readonly deformation: Float64Array;
  readonly curves: Curves;
  /** Since the start of the registration. */
  readonly millis: number;
};

/** The state after an iteration. */
export type Moment = { readonly millis: number; readonly energy: number; readonly level: number };

export type Solution = {
  readonly end: LevelEnd;
  /** All levels, coarsest first; only the last one unless `everyLevel` was asked for. */
  readonly levels: readonly LevelEnd[];
  readonly moments: readonly Moment[];
  /** Iterations on all levels. */
  readonly iterations: number;
};

export type Job = {
  readonly reference: Shape;
  readonly template: Shape;
  readonly settings: Partial<Settings>;
  readonly everyLevel?: boolean;
  /** Ends the run before the solver does. */
  readonly maxIterations?: number;
};

/** Solves to the end, or for `maxIterations`. */
export async function solve(context: Context, job: Job): Promise<Solution> {
  const start = context.millis();
  const registration = await context.solver.create(job.reference, job.template, job.settings);
  try {
    const levels: LevelEnd[] = [];
    const moments: Moment[] = [];
    let before: LevelEnd | null = null;
    for (;;) {
      const status = await registration.step(1);
      const millis = context.millis() - start;
      if (job.everyLevel && before && status.level !== before.status.level) levels.push(before);
      moments.push({ millis, energy: status.energies.total, level: status.level });
      const ended = status.finished || moments.length === job.maxIterations;
      if (job.everyLevel || ended)
        before = { status, deformation: registration.deformation(), curves: registration.curves(), millis };
      if (!ended || !before) continue;
      levels.push(before);
      return { end: before, levels, moments, iterations: moments.length };
    }
  } finally {
    registration.free();
  }
}
