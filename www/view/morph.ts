/**
 * The way from the identity to a match, so that what turns is seen turning: a straight way for every point would take a
 * turned shape through its own middle.
 *
 * Write φ = G∘ψ with the similarity G(x) = b + e^λ R(θ)(x − a) that fits the reference's way best, a and b the middles
 * before and after. At the part s of the way φ_s = G_s∘((1 − s) id + s ψ), where G_s has angle sθ, scale e^{sλ} and the
 * middle (1 − s) a + s b. φ₀ is the identity and φ₁ = φ. Domain units.
 */

import type { GridMap } from "./field";
import { identity } from "./identity";
import type { Match } from "./result";

export type Way = {
  readonly angle: number;
  /** λ. */
  readonly growth: number;
  readonly from: readonly [number, number];
  readonly to: readonly [number, number];
};

const STRAIGHT: Way = { angle: 0, growth: 0, from: [0.5, 0.5], to: [0.5, 0.5] };

const known = new WeakMap<Float64Array, Way>();

export function wayOf({ deformation, curves }: Pick<Match, "deformation" | "curves">): Way {
  const before = known.get(deformation);
  if (before) return before;
  const way = fitted(curves.reference, curves.matched);
  known.set(deformation, way);
  return way;
}

/** The similarity that takes the loops `from` to `to` best, each point weighted by the length around it. */
export function fitted(from: readonly Float64Array[], to: readonly Float64Array[]): Way {
  let [weight, ax, ay, bx, by] = [0, 0, 0, 0, 0];
  each(from, to, (w, x, y, u, v) => {
    weight += w;
    ax += w * x;
    ay += w * y;
    bx += w * u;
    by += w * v;
  });
  if (!(weight > 0)) return STRAIGHT;
  [ax, ay, bx, by] = [ax / weight, ay / weight, bx / weight, by / weight];
  let [along, across, before, after] = [0, 0, 0, 0];
  each(from, to, (w, x, y, u, v) => {
    const [p, q, r, s] = [x - ax, y - ay, u - bx, v - by];
    along += w * (p * r + q * s);
    across += w * (p * s - q * r);
    before += w * (p * p + q * q);
    after += w * (r * r + s * s);
  });
  if (!(before > 0 && after > 0)) return STRAIGHT;
  return { angle: Math.atan2(across, along), growth: Math.log(after / before) / 2, from: [ax, ay], to: [bx, by] };
}

type Visit = (weight: number, x: number, y: number, u: number, v: number) => void;

function each(from: readonly Float64Array[], to: readonly Float64Array[], visit: Visit): void {
  from.forEach((loop, l) => {
    const n = loop.length;
    for (let i = 0; i < n; i += 2) {
      const [b, a] = [(i + n - 2) % n, (i + 2) % n];
      const length =
        Math.hypot(loop[i] - loop[b], loop[i + 1] - loop[b + 1]) +
        Math.hypot(loop[a] - loop[i], loop[a + 1] - loop[i + 1]);
      visit(length / 2, loop[i], loop[i + 1], to[l][i], to[l][i + 1]);
    }
  });
}

/** φ_s at points, x y x y …, whose images under φ are `to`. */
export function movedAt(way: Way, from: ArrayLike<number>, to: Float64Array, s: number): Float64Array {
  if (s === 1) return to;
  const {
    angle,
    growth,
    from: [ax, ay],
    to: [bx, by],
  } = way;
  // Back by G, then on by G_s.
  const back = Math.exp(-growth);
  const [backCos, backSin] = [back * Math.cos(angle), back * Math.sin(angle)];
  const on = Math.exp(s * growth);
  const [cos, sin] = [on * Math.cos(s * angle), on * Math.sin(s * angle)];
  const [cx, cy] = [(1 - s) * ax + s * bx, (1 - s) * ay + s * by];
  const out = new Float64Array(to.length);
  for (let i = 0; i < out.length; i += 2) {
    const [u, v] = [to[i] - bx, to[i + 1] - by];
    const p = (1 - s) * (from[i] - ax) + s * (backCos * u + backSin * v);
    const q = (1 - s) * (from[i + 1] - ay) + s * (backCos * v - backSin * u);
    out[i] = cx + cos * p - sin * q;
    out[i + 1] = cy + sin * p + cos * q;
  }
  return out;
}

/** The reference's loops at the part s of their way. */
export function movedLoops(match: Pick<Match, "deformation" | "curves">, s: number): Float64Array[] {
  const { reference, matched } = match.curves;
  const way = wayOf(match);
  return matched.map((loop, l) => movedAt(way, reference[l], loop, s));
}

/** φ_s on the match's grid. */
export function movedGrid(match: Match, s: number): GridMap {
  const cells = 2 ** match.level;
  if (s === 1) return { cells, deformation: match.deformation };
  return { cells, deformation: movedAt(wayOf(match), identity(cells), match.deformation, s) };
}
