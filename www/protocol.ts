/**
 * What page and worker say to each other. Types only; those of the solver come from its Rust source.
 *
 * Every run has a number, given by the page. An answer with an old number belongs to a cancelled run and is dropped.
 */

import type { Curves, Inspection, Settings, Shape, Status } from "./wasm/thinshell.js";

export type { Curves, Inspection, Settings, Shape, Status };

/** The weighted energies after one iteration. */
export type Iteration = Status["energies"] & {
  readonly level: number;
  readonly iteration: number;
  /** φ as trail.ts keeps it; none while the match follows a hand. */
  readonly kept?: Float32Array;
};

export type Request =
  /** First message of a worker's life: the compiled solver, so that no worker ever needs the network. */
  | { readonly kind: "load"; readonly module: WebAssembly.Module }
  | {
      readonly kind: "start";
      readonly run: number;
      readonly reference: Shape;
      readonly template: Shape;
      readonly settings: Partial<Settings>;
    }
  /**
   * Goes on from the deformation there is, as a run of its own. Shapes and settings are all given, so that one update
   * can stand for those before it that the worker has not come to.
   */
  | {
      readonly kind: "update";
      readonly run: number;
      readonly reference: Shape;
      readonly template: Shape;
      readonly settings: Partial<Settings>;
    }
  /** Asks whether the finest grid resolves two shapes; belongs to no run. A newer inquiry stands for those before it. */
  | {
      readonly kind: "inspect";
      readonly inquiry: number;
      readonly reference: Shape;
      readonly template: Shape;
      readonly settings: Partial<Settings>;
    }
  | { readonly kind: "pause"; readonly run: number }
  | { readonly kind: "resume"; readonly run: number }
  | { readonly kind: "cancel"; readonly run: number }
  /** The page has taken the last frame; until then the worker sends no other, so that no queue builds up. */
  | { readonly kind: "taken"; readonly run: number };

/** What every frame holds, whatever its picture. */
export type AnyFrame = {
  readonly kind: "frame";
  readonly run: number;
  readonly status: Status;
  /** The energies of this level's identity, where they are known: what is there before anything is deformed. */
  readonly rest: Status["energies"] | null;
  /** Every iteration since the last frame, this one's included. */
  readonly trail: readonly Iteration[];
};

/** A frame of curves. */
export type FrameReply = AnyFrame & {
  /** φ at the nodes of the level, x y a node, x fastest. */
  readonly deformation: Float64Array;
  readonly curves: Curves;
};

export type Reply<Frame extends AnyFrame = FrameReply> =
  /** The worker has the solver. */
  | { readonly kind: "ready" }
  /** The worker has let go of what it did before and turns to this run, or has ended it where it was to be cancelled. */
  | { readonly kind: "heard"; readonly run: number }
  | Frame
  /** Null where the solver does not take the shapes: Match says why. */
  | { readonly kind: "inspected"; readonly inquiry: number; readonly inspection: Inspection | null }
  /** The solver does not take this input: a sentence with the remedy. */
  | { readonly kind: "refused"; readonly run: number; readonly message: string }
  /** The solver has failed and this worker is of no more use. */
  | { readonly kind: "crashed"; readonly message: string };
