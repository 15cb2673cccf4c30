/** Closed surfaces made by formulas, in the box [0,1]³, y up. Meshes of one family have the same numbering. */

import { page } from "../words/language";
import { figure, hound, trotting, waving } from "./creatures";
import {
  around,
  bar,
  bent,
  bumps,
  graph,
  type Mesh,
  moved,
  norm,
  octahedron,
  supershape,
  torus,
  turned,
  unduloid,
} from "./forms";
import type { Solid } from "./solid";

type Made = { readonly id: string; readonly name: string; readonly make: () => Mesh };

const TURN = Math.PI / 6;

export const SURFACES: readonly Made[] = [
  { id: "sphere", name: "Sphere", make: () => graph(() => 0.24) },
  {
    id: "ellipsoid",
    name: "Ellipsoid",
    make: () =>
      moved(
        graph(() => 1),
        ([x, y, z]) => [0.32 * x, 0.2 * y, 0.23 * z],
      ),
  },
  { id: "octahedron", name: "Rounded octahedron", make: () => graph(octahedron) },
  { id: "octahedron-turned", name: "Octahedron, turned", make: () => moved(graph(octahedron), turned(TURN)) },
  { id: "unduloid", name: "Unduloid", make: () => unduloid(0) },
  { id: "unduloid-shifted", name: "Unduloid, shifted", make: () => unduloid(0.1) },
  { id: "torus", name: "Torus", make: () => torus },
  { id: "torus-bent", name: "Torus, bent", make: () => moved(torus, ([x, y, z]) => [x, y + 1.2 * (x * x - z * z), z]) },
  { id: "bumpy", name: "Bumpy sphere", make: () => graph(bumps) },
  { id: "bumpy-turned", name: "Bumpy sphere, turned", make: () => moved(graph(bumps), turned(TURN)) },
  { id: "cube", name: "Rounded cube", make: () => graph((d) => 0.22 * norm(d, 5)) },
  { id: "star", name: "Supershape", make: () => graph(supershape) },
  { id: "bar", name: "Bar", make: () => bar },
  { id: "bar-twisted", name: "Bar, twisted", make: () => moved(bar, ([x, y, z]) => around(x, y, z, 3 * x)) },
  { id: "bar-bent", name: "Bar, bent", make: () => moved(bar, bent) },
  { id: "figure", name: "Figure", make: figure },
  { id: "figure-waving", name: "Figure, waving", make: waving },
  { id: "hound", name: "Hound", make: hound },
  { id: "hound-trotting", name: "Hound, trotting", make: trotting },
];

export type PairOfSurfaces = { readonly reference: string; readonly template: string; readonly name: string };

/** Pairs that start with one press. */
export const PAIRS: readonly PairOfSurfaces[] = [
  { reference: "sphere", template: "ellipsoid", name: "Sphere → ellipsoid" },
  { reference: "octahedron", template: "octahedron-turned", name: "Octahedron, turned by 30°" },
  { reference: "unduloid", template: "unduloid-shifted", name: "Unduloid, shifted" },
  { reference: "torus", template: "torus-bent", name: "Torus → bent torus" },
  { reference: "bumpy", template: "bumpy-turned", name: "Bumps, turned by 30°" },
  { reference: "sphere", template: "cube", name: "Sphere → rounded cube" },
  { reference: "sphere", template: "star", name: "Sphere → supershape" },
  { reference: "bar", template: "bar-twisted", name: "Bar, twisted" },
  { reference: "bar", template: "bar-bent", name: "Bar, bent" },
  { reference: "figure", template: "figure-waving", name: "Figure, waving" },
  { reference: "hound", template: "hound-trotting", name: "Hound, trotting" },
];

page("surfaces", Object.fromEntries(SURFACES.map((entry) => [entry.id, entry])));
page("pairsOfSurfaces", Object.fromEntries(PAIRS.map((pair) => [`${pair.reference} ${pair.template}`, pair])));

const made = new Map<string, Solid>();

/** Null for a name that the gallery does not have. */
export function surface(id: string): Solid | null {
  const entry = SURFACES.find((candidate) => candidate.id === id);
  if (!entry) return null;
  let solid = made.get(id);
  if (!solid) {
    const { positions, indices } = entry.make();
    solid = { id, name: entry.name, positions: positions.map((at) => 0.5 + at), indices };
    made.set(id, solid);
  }
  return solid;
}
