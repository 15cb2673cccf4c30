/** Runs a registration to its end and keeps what experiments look at. */

import type { Context, Registration, Settings, Shape, Status } from "./experiment";

export type Curves = {
  readonly reference: readonly Float64Array[];
  readonly template: readonly Float64Array[];
  readonly matched: readonly Float64Array[];
};

/** Of curves. */
export type Drawn = {
  /** φ at the nodes of the level, D numbers a node, x fastest. */
  readonly deformation: Float64Array;
  readonly curves: Curves;
};

/** The state at the end of a level. */
export type End<T> = T & {
  readonly status: Status;
  /** Since the start of the registration. */
  readonly millis: number;
};

export type LevelEnd = End<Drawn>;

/** The state after an iteration. */
export type Moment = { readonly millis: number; readonly energy: number; readonly level: number };

export type Solution<T = Drawn> = {
  readonly end: End<T>;
  /** All levels, coarsest first; only the last one unless `everyLevel` was asked for. */
  readonly levels: readonly End<T>[];
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

/** Solves for curves to the end, or for `maxIterations`. */
export function solve(context: Context, job: Job): Promise<Solution> {
  return follow(context, job, (registration) => ({
    deformation: registration.deformation(),
    curves: registration.curves(),
  }));
}

/** The same with what `look` reads off at the ends of levels. */
export async function follow<T>(
  context: Context,
  job: Job,
  look: (registration: Registration) => T,
): Promise<Solution<T>> {
  const start = context.millis();
  const registration = await context.solver.create(job.reference, job.template, job.settings);
  try {
    const levels: End<T>[] = [];
    const moments: Moment[] = [];
    let before: End<T> | null = null;
    for (;;) {
      const status = await registration.step(1);
      const millis = context.millis() - start;
      if (job.everyLevel && before && status.level !== before.status.level) levels.push(before);
      moments.push({ millis, energy: status.energies.total, level: status.level });
      const ended = status.finished || moments.length === job.maxIterations;
      if (job.everyLevel || ended) before = { ...look(registration), status, millis };
      if (!ended || !before) continue;
      levels.push(before);
      return { end: before, levels, moments, iterations: moments.length };
    }
  } finally {
    registration.free();
  }
}
