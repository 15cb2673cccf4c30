/** The solver's thread for surfaces. The only importer of the package that has them. */

import type { Shape } from "../protocol";
import { pump } from "../pump";
import init, { inspect, Registration } from "../wasm-solid/thinshell.js";

pump({
  solver: { default: init, inspect, Registration },
  picture: (registration, { reference, template }, finished) => {
    const deformation = registration.deformation();
    const matched = registration.map(vertices(reference));
    // Only of what is final: the inverse takes longer than the map.
    const partners = finished ? registration.inverseMap(vertices(template)) : null;
    return [
      { deformation, matched, partners },
      [deformation, matched, ...(partners ? [partners] : [])].map(({ buffer }) => buffer),
    ];
  },
});

function vertices(shape: Shape): Float64Array {
  if (shape.kind !== "mesh") throw new Error("the page matches surfaces as meshes");
  return shape.positions;
}
