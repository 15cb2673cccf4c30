/** Where the box is looked at from: the same for every view. No DOM. */

import { space as say } from "../words/space";
import { cross, dot, minus, unit, type Vector } from "./solid";

export type Pose = {
  /** Radians to the right of the front, and above it. */
  readonly azimuth: number;
  readonly elevation: number;
  readonly zoom: number;
  /** Of the point looked at, in box lengths to the right and up in the picture. */
  readonly right: number;
  readonly up: number;
};

export const START: Pose = { azimuth: 0.6, elevation: 0.4, zoom: 1, right: 0, up: 0 };

const STEEPEST = Math.PI / 2 - 0.01;
const FARTHEST = 0.5;
const CLOSEST = 8;
const WIDEST_PAN = 0.5;

/** Distance of the eye at zoom 1: the ball around the surfaces fills the picture at `FIELD_OF_VIEW`. */
const DISTANCE = 2;
/** Degrees. */
export const FIELD_OF_VIEW = 26;

export function orbited(pose: Pose, azimuth: number, elevation: number): Pose {
  // Kept within a turn, so that a link is short and what is said is true.
  const whole = Math.atan2(Math.sin(pose.azimuth + azimuth), Math.cos(pose.azimuth + azimuth));
  return { ...pose, azimuth: whole, elevation: clamped(pose.elevation + elevation, STEEPEST) };
}

export function zoomed(pose: Pose, factor: number): Pose {
  return { ...pose, zoom: Math.min(CLOSEST, Math.max(FARTHEST, pose.zoom * factor)) };
}

/** By parts of the picture. */
export function panned(pose: Pose, right: number, up: number): Pose {
  const { zoom } = pose;
  return {
    ...pose,
    right: clamped(pose.right - right / zoom, WIDEST_PAN),
    up: clamped(pose.up - up / zoom, WIDEST_PAN),
  };
}

function clamped(value: number, most: number): number {
  return Math.min(most, Math.max(-most, value));
}

/** The eye, and the point that it looks at, in the box. */
export function sight({ azimuth, elevation, zoom, right, up }: Pose): { readonly eye: Vector; readonly aim: Vector } {
  const [sinA, cosA, sinE, cosE] = [azimuth, elevation].flatMap((angle) => [Math.sin(angle), Math.cos(angle)]);
  const away: Vector = [cosE * sinA, sinE, cosE * cosA];
  const across: Vector = [cosA, 0, -sinA];
  const above: Vector = [-sinE * sinA, cosE, -sinE * cosA];
  const aim = [0, 1, 2].map((k) => 0.5 + right * across[k] + up * above[k]);
  const eye = aim.map((at, k) => at + (DISTANCE / zoom) * away[k]);
  return { eye: eye as unknown as Vector, aim: aim as unknown as Vector };
}

export type Lens = {
  readonly eye: Vector;
  /** Unit vectors: towards the eye, to the right and up in the picture. */
  readonly away: Vector;
  readonly right: Vector;
  readonly up: Vector;
};

/** Half heights of the picture at a depth of one. */
const FOCUS = 1 / Math.tan((FIELD_OF_VIEW * Math.PI) / 360);

export function lensOf(pose: Pose): Lens {
  const { eye, aim } = sight(pose);
  const away = unit(minus(eye, aim));
  const right = unit(cross([0, 1, 0], away));
  return { eye, away, right, up: cross(away, right) };
}

/** Where a point appears, in half heights of the picture from its middle, to the right and up, and how deep it lies. */
export function projected(
  { eye, away, right, up }: Lens,
  point: Vector,
): readonly [x: number, y: number, depth: number] {
  const from = minus(point, eye);
  const depth = -dot(from, away);
  return [(FOCUS * dot(from, right)) / depth, (FOCUS * dot(from, up)) / depth, depth];
}

/** From the eye through a place of the picture, as `projected` names it. */
export function rayThrough({ away, right, up }: Lens, x: number, y: number): Vector {
  const [a, b, c] = [0, 1, 2].map((k) => (x * right[k] + y * up[k]) / FOCUS - away[k]);
  return [a, b, c];
}

/** What a key does to the pose; null where it does nothing. */
export function keyed(pose: Pose, key: string, shift: boolean): Pose | null {
  const turn = Math.PI / 18;
  const directions: Readonly<Record<string, readonly [number, number]>> = {
    ArrowLeft: [-1, 0],
    ArrowRight: [1, 0],
    ArrowUp: [0, 1],
    ArrowDown: [0, -1],
  };
  const direction = directions[key];
  if (direction) {
    const [x, y] = direction;
    return shift ? panned(pose, -0.05 * x, -0.05 * y) : orbited(pose, turn * x, turn * y);
  }
  if (key === "+" || key === "=") return zoomed(pose, 1.2);
  if (key === "-" || key === "_") return zoomed(pose, 1 / 1.2);
  return key === "Home" ? START : null;
}

/** For those who do not see the picture. */
export function spoken({ azimuth, elevation, zoom, right, up }: Pose): string {
  const [across, above] = [azimuth, elevation].map((angle) => Math.round((angle * 180) / Math.PI));
  return say.pose(across, above, zoom, right !== 0 || up !== 0);
}
