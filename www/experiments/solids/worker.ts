/** Runs an experiment with surfaces. */

import init, { Registration } from "../../wasm-solid/thinshell.js";
import { serve } from "../serve";
import { SOLID_EXPERIMENTS } from "./index";

serve(SOLID_EXPERIMENTS, { init, solver: Registration });
