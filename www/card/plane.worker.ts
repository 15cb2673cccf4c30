/** The solver's thread for curves where a graphics card may compute. */

import { plane } from "../plane";
import { pump } from "../pump";
import init, { inspect, Registration } from "../wasm-gpu/thinshell.js";

pump(plane({ default: init, inspect, Registration }));
