/** The experiments' surfaces, so finely cut that facets lie far below the finest grid's spacing. */

import { figure, hound, trotting, waving } from "../../space/creatures";
import { bumps, graph, type Mesh, moved, octahedron, turned, unduloid } from "../../space/forms";
import type { Vector } from "../../space/solid";
import type { Shape } from "../experiment";

/** A closed mesh in the box. */
export type MeshShape = Extract<Shape, { kind: "mesh" }>;

/** 20·4⁵ = 20480 triangles. */
const ROUNDS = 5;

export function boxed({ positions, indices }: Mesh): MeshShape {
  return { kind: "mesh", positions: positions.map((at) => 0.5 + at), indices };
}

export const sphere = (radius: number) => boxed(graph(() => radius, ROUNDS));

/** About the vertical axis, by degrees. */
export const turnedOctahedron = (degrees: number) =>
  boxed(moved(graph(octahedron, ROUNDS), turned((degrees * Math.PI) / 180)));

/** Long and slender: the ends hold the profile where it is, and are to be far from the bulge in the middle. */
export const UNDULOID = { periods: 2.2, scale: 0.048, detail: 2 } as const;

export const shiftedUnduloid = (shift: number) => boxed(unduloid(shift, UNDULOID));

export const creatures = {
  figure: () => boxed(figure()),
  waving: () => boxed(waving()),
  hound: () => boxed(hound()),
  trotting: () => boxed(trotting()),
};

/** A bumpy sphere, its vertices moved by a formula: the numbering tells which point belongs to which. */
export function bumpy(move: (point: Vector) => Vector = (point) => point): MeshShape {
  return boxed(moved(graph(bumps, ROUNDS), move));
}
