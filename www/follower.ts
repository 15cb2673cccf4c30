/**
 * The beat of following a hand: the newest state goes out at most once an animation frame, and the next only when the
 * solver has answered, so that no queue builds up and no answer is of an older state than the last one sent.
 */

/** The finest level while the hand moves; 65 × 65 nodes. */
export const LIVE_LEVEL = 6;

/** A match worse than this at the end of an update is given up for a fresh one. Units: cells of the finest level. */
export const SETTLED_CELLS = 0.5;

export type FrameClock = {
  request(then: () => void): number;
  cancel(frame: number): void;
};

const BROWSER: FrameClock = {
  request: (then) => requestAnimationFrame(then),
  cancel: (frame) => cancelAnimationFrame(frame),
};

export class Follower {
  private readonly send: (at: number) => void;
  private readonly clock: FrameClock;
  /** Time of the newest event that has not been sent. */
  private newest: number | null = null;
  private answering = false;
  private pending = 0;

  /** `send` reads the present state itself; `at` is the time of the event that made it, as events have it. */
  constructor(send: (at: number) => void, clock: FrameClock = BROWSER) {
    this.send = send;
    this.clock = clock;
  }

  /** Something has moved. */
  follow(at: number): void {
    this.newest = at;
    this.plan();
  }

  /** A frame or a refusal has come for what was sent. */
  answered(): void {
    this.answering = false;
    this.plan();
  }

  /** Forgets what was wanted; an answer still under way is no longer waited for. */
  stop(): void {
    this.clock.cancel(this.pending);
    this.pending = 0;
    this.newest = null;
    this.answering = false;
  }

  private plan(): void {
    if (this.answering || this.newest === null || this.pending) return;
    this.pending = this.clock.request(() => {
      this.pending = 0;
      if (this.newest === null) return;
      const at = this.newest;
      this.newest = null;
      this.answering = true;
      this.send(at);
    });
  }
}
