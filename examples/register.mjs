// Registers two polygons in Node and prints the report: `npm run example`.
//
// The package in www/wasm is the one that the page uses; Node only has to hand over the module's bytes itself.

import { readFileSync } from "node:fs";
import { initSync, Registration } from "../www/wasm/thinshell.js";

initSync({ module: readFileSync(new URL("../www/wasm/thinshell_bg.wasm", import.meta.url)) });

/**
 * A closed polygon around the middle of the box [0,1]², as x y x y …; its last point is joined to the first.
 *
 * @param {number} corners
 * @param {(angle: number) => [number, number]} offset from the middle
 */
function polygon(corners, offset) {
  const points = new Float64Array(2 * corners);
  for (let i = 0; i < corners; i++) {
    const [x, y] = offset((2 * Math.PI * i) / corners);
    points.set([0.5 + x, 0.5 + y], 2 * i);
  }
  return points;
}

// The circle is deformed into the ellipse.
const circle = polygon(200, (angle) => [0.2 * Math.cos(angle), 0.2 * Math.sin(angle)]);
const ellipse = polygon(200, (angle) => [0.3 * Math.cos(angle), 0.15 * Math.sin(angle)]);

// Every setting is optional. Levels are powers of two: 4 to 6 are grids of 17² to 65² nodes.
const registration = await Registration.create(
  { kind: "curves", loops: [circle] },
  { kind: "curves", loops: [ellipse] },
  { coarsest: 4, finest: 6 },
);

let status = await registration.step(1);
let level = status.level;
while (!status.finished) {
  // A few iterations at a time: between two calls one may draw, pause, or give up by not calling again.
  status = await registration.step(20);
  if (status.level !== level) console.log(`level ${level} done`);
  level = status.level;
}

console.log(status.stop);
console.table(status.energies);
console.log(
  `|d₂∘φ| along the circle: ${status.mismatch.mean.toFixed(4)} cells on average, ${status.mismatch.max.toFixed(4)} at most`,
);
console.log(`stretch along the circle: ${status.stretch.mean.toFixed(4)} ± ${status.stretch.deviation.toFixed(4)}`);
console.log(`least determinant: ${status.leastDeterminant.toFixed(4)} (positive: nothing is folded)`);

// Where single points go; `deformation()` gives φ at all nodes, `curves()` the matched polylines.
const [x, y] = registration.map(new Float64Array([0.7, 0.5]));
console.log(`the circle's rightmost point (0.7, 0.5) goes to (${x?.toFixed(4)}, ${y?.toFixed(4)})`);

// The solver's memory is not Node's: it is released by hand.
registration.free();
