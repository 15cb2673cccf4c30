/** What there is to see of a registration of curves, whichever package solves. */

import type { Kit } from "./pump";
import { kept } from "./trail";
import { identity } from "./view/identity";

export function plane(solver: Kit<object>["solver"]) {
  return {
    solver,
    picture: (registration) => {
      const [deformation, curves] = [registration.deformation(), registration.curves()];
      const loops = [...curves.reference, ...curves.template, ...curves.matched];
      return [{ deformation, curves }, [deformation.buffer, ...loops.map(({ buffer }) => buffer)]];
    },
    kept: (registration, level) => kept(registration.deformation(), level),
    rest: (registration, level) => registration.evaluate(identity(2 ** level)).energies,
  } satisfies Kit<object>;
}
