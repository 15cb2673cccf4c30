/** Closed surfaces made by formulas, in the box [0,1]³, y up. Meshes of one family have the same numbering. */

import { page } from "../words/language";
import type { Solid, Vector } from "./solid";
import { cross, dot } from "./solid";

type Mesh = Pick<Solid, "positions" | "indices">;
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

/** Rounds of cutting each triangle in four: 20·4⁴ = 5120. */
const ROUNDS = 4;

/** The unit sphere: an icosahedron, its triangles cut in four again and again. */
function icosphere(): Mesh {
  const golden = (1 + Math.sqrt(5)) / 2;
  const points: Vector[] = [-1, 1].flatMap((a) =>
    [-golden, golden].flatMap((b): Vector[] => [unit([0, a, b]), unit([a, b, 0]), unit([b, 0, a])]),
  );
  // Its edges are the shortest distances; each triple of neighbours is a triangle.
  const near = (a: Vector, b: Vector) => dot(a, b) > 0.4;
  let triangles: [number, number, number][] = [];
  for (let i = 0; i < 12; i += 1)
    for (let j = i + 1; j < 12; j += 1)
      for (let k = j + 1; k < 12; k += 1) {
        const [p, q, r] = [points[i], points[j], points[k]];
        if (!(near(p, q) && near(q, r) && near(r, p))) continue;
        triangles.push(dot(p, cross(q, r)) > 0 ? [i, j, k] : [i, k, j]);
      }
  for (let round = 0; round < ROUNDS; round += 1) {
    const middles = new Map<number, number>();
    const middle = (a: number, b: number) => {
      const key = Math.min(a, b) * 65536 + Math.max(a, b);
      const known = middles.get(key);
      if (known !== undefined) return known;
      const [p, q] = [points[a], points[b]];
      middles.set(key, points.push(unit([p[0] + q[0], p[1] + q[1], p[2] + q[2]])) - 1);
      return points.length - 1;
    };
    triangles = triangles.flatMap(([a, b, c]): [number, number, number][] => {
      const [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
      return [
        [a, ab, ca],
        [ab, b, bc],
        [ca, bc, c],
        [ab, bc, ca],
      ];
    });
  }
  return { positions: Float64Array.from(points.flat()), indices: Uint32Array.from(triangles.flat()) };
}

const SPHERE = icosphere();

/** The surface at these distances from the middle. */
function graph(radius: (direction: Vector) => number): Mesh {
  return moved(SPHERE, (direction) => scaled(direction, radius(direction)));
}

function moved({ positions, indices }: Mesh, move: (point: Vector) => Vector): Mesh {
  const out = new Float64Array(positions.length);
  for (let k = 0; k < positions.length; k += 3) out.set(move([positions[k], positions[k + 1], positions[k + 2]]), k);
  return { positions: out, indices };
}

/** Where Σ √(x² + ε²), the l¹ norm with its edges rounded, has one value. */
function octahedron(direction: Vector): number {
  const [size, rounding] = [0.3, 0.035];
  const value = (r: number) => direction.reduce((sum, x) => sum + Math.hypot(r * x, rounding), 0);
  let [inside, outside] = [0, 0.5];
  const aim = size + 2 * rounding;
  for (let round = 0; round < 50; round += 1) {
    const middle = (inside + outside) / 2;
    if (value(middle) < aim) inside = middle;
    else outside = middle;
  }
  return inside;
}

/** Distance to the unit ball of the l^p norm. */
function norm(direction: Vector, p: number): number {
  return direction.reduce((sum, x) => sum + Math.abs(x) ** p, 0) ** (-1 / p);
}

function bumps([x, y, z]: Vector): number {
  return 0.23 * (1 + 0.16 * Math.sin(5 * x + 1) * Math.cos(4 * y) + 0.12 * Math.sin(4 * z - 2 * x) + 0.08 * y);
}

/** J. Gielis's superformula about the vertical axis, five-fold, with a gentle profile. */
function supershape([x, y, z]: Vector): number {
  const angle = Math.atan2(z, x);
  const across = Math.hypot(x, z);
  const formula = (Math.abs(Math.cos(1.25 * angle)) ** 5 + Math.abs(Math.sin(1.25 * angle)) ** 5) ** (-1 / 5);
  const star = (formula - 1) * across ** 2;
  return 0.23 * (1 + 0.9 * star) * (1 - 0.12 * y * y);
}

const RINGS = 72;
const CORNERS = 36;

const torus: Mesh = (() => {
  const [large, small] = [0.2, 0.085];
  const positions: number[] = [];
  const indices: number[] = [];
  for (let i = 0; i < RINGS; i += 1)
    for (let j = 0; j < CORNERS; j += 1) {
      const [u, v] = [(2 * Math.PI * i) / RINGS, (2 * Math.PI * j) / CORNERS];
      const r = large + small * Math.cos(v);
      positions.push(r * Math.sin(u), small * Math.sin(v), r * Math.cos(u));
      const [next, beside] = [(i + 1) % RINGS, (j + 1) % CORNERS];
      const [a, b] = [i * CORNERS + j, next * CORNERS + j];
      const [c, d] = [i * CORNERS + beside, next * CORNERS + beside];
      indices.push(a, b, c, b, d, c);
    }
  return { positions: Float64Array.from(positions), indices: Uint32Array.from(indices) };
})();

/** A bar along x whose sections are rounded squares, thicker at one end: every twist can be seen. */
const bar: Mesh = graph((d) => {
  const [x, y, z] = [d[0] / 0.3, d[1] / 0.13, d[2] / 0.13];
  return (Math.abs(x) ** 4 + Math.abs(y) ** 4 + Math.abs(z) ** 4) ** -0.25 * (1 + 0.15 * d[0]);
});

/** Bent in the plane of x and y, along an arc. */
function bent([x, y, z]: Vector): Vector {
  const radius = 0.35;
  const angle = x / radius;
  return [(radius + y) * Math.sin(angle), (radius + y) * Math.cos(angle) - radius + 0.08, z];
}

/**
 * Turned round the x axis: an unduloid, the surface of revolution of constant mean curvature ½, whose radius swings
 * (K. Kenmotsu, "Surfaces of revolution with prescribed mean curvature", 1980), closed by spherical caps that are
 * tangent to it. The shift is in periods.
 */
function unduloid(shift: number): Mesh {
  const [swing, periods, steps] = [0.35, 1.1, 60];
  const root = (t: number) => Math.sqrt(1 + swing ** 2 + 2 * swing * Math.sin(t));
  const begin = Math.PI / 2 - Math.PI * periods + 2 * Math.PI * shift;
  const points: [along: number, radius: number, slope: number][] = [];
  let along = 0;
  const end = 2 * Math.PI * periods;
  for (let i = 0; i <= steps; i += 1) {
    const t = begin + (end * i) / steps;
    points.push([along, root(t), Math.asin((swing * Math.cos(t)) / root(t))]);
    // The middle of fine steps of ∫ (1 + B sin t) / √… dt.
    for (let fine = 0; fine < 20; fine += 1) {
      const s = t + (end * (fine + 0.5)) / (20 * steps);
      along += ((1 + swing * Math.sin(s)) / root(s)) * (end / (20 * steps));
    }
  }
  const cap = ([x, r, slope]: [number, number, number], side: -1 | 1): [number, number][] => {
    const radius = r / Math.cos(slope);
    const middle = x + r * Math.tan(slope);
    const open = Math.PI / 2 + side * slope;
    return Array.from({ length: 16 }, (_, i) => {
      const angle = (open * (i + (side < 0 ? 0 : 1))) / 16;
      const turn = side < 0 ? angle : open - angle;
      return [middle + side * radius * Math.cos(turn), radius * Math.sin(turn)];
    });
  };
  const profile = [
    ...cap(points[0], -1),
    ...points.map(([x, r]): [number, number] => [x, r]),
    ...cap(points[steps], 1),
  ];
  const half = points[steps][0] / 2;
  const scale = 0.62 / (2 * half + 2.4);
  return revolved(profile.map(([x, r]) => [scale * (x - half), scale * r]));
}

/** Round the x axis. The profile begins and ends on it. */
function revolved(profile: readonly (readonly [x: number, radius: number])[]): Mesh {
  const corners = 48;
  const last = profile.length - 1;
  const positions: number[] = [profile[0][0], 0, 0];
  for (const [x, r] of profile.slice(1, last))
    for (let j = 0; j < corners; j += 1) {
      const angle = (2 * Math.PI * j) / corners;
      positions.push(x, r * Math.cos(angle), r * Math.sin(angle));
    }
  positions.push(profile[last][0], 0, 0);
  const pole = positions.length / 3 - 1;
  const indices: number[] = [];
  for (let i = 0; i < last; i += 1)
    for (let j = 0; j < corners; j += 1) {
      const [a, b] = [j, (j + 1) % corners].map((corner) => 1 + (i - 1) * corners + corner);
      const [c, d] = [a + corners, b + corners];
      if (i === 0) indices.push(0, d, c);
      else if (i === last - 1) indices.push(a, b, pole);
      else indices.push(a, b, c, b, d, c);
    }
  return { positions: Float64Array.from(positions), indices: Uint32Array.from(indices) };
}

/** About the vertical axis. */
function turned(angle: number): (point: Vector) => Vector {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return ([x, y, z]) => [cos * x + sin * z, y, cos * z - sin * x];
}

/** A point turned about the x axis. */
function around(x: number, y: number, z: number, angle: number): Vector {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return [x, cos * y - sin * z, sin * y + cos * z];
}

function unit(v: Vector): Vector {
  return scaled(v, 1 / Math.hypot(...v));
}

function scaled([x, y, z]: Vector, factor: number): Vector {
  return [factor * x, factor * y, factor * z];
}
