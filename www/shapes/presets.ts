/**
 * Pairs to start with, all from formulas. Curves are smooth on the scale of a 129² grid, run counter-clockwise (holes
 * clockwise) and keep 0.15 of the box's side from its border.
 */

import { page } from "../words/language";
import {
  about,
  averaged,
  type Loop,
  type Point,
  resampled,
  reversed,
  SAMPLES,
  type Shape,
  transformed,
} from "./geometry";

export type Preset = {
  /** Stands in links; never changes. */
  readonly id: string;
  readonly title: string;
  readonly reference: Shape;
  readonly template: Shape;
};

const CENTRE: Point = { x: 0.5, y: 0.5 };
const DEGREE = Math.PI / 180;

/** Samples t ↦ point over one turn, t from 0 to 2π, then evens out the spacing. */
function closed(curve: (t: number) => Point, count = SAMPLES): Loop {
  const dense = 4 * count;
  const loop = new Float64Array(2 * dense);
  for (let i = 0; i < dense; i += 1) {
    const { x, y } = curve((2 * Math.PI * i) / dense);
    loop[2 * i] = x;
    loop[2 * i + 1] = y;
  }
  return resampled(loop, count);
}

function ellipse(a: number, b: number, centre = CENTRE): Loop {
  return closed((t) => ({ x: centre.x + a * Math.cos(t), y: centre.y + b * Math.sin(t) }));
}

/** r(t) about a centre. */
function polar(radius: (t: number) => number, centre = CENTRE): Loop {
  return closed((t) => ({ x: centre.x + radius(t) * Math.cos(t), y: centre.y + radius(t) * Math.sin(t) }));
}

/** Rounds what is sharper than some √passes / 2 samples. */
function softened(loop: Loop, passes: number): Loop {
  let current = loop;
  for (let pass = 0; pass < passes; pass += 1) current = averaged(current, 0.5);
  return resampled(current, SAMPLES);
}

/** A bump of height 1 at the angle `at`, `width` wide; angles in degrees, counter-clockwise from the right. */
function bump(t: number, at: number, width: number): number {
  const off = t - at * DEGREE;
  const wrapped = Math.atan2(Math.sin(off), Math.cos(off)) / (width * DEGREE);
  return Math.exp(-(wrapped ** 2));
}

/** A square of half side `half` whose corners are circular arcs. */
function roundedSquare(half: number, corner: number): Loop {
  const flat = half - corner;
  const points: number[] = [];
  for (let quarter = 0; quarter < 4; quarter += 1) {
    const start = (quarter * Math.PI) / 2;
    const cx = quarter === 0 || quarter === 3 ? flat : -flat;
    const cy = quarter < 2 ? flat : -flat;
    for (let k = 0; k <= 40; k += 1) {
      const t = start + (k * Math.PI) / 80;
      points.push(0.5 + cx + corner * Math.cos(t), 0.5 + cy + corner * Math.sin(t));
    }
  }
  return resampled(Float64Array.from(points), SAMPLES);
}

/**
 * The outline of a pen of half width `width(s)` led along `path(s)`, s from 0 to 1, with round ends. The path may not
 * bend more sharply than the pen is wide.
 */
function ribbon(path: (s: number) => Point, width: (s: number) => number): Loop {
  const steps = 240;
  const caps = 40;
  const along = (s: number) => {
    const a = path(Math.max(0, s - 1e-4));
    const b = path(Math.min(1, s + 1e-4));
    return Math.atan2(b.y - a.y, b.x - a.x);
  };
  const points: number[] = [];
  const put = (s: number, angle: number) => {
    const { x, y } = path(s);
    points.push(x + width(s) * Math.cos(angle), y + width(s) * Math.sin(angle));
  };
  for (let k = 0; k <= steps; k += 1) put(k / steps, along(k / steps) - Math.PI / 2);
  for (let k = 1; k < caps; k += 1) put(1, along(1) - Math.PI / 2 + (k * Math.PI) / caps);
  for (let k = steps; k >= 0; k -= 1) put(k / steps, along(k / steps) + Math.PI / 2);
  for (let k = 1; k < caps; k += 1) put(0, along(0) + Math.PI / 2 + (k * Math.PI) / caps);
  return resampled(Float64Array.from(points), SAMPLES);
}

/** Straight from a towards b, round the corner b with the given radius, straight on to c (a right angle). */
function elbow(a: Point, b: Point, c: Point, radius: number): (s: number) => Point {
  const first = Math.hypot(b.x - a.x, b.y - a.y) - radius;
  const second = Math.hypot(c.x - b.x, c.y - b.y) - radius;
  const arc = (radius * Math.PI) / 2;
  const u = { x: (b.x - a.x) / (first + radius), y: (b.y - a.y) / (first + radius) };
  const v = { x: (c.x - b.x) / (second + radius), y: (c.y - b.y) / (second + radius) };
  return (s) => {
    const travelled = s * (first + arc + second);
    if (travelled < first) return { x: a.x + travelled * u.x, y: a.y + travelled * u.y };
    if (travelled > first + arc) {
      const rest = radius + travelled - first - arc;
      return { x: b.x + rest * v.x, y: b.y + rest * v.y };
    }
    const angle = (travelled - first) / radius;
    const back = radius * (1 - Math.sin(angle));
    const on = radius * (1 - Math.cos(angle));
    return { x: b.x - back * u.x + on * v.x, y: b.y - back * u.y + on * v.y };
  };
}

