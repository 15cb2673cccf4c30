/** The solver's thread for curves. The only importer of the first wasm package. */

import { plane } from "./plane";
import { pump } from "./pump";
import init, { inspect, Registration } from "./wasm/thinshell.js";

pump(plane({ default: init, inspect, Registration }));
