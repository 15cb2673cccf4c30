/** The states of a run and what leads from one to another: a table, so that nothing else has to be thought of. */

export type Phase =
  /** Nothing runs and nothing is shown. */
  | "idle"
  /** The same, after the user has ended a run. */
  | "cancelled"
  /** The solver loads, or takes up the shapes: no frame yet. */
  | "preparing"
  | "solving"
  | "paused"
  /** The match goes after the hand, on a coarse grid. */
  | "following"
  /** The same, but the present shapes were refused: the picture is of the last ones that were not. */
  | "astray"
  /** The hand has let go: the match that followed it goes on to the finest grid. */
  | "refining"
  | "pausedRefining"
  /** The solver holds a match that has been through all grids. */
  | "matched"
  /** A match from a file is shown; the solver knows nothing of it. */
  | "restored";

export type PhaseEvent =
  | "start"
  | "frame"
  | "finish"
  | "refuse"
  | "pause"
  | "resume"
  | "follow"
  | "refine"
  | "cancel"
  /** The run ends without a result: a failure, or shapes that it was not for. */
  | "drop"
  | "restore";

type Row = Partial<Record<PhaseEvent, Phase>>;

/** From every state. */
const ALWAYS: Row = { start: "preparing", drop: "idle", restore: "restored" };
const RUNNING: Row = { ...ALWAYS, cancel: "cancelled" };
const ESTABLISHED: Row = { follow: "following", refine: "refining" };

/** What is not in a row changes nothing: a late frame, a key pressed twice. */
const NEXT: Readonly<Record<Phase, Row>> = {
  idle: ALWAYS,
  cancelled: ALWAYS,
  preparing: { ...RUNNING, frame: "solving", finish: "matched", refuse: "idle", pause: "paused" },
  solving: { ...RUNNING, finish: "matched", refuse: "idle", pause: "paused" },
  // The last frame may have been on its way: then there is nothing to resume.
  paused: { ...RUNNING, finish: "matched", refuse: "idle", resume: "solving" },
  following: { ...RUNNING, ...ESTABLISHED, refuse: "astray" },
  astray: {
    ...RUNNING,
    ...ESTABLISHED,
    follow: "astray",
    frame: "following",
    finish: "following",
    refine: "preparing",
  },
  refining: { ...RUNNING, ...ESTABLISHED, finish: "matched", refuse: "preparing", pause: "pausedRefining" },
  pausedRefining: { ...RUNNING, ...ESTABLISHED, finish: "matched", refuse: "preparing", resume: "refining" },
  matched: { ...RUNNING, ...ESTABLISHED },
  restored: RUNNING,
};

export function next(phase: Phase, event: PhaseEvent): Phase {
  return NEXT[phase][event] ?? phase;
}

/** A full run is on, moving or paused: what Pause and the progress bar are about. */
export function isWorking(phase: Phase): boolean {
  return phase === "preparing" || phase === "solving" || phase === "refining" || isPaused(phase);
}

export function isPaused(phase: Phase): boolean {
  return phase === "paused" || phase === "pausedRefining";
}

export function isFollowing(phase: Phase): boolean {
  return phase === "following" || phase === "astray";
}

/** The solver is at work, or would be but for the user. */
export function isRunning(phase: Phase): boolean {
  return (isWorking(phase) && !isPaused(phase)) || isFollowing(phase);
}

/** There is a match to go on from. */
export function isEstablished(phase: Phase): boolean {
  return next(phase, "follow") !== phase || isFollowing(phase);
}

/** A result is shown. */
export function isDone(phase: Phase): boolean {
  return phase === "matched" || phase === "restored";
}
