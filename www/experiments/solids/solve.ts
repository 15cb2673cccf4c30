/** Registers surfaces. */

import type { Context, Settings } from "../experiment";
import { type End, follow, type Solution } from "../solve";
import type { MeshShape } from "./shapes";

export type Moved = {
  /** φ at the nodes of the level, x y z a node, x fastest. */
  readonly deformation: Float64Array;
  /** φ at the reference's vertices. */
  readonly matched: Float64Array;
};

export type SolidEnd = End<Moved>;

export type SolidJob = {
  readonly reference: MeshShape;
  readonly template: MeshShape;
  readonly settings: Partial<Settings>;
  readonly everyLevel?: boolean;
};

export function solveSolid(context: Context, job: SolidJob): Promise<Solution<Moved>> {
  return follow(context, job, (registration) => ({
    deformation: registration.deformation(),
    matched: registration.map(job.reference.positions),
  }));
}

/** Nodes a side on a level, as tables name it. */
export function nodes(level: number): string {
  return `${2 ** level + 1}³`;
}
