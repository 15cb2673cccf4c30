/** The solver's thread for curves. The only importer of the first wasm package. */

import { pump } from "./pump";
import { kept } from "./trail";
import { identity } from "./view/identity";
import init, { inspect, Registration } from "./wasm/thinshell.js";

pump({
  solver: { default: init, inspect, Registration },
  picture: (registration) => {
    const [deformation, curves] = [registration.deformation(), registration.curves()];
    const loops = [...curves.reference, ...curves.template, ...curves.matched];
    return [{ deformation, curves }, [deformation.buffer, ...loops.map(({ buffer }) => buffer)]];
  },
  kept: (registration, level) => kept(registration.deformation(), level),
  rest: (registration, level) => registration.evaluate(identity(2 ** level)).energies,
});
