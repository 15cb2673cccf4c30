/** What there is to see of a registration of surfaces, whichever package solves. */

import type { Shape } from "../protocol";
import type { Kit } from "../pump";

export function solids(solver: Kit<object>["solver"]) {
  return {
    solver,
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
  } satisfies Kit<object>;
}

function vertices(shape: Shape): Float64Array {
  if (shape.kind !== "mesh") throw new Error("the page matches surfaces as meshes");
  return shape.positions;
}
