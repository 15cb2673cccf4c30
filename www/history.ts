/** Undo and redo over immutable values. */

export type History<T> = {
  readonly past: readonly T[];
  readonly present: T;
  readonly future: readonly T[];
};

/** Steps kept; a shape pair is some six kilobytes. */
const DEPTH = 200;

export function begun<T>(present: T): History<T> {
  return { past: [], present, future: [] };
}

/** A new present; what had been undone is gone. */
export function changed<T>(history: History<T>, present: T): History<T> {
  return { past: [...history.past, history.present].slice(-DEPTH), present, future: [] };
}

/** One step back, or the same history at its beginning. */
export function undone<T>(history: History<T>): History<T> {
  if (history.past.length === 0) return history;
  return {
    past: history.past.slice(0, -1),
    present: history.past[history.past.length - 1],
    future: [history.present, ...history.future],
  };
}

/** One step forward, or the same history at its end. */
export function redone<T>(history: History<T>): History<T> {
  if (history.future.length === 0) return history;
  return {
    past: [...history.past, history.present],
    present: history.future[0],
    future: history.future.slice(1),
  };
}
