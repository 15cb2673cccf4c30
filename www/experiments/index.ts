/** All experiments, in the order of the paper. */

import { crumplingExperiment } from "./crumpling";
import type { Experiment } from "./experiment";
import { gridsExperiment } from "./grids";
import { cascadeExperiment } from "./levels";
import { metricExperiment } from "./metric";
import { rotationExperiment } from "./rotation";
import { strainExperiment } from "./strain";
import { sweepExperiment } from "./sweep";

export const EXPERIMENTS: readonly Experiment[] = [
  strainExperiment,
  gridsExperiment,
  crumplingExperiment,
  rotationExperiment,
  cascadeExperiment,
  metricExperiment,
  sweepExperiment,
];