/** An arc from one angle to another, degrees. */
function arc(radius: number, from: number, to: number, centre = CENTRE): (s: number) => Point {
  return (s) => {
    const t = (from + s * (to - from)) * DEGREE;
    return { x: centre.x + radius * Math.cos(t), y: centre.y + radius * Math.sin(t) };
  };
}

function turned(shape: Shape, degrees: number): Shape {
  return transformed(shape, about(CENTRE, 1, degrees * DEGREE));
}

function star(points: number, radius: number, depth: number): Loop {
  return polar((t) => radius * (1 + depth * Math.cos(points * (t - Math.PI / 2))));
}

/** Pointed at the right end, full at the left; `bend` curves its axis. */
function leaf(bend: number, lobes: number): Loop {
  return closed((t) => {
    const x = 0.29 * Math.cos(t);
    const y = 0.15 * Math.sin(t) * (1 - 0.5 * Math.cos(t)) * (1 + lobes * Math.cos(5 * t));
    return { x: 0.5 + x, y: 0.5 + y + bend * (x * x - 0.03) };
  });
}

function heart(): Loop {
  const pointed = closed((t) => ({
    x: 0.5 - 0.0165 * 16 * Math.sin(t) ** 3,
    y: 0.52 + 0.0165 * (13 * Math.cos(t) - 5 * Math.cos(2 * t) - 2 * Math.cos(3 * t) - Math.cos(4 * t)),
  }));
  // The formula has two cusps, which no grid resolves.
  return softened(pointed, 120);
}

/** A smooth closed curve through the points (Catmull–Rom), counter-clockwise when they are. */
function through(points: readonly Point[]): Loop {
  const count = points.length;
  return closed((t) => {
    const place = (t / (2 * Math.PI)) * count;
    const i = Math.floor(place) % count;
    const s = place - Math.floor(place);
    const [p, q, r, u] = [-1, 0, 1, 2].map((k) => points[(i + k + count) % count]);
    const blend = (a: number, b: number, c: number, d: number) =>
      b + (s / 2) * (c - a + s * (2 * a - 5 * b + 4 * c - d + s * (3 * (b - c) + d - a)));
    return { x: blend(p.x, q.x, r.x, u.x), y: blend(p.y, q.y, r.y, u.y) };
  });
}

/** Half the outline of a fish, from the notch of its tail to its nose: along the axis, off the axis. */
const FISH_BACK: readonly (readonly [number, number])[] = [
  [0.262, 0],
  [0.275, 0.055],
  [0.262, 0.105],
  [0.21, 0.1],
  [0.15, 0.05],
  [0.05, 0.085],
  [-0.08, 0.115],
  [-0.2, 0.085],
  [-0.275, 0.03],
];

/** `sway` bends the axis into a wave. */
function fish(sway: number): Loop {
  const upper = FISH_BACK.map(([x, y]) => ({ x, y }));
  const lower = upper
    .slice(1)
    .reverse()
    .map(({ x, y }) => ({ x, y: -y }));
  const swaying = [...upper, ...lower].map(({ x, y }) => ({
    x: 0.5 + x,
    y: 0.5 + y + sway * Math.sin(7 * (x + 0.15)) * (x + 0.5),
  }));
  return softened(through(swaying), 16);
}

/** A palm with fingers at the given angles, degrees. */
function hand(angles: readonly number[], length: number): Loop {
  const palm = { x: 0.5, y: 0.43 };
  const half = 0.036;
  const fingers = angles.flatMap((angle) => {
    const u = { x: Math.cos(angle * DEGREE), y: Math.sin(angle * DEGREE) };
    const at = (along: number, left: number) => ({
      x: palm.x + along * u.x - left * u.y,
      y: palm.y + along * u.y + left * u.x,
    });
    return [
      at(0.15, -half - 0.006),
      at(0.15 + length, -half),
      at(0.15 + length + half, 0),
      at(0.15 + length, half),
      at(0.15, half + 0.006),
    ];
  });
  const wrist = [225, 270, 315].map((angle) => ({
    x: palm.x + 0.15 * Math.cos(angle * DEGREE),
    y: palm.y + 0.16 * Math.sin(angle * DEGREE),
  }));
  return softened(through([...fingers, ...wrist]), 22);
}

function rabbit(): Loop {
  return polar((t) => 0.165 + 0.18 * (bump(t, 61, 17) + bump(t, 119, 17)), { x: 0.5, y: 0.44 });
}

