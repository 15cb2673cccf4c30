/** What is taken away of a match: the moved surface with its numbers, or everything. */

import { colours } from "./colours";
import { mapsOf } from "./scenes";
import type { Result, Step } from "./session";

/** x y z are φ of the reference's vertex; then the vertex itself, what is measured there, and its partner's number. */
export function ply(result: Result): string {
  const { reference, frame } = result;
  const { area, distance, partners } = mapsOf(result);
  const painted = colours(reference.positions);
  const count = reference.positions.length / 3;
  const triangles = reference.indices.length / 3;
  const lines = [
    "ply",
    "format ascii 1.0",
    "comment thinshell: the reference, moved onto the target; lengths in units of the box",
    `comment distance in cells of the ${2 ** frame.status.level + 1}^3 grid; partner: the target's nearest vertex, from 0`,
    `element vertex ${count}`,
    ...["x", "y", "z", "reference_x", "reference_y", "reference_z"].map((name) => `property double ${name}`),
    ...["area_ratio", "distance"].map((name) => `property double ${name}`),
    "property uint partner",
    ...["red", "green", "blue"].map((name) => `property uchar ${name}`),
    `element face ${triangles}`,
    "property list uchar uint vertex_indices",
    "end_header",
  ];
  for (let i = 0; i < count; i += 1) {
    const [moved, at] = [frame.matched, reference.positions].map((list) => Array.from(list.subarray(3 * i, 3 * i + 3)));
    const shade = Array.from(painted.subarray(3 * i, 3 * i + 3), (channel) => Math.round(255 * channel));
    lines.push([...moved, ...at, area[i], distance[i], partners[i], ...shade].join(" "));
  }
  for (let k = 0; k < 3 * triangles; k += 3) lines.push(`3 ${reference.indices.slice(k, k + 3).join(" ")}`);
  return `${lines.join("\n")}\n`;
}

/** Surfaces, pins, settings and, of a match, φ at the nodes: x y z a node, x fastest. */
export function json(step: Step, result: Result | null): string {
  const { reference, template, pins, settings } = result ?? step;
  const solid = ({ name, positions, indices }: Step["reference"]) => ({
    name,
    positions: Array.from(positions),
    indices: Array.from(indices),
  });
  const match = result && {
    status: result.frame.status,
    deformation: Array.from(result.frame.deformation),
    matched: Array.from(result.frame.matched),
  };
  return JSON.stringify({
    format: "thinshell-surfaces",
    version: 1,
    reference: solid(reference),
    template: solid(template),
    pins,
    settings,
    match,
  });
}
