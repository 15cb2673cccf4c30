/** Runs an experiment with curves. */

import init, { Registration } from "../wasm/thinshell.js";
import { EXPERIMENTS } from "./index";
import { serve } from "./serve";

serve(EXPERIMENTS, { init, solver: Registration });
