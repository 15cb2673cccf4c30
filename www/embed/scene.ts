/** What a frame shows, as far as the page around it can know and change it. */

import { Comparison } from "../controls/compared";
import { decode } from "../link/text";
import { isDone, isPaused, isWorking, type Phase } from "../phase";
import { sentence } from "../run";
import type { Session } from "../session";
import { isSpace, type space } from "../space/way";
import { mapped } from "../view/field";
import { type Asked, changedBy } from "./asked";
import { numbersOf, type Report, reportOf } from "./report";
import type { Host } from "./talk";
import { restUnseen } from "./unseen";

export type Scene = {
  readonly host: Host<Report>;
  /** The match that is final and of what is chosen; another one is another object. */
  readonly final: () => object | null;
  readonly start: () => void;
  /** Of two settings side by side. */
  readonly comparison: Comparison | null;
};

const runs = (phase: Phase) => isWorking(phase) && !isPaused(phase);

/** One match of curves. */
export function single(session: Session): Scene {
  const { phase, stale, match, problem } = session;
  restUnseen({
    runs: () => runs(phase.value),
    pause: () => session.pause(),
    resume: () => isPaused(phase.peek()) && session.resume(),
  });
  return {
    comparison: null,
    start: () => session.glance(),
    final: () => (isDone(phase.value) && !stale.value ? match.value : null),
    host: {
      set: (state) => {
        // What cannot be read is refused before anything is touched.
        curvesIn(state);
        session.openLink(state);
      },
      report: () =>
        reportOf({
          state: session.link(),
          phase: phase.value,
          stale: stale.value,
          problem: problem.value,
          status: match.value?.status ?? null,
        }),
      map: (points) => match.value && carried(match.value, points),
    },
  };
}

/** Two settings on the same curves; points are carried by the first. */
export function double(session: Session, { sides }: Asked): Scene {
  const comparison = new Comparison(session.engine, (message) => {
    session.problem.value = sentence(message);
  });
  const { outcomes, busy } = comparison;
  restUnseen({
    runs: () => busy.value,
    pause: () => comparison.pause(),
    resume: () => comparison.resume(),
  });
  const start = () => {
    const shapes = session.shapes.peek();
    const [a, b] = sides.map((side) => ({ ...shapes, settings: changedBy(session.settings.peek(), side) }));
    session.problem.value = null;
    comparison.run([a, b]);
  };
  const final = () => (outcomes.value.every((one) => one !== null) ? outcomes.value : null);
  return {
    comparison,
    start,
    final,
    host: {
      set: (state) => {
        curvesIn(state);
        session.openLink(state);
        if (new URLSearchParams(state).get("match") !== "later") start();
      },
      report: () => ({
        state: session.link(),
        finished: final() !== null,
        problem: session.problem.value,
        match: null,
        sides: outcomes.value.map((one) => one && numbersOf(one.frame.status)),
      }),
      map: (points) => outcomes.value[0] && carried(outcomes.value[0].frame, points),
    },
  };
}

/** A match of surfaces, once they are there. */
export function solid(shown: NonNullable<typeof space.value>): Scene {
  const { session } = shown;
  const { phase, stale, problem } = session;
  const match = () => session.result.value?.frame ?? null;
  restUnseen({
    runs: () => runs(phase.value),
    pause: () => session.pause(),
    resume: () => isPaused(phase.peek()) && session.resume(),
  });
  return {
    comparison: null,
    // They begin by themselves.
    start: () => {},
    final: () => (isDone(phase.value) && !stale.value ? match() : null),
    host: {
      set: (state) => {
        if (!isSpace(`#${state}`)) throw new Error("this frame is about surfaces, and that is no state of them");
        shown.set(state);
      },
      report: () =>
        reportOf({
          state: shown.text(),
          phase: phase.value,
          stale: stale.value,
          problem: problem.value,
          status: match()?.status ?? null,
        }),
      map: () => {
        throw new Error("points are mapped for curves only");
      },
    },
  };
}

function curvesIn(state: string): void {
  if (isSpace(`#${state}`)) throw new Error("this frame is about curves, and that is a state of surfaces");
  decode(state);
}

type Moving = { readonly status: { readonly level: number }; readonly deformation: Float64Array };

function carried({ status, deformation }: Moving, points: Parameters<Host<Report>["map"]>[0]) {
  const grid = { cells: 2 ** status.level, deformation };
  return points.map(([x, y]) => mapped(grid, x, y));
}
