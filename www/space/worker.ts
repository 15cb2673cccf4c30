/** The solver's thread for surfaces. The only importer of the package that has them. */

import { pump } from "../pump";
import init, { inspect, Registration } from "../wasm-solid/thinshell.js";
import { solids } from "./solids";

pump(solids({ default: init, inspect, Registration }));
