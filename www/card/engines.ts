/** The solver that can compute on a graphics card, for curves and for surfaces. Comes on demand. */

import { type Engine, moduleAt } from "../engine";
import solverUrl from "../wasm-gpu/thinshell_bg.wasm?url";
import PlaneWorker from "./plane.worker?worker&inline";
import SolidWorker from "./solid.worker?worker&inline";

const module = moduleAt(solverUrl);

export const engines: Readonly<Record<"plane" | "space", Engine>> = {
  plane: { module, spawn: () => new PlaneWorker({ name: "thinshell solver, graphics card" }) },
  space: { module, spawn: () => new SolidWorker({ name: "thinshell solver of surfaces, graphics card" }) },
};
