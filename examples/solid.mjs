// Registers two triangle meshes in Node and prints the report: `npm run example:solid`.
//
// The package in www/wasm-solid has the names of the one in www/wasm, and surfaces besides curves.

import { readFileSync } from "node:fs";
import { initSync, Registration } from "../www/wasm-solid/thinshell.js";

initSync({ module: readFileSync(new URL("../www/wasm-solid/thinshell_bg.wasm", import.meta.url)) });

/**
 * A closed mesh around the middle of the box [0,1]³: rings of vertices between two poles.
 *
 * @param {(polar: number, azimuth: number) => number} radius
 */
function mesh(radius, rings = 40, corners = 80) {
  const positions = [0.5, 0.5, 0.5 + radius(0, 0)];
  for (let ring = 1; ring < rings; ring++)
    for (let corner = 0; corner < corners; corner++) {
      const [polar, azimuth] = [(Math.PI * ring) / rings, (2 * Math.PI * corner) / corners];
      const [r, across] = [radius(polar, azimuth), Math.sin(polar)];
      positions.push(0.5 + r * across * Math.cos(azimuth), 0.5 + r * across * Math.sin(azimuth));
      positions.push(0.5 + r * Math.cos(polar));
    }
  positions.push(0.5, 0.5, 0.5 - radius(Math.PI, 0));

  const last = positions.length / 3 - 1;
  /** @param {number} ring @param {number} corner */
  const at = (ring, corner) => {
    if (ring === 0) return 0;
    return ring === rings ? last : 1 + (ring - 1) * corners + (corner % corners);
  };
  const indices = [];
  for (let ring = 0; ring < rings; ring++)
    for (let corner = 0; corner < corners; corner++) {
      const [a, b] = [at(ring, corner), at(ring, corner + 1)];
      const [c, d] = [at(ring + 1, corner), at(ring + 1, corner + 1)];
      if (ring > 0) indices.push(a, c, b);
      if (ring + 1 < rings) indices.push(b, c, d);
    }
  return { positions: Float64Array.from(positions), indices: Uint32Array.from(indices) };
}

// The sphere is deformed into a shape with four bulges. Levels 4 and 5 are grids of 17³ and 33³ nodes.
const registration = await Registration.create(
  { kind: "mesh", ...mesh(() => 0.22) },
  { kind: "mesh", ...mesh((polar, azimuth) => 0.22 * (1 + 0.15 * Math.sin(polar) ** 2 * Math.cos(4 * azimuth))) },
  { coarsest: 4, finest: 5 },
);

let status = await registration.step(5);
while (!status.finished) status = await registration.step(5);

console.log(status.stop);
console.log(status.verdict);
console.table(status.energies);
console.log(`areas grow by ${status.stretch.mean.toFixed(4)} ± ${status.stretch.deviation.toFixed(4)}`);
console.log(`det Dφ is nowhere less than ${status.leastDeterminant.toFixed(4)} (a certified bound: nothing is folded)`);

// The matched surface is the reference's, moved: equal indices, so that colours and values carry over.
const { reference, matched } = registration.surfaces();
console.log(`${reference.positions.length / 3} vertices and ${matched.indices.length / 3} triangles to be drawn`);

// The solver's memory is not Node's: it is released by hand.
registration.free();
