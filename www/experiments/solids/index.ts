/** All experiments with surfaces, in the order of the paper. */

import type { SolidExperiment } from "../experiment";
import { levelsExperiment } from "./levels";
import { pairsExperiment } from "./pairs";
import { spheresExperiment } from "./spheres";
import { truthExperiment } from "./truth";
import { turnExperiment } from "./turn";
import { unduloidExperiment } from "./unduloid";

export const SOLID_EXPERIMENTS: readonly SolidExperiment[] = [
  spheresExperiment,
  turnExperiment,
  unduloidExperiment,
  levelsExperiment,
  pairsExperiment,
  truthExperiment,
];