/** Half a cat's head, from the crown over the ear and the cheek to the chin: off the axis, and up from the middle. */
const CAT = [
  [0, 0.125],
  [0.045, 0.126],
  [0.08, 0.155],
  [0.11, 0.195],
  [0.132, 0.23],
  [0.152, 0.244],
  [0.17, 0.228],
  [0.178, 0.185],
  [0.186, 0.115],
  [0.196, 0.04],
  [0.198, -0.03],
  [0.165, -0.085],
  [0.1, -0.13],
  [0, -0.15],
] as const;

function cat(): Loop {
  const half = CAT.map(([x, y]) => ({ x, y }));
  const left = half.map(({ x, y }) => ({ x: 0.5 - x, y: 0.46 + y }));
  const right = half
    .slice(1, -1)
    .reverse()
    .map(({ x, y }) => ({ x: 0.5 + x, y: 0.46 + y }));
  return softened(through([...left, ...right]), 20);
}

/** Drawn when first looked at: the page opens with one pair and waits for no other. */
function pair(id: string, title: string, draw: () => readonly [reference: Shape, template: Shape]): Preset {
  let drawn: readonly [Shape, Shape] | null = null;
  const shape = (side: 0 | 1) => {
    drawn ??= draw();
    return drawn[side];
  };
  return {
    id,
    title,
    get reference() {
      return shape(0);
    },
    get template() {
      return shape(1);
    },
  };
}

/** A shape, and itself turned. */
function andTurned(shape: Shape, degrees: number): readonly [Shape, Shape] {
  return [shape, turned(shape, degrees)];
}

export const PRESETS: readonly Preset[] = [
  pair("ellipse", "Circle → ellipse", () => [[ellipse(0.15, 0.15)], [ellipse(0.31, 0.17)]]),
  pair("star", "Star → turned star", () => andTurned([star(5, 0.21, 0.24)], 24)),
  pair("square", "Rounded square → turned by 30°", () => andTurned([roundedSquare(0.2, 0.12)], 30)),
  pair("blobs", "Two blobs", () => [
    [polar((t) => 0.21 * (1 + 0.16 * Math.cos(2 * t + 0.6) + 0.12 * Math.sin(3 * t)))],
    [polar((t) => 0.22 * (1 + 0.2 * Math.cos(2 * t + 1.5) + 0.1 * Math.cos(4 * t)))],
  ]),
  pair("leaf", "Leaf → lobed leaf", () => [[leaf(0, 0)], [softened(leaf(1.4, 0.11), 45)]]),
  pair("letters", "L → C", () => [
    [ribbon(elbow({ x: 0.36, y: 0.72 }, { x: 0.36, y: 0.3 }, { x: 0.68, y: 0.3 }, 0.11), () => 0.06)],
    [ribbon(arc(0.2, 80, 290, { x: 0.52, y: 0.5 }), () => 0.06)],
  ]),
  pair("clover", "Long clover → short circle", () => [[star(4, 0.22, 0.2)], [ellipse(0.22, 0.22)]]),
  pair("ring", "Ring → shifted ring", () => [
    [ellipse(0.25, 0.25), reversed(ellipse(0.11, 0.11))],
    [ellipse(0.31, 0.22), reversed(ellipse(0.09, 0.11, { x: 0.59, y: 0.5 }))],
  ]),
  pair("fish", "Fish → swimming fish", () => [[fish(0)], [fish(0.09)]]),
  pair("hand", "Hand → spread hand", () => [[hand([2, 52, 96, 140], 0.07)], [hand([-18, 44, 96, 148], 0.13)]]),
  pair("ears", "Cat → rabbit", () => [[cat()], [rabbit()]]),
  pair("heart", "Heart → drop", () => [
    [heart()],
    [
      closed((t) => ({
        x: 0.5 + 0.2 * Math.cos(t) * (1 - 0.45 * Math.sin(t)),
        y: 0.5 + 0.27 * Math.sin(t),
      })),
    ],
  ]),
  pair("pairs", "Two parts → two parts", () => [
    [ellipse(0.1, 0.16, { x: 0.33, y: 0.5 }), ellipse(0.1, 0.16, { x: 0.67, y: 0.5 })],
    [ellipse(0.14, 0.1, { x: 0.33, y: 0.42 }), ellipse(0.11, 0.17, { x: 0.68, y: 0.56 })],
  ]),
  pair("moon", "Bean → crescent", () => [
    [ribbon(arc(0.22, 220, 320, { x: 0.5, y: 0.66 }), () => 0.085)],
    [ribbon(arc(0.2, 195, 345, { x: 0.5, y: 0.58 }), (s) => 0.045 + 0.035 * Math.sin(Math.PI * s))],
  ]),
];

page("presets", Object.fromEntries(PRESETS.map((preset) => [preset.id, preset])));
