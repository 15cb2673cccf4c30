/** The solver's thread for surfaces where a graphics card may compute. */

import { pump } from "../pump";
import { solids } from "../space/solids";
import init, { inspect, Registration } from "../wasm-gpu/thinshell.js";

pump(solids({ default: init, inspect, Registration }));
