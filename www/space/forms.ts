/** Closed meshes made by formulas, around the origin, y up. Those of one kind have the same numbering. */

import { cross, dot, type Solid, unit, type Vector } from "./solid";

export type Mesh = Pick<Solid, "positions" | "indices">;

/** Rounds of cutting each triangle in four: 20·4⁴ = 5120. */
const ROUNDS = 4;

const spheres = new Map<number, Mesh>();

function sphere(rounds: number): Mesh {
  const made = spheres.get(rounds) ?? icosphere(rounds);
  spheres.set(rounds, made);
  return made;
}

/** The unit sphere: an icosahedron, its triangles cut in four again and again. */
function icosphere(rounds: number): Mesh {
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
  for (let round = 0; round < rounds; round += 1) {
    const middles = new Map<number, number>();
    const middle = (a: number, b: number) => {
      const key = Math.min(a, b) * 2 ** 24 + Math.max(a, b);
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

/** The surface at these distances from the middle. */
export function graph(radius: (direction: Vector) => number, rounds = ROUNDS): Mesh {
  return moved(sphere(rounds), (direction) => scaled(direction, radius(direction)));
}

export function moved({ positions, indices }: Mesh, move: (point: Vector) => Vector): Mesh {
  const out = new Float64Array(positions.length);
  for (let k = 0; k < positions.length; k += 3) out.set(move([positions[k], positions[k + 1], positions[k + 2]]), k);
  return { positions: out, indices };
}

/** Where Σ √(x² + ε²), the l¹ norm with its edges rounded, has one value. */
export function octahedron(direction: Vector): number {
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
export function norm(direction: Vector, p: number): number {
  return direction.reduce((sum, x) => sum + Math.abs(x) ** p, 0) ** (-1 / p);
}

export function bumps([x, y, z]: Vector): number {
  return 0.23 * (1 + 0.16 * Math.sin(5 * x + 1) * Math.cos(4 * y) + 0.12 * Math.sin(4 * z - 2 * x) + 0.08 * y);
}

/** J. Gielis's superformula about the vertical axis, five-fold, with a gentle profile. */
export function supershape([x, y, z]: Vector): number {
  const angle = Math.atan2(z, x);
  const across = Math.hypot(x, z);
  const formula = (Math.abs(Math.cos(1.25 * angle)) ** 5 + Math.abs(Math.sin(1.25 * angle)) ** 5) ** (-1 / 5);
  const star = (formula - 1) * across ** 2;
  return 0.23 * (1 + 0.9 * star) * (1 - 0.12 * y * y);
}

const RINGS = 72;
const CORNERS = 36;

export const torus: Mesh = (() => {
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
export const bar: Mesh = graph((d) => {
  const [x, y, z] = [d[0] / 0.3, d[1] / 0.13, d[2] / 0.13];
  return (Math.abs(x) ** 4 + Math.abs(y) ** 4 + Math.abs(z) ** 4) ** -0.25 * (1 + 0.15 * d[0]);
});

/** Bent in the plane of x and y, along an arc. */
export function bent([x, y, z]: Vector): Vector {
  const radius = 0.35;
  const angle = x / radius;
  return [(radius + y) * Math.sin(angle), (radius + y) * Math.cos(angle) - radius + 0.08, z];
}

/** How far the radius swings about 1, its mean over the angle below. */
const SWING = 0.35;
/** What is cut out of an unduloid, and how finely it is made. */
export type Section = {
  /** Between its caps, in periods. */
  readonly periods: number;
  /** Of the lengths in which the mean curvature is ½. */
  readonly scale: number;
  readonly detail: number;
};

const GALLERY: Section = { periods: 1.1, scale: 0.07, detail: 1 };

type Ring = { readonly along: number; readonly radius: number; readonly slope: number };

/**
 * The profile of the unduloid, the surface of revolution of constant mean curvature ½ whose radius swings, over one
 * period and at all others: its place along the axis is an elliptic integral of the angle t.
 *
 * Source: K. Kenmotsu, "Surfaces of revolution with prescribed mean curvature", Tôhoku Math. J. 32, 1980.
 */
const profile = (() => {
  const root = (t: number) => Math.sqrt(1 + SWING ** 2 + 2 * SWING * Math.sin(t));
  const steps = 4096;
  const angle = (2 * Math.PI) / steps;
  // Along the axis at each step from the widest place, by the middle of each.
  const reached = new Float64Array(steps + 1);
  for (let i = 0; i < steps; i += 1) {
    const t = Math.PI / 2 + angle * (i + 0.5);
    reached[i + 1] = reached[i] + (angle * (1 + SWING * Math.sin(t))) / root(t);
  }
  const period = reached[steps];
  const at = (along: number): Ring => {
    const within = along - period * Math.floor(along / period);
    let [low, high] = [0, steps];
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (reached[middle] <= within) low = middle;
      else high = middle;
    }
    const t = Math.PI / 2 + angle * (low + (within - reached[low]) / (reached[low + 1] - reached[low]));
    return { along, radius: root(t), slope: Math.asin((SWING * Math.cos(t)) / root(t)) };
  };
  return { period, at };
})();

/** One period of the unduloid whose mean curvature is ½. */
export const UNDULOID_PERIOD = profile.period;

/**
 * A section of the unduloid round the x axis, closed by spherical caps that are tangent to it. Its widest place lies at
 * `shift` periods from the middle, while the ends stay.
 */
export function unduloid(shift: number, { periods, scale, detail } = GALLERY): Mesh {
  const half = (periods * profile.period) / 2;
  const steps = Math.round(55 * periods) * detail;
  const rings = Array.from({ length: steps + 1 }, (_, i): Ring => {
    const along = -half + (2 * half * i) / steps;
    return { ...profile.at(along - shift * profile.period), along };
  });
  const cap = ({ along, radius: r, slope }: Ring, side: -1 | 1): [number, number][] => {
    const radius = r / Math.cos(slope);
    const middle = along + r * Math.tan(slope);
    const open = Math.PI / 2 + side * slope;
    const count = 16 * detail;
    return Array.from({ length: count }, (_, i) => {
      const angle = (open * (i + (side < 0 ? 0 : 1))) / count;
      const turn = side < 0 ? angle : open - angle;
      return [middle + side * radius * Math.cos(turn), radius * Math.sin(turn)];
    });
  };
  const outline = [
    ...cap(rings[0], -1),
    ...rings.map(({ along, radius }): [number, number] => [along, radius]),
    ...cap(rings[steps], 1),
  ];
  return revolved(
    outline.map(([x, r]) => [scale * x, scale * r]),
    48 * detail,
  );
}

/** Round the x axis. The profile begins and ends on it. */
function revolved(profile: readonly (readonly [x: number, radius: number])[], corners: number): Mesh {
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
export function turned(angle: number): (point: Vector) => Vector {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return ([x, y, z]) => [cos * x + sin * z, y, cos * z - sin * x];
}

/** A point turned about the x axis. */
export function around(x: number, y: number, z: number, angle: number): Vector {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return [x, cos * y - sin * z, sin * y + cos * z];
}

function scaled([x, y, z]: Vector, factor: number): Vector {
  return [factor * x, factor * y, factor * z];
}
