/** The run under way: its state, what it has found, and when the solver is told what. Signals; no DOM. */

import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { Delay } from "./delay";
import type { Engine } from "./engine";
import { Follower, LIVE_LEVEL, SETTLED_CELLS } from "./follower";
import { Latency } from "./latency";
import { isEstablished, isFollowing, isPaused, isRunning, isWorking, next, type Phase, type PhaseEvent } from "./phase";
import type { FrameReply, Inspection, Iteration } from "./protocol";
import type { SavedMatch } from "./record";
import { type Chosen, coarsestLevel, complete, finestLevel, sameSettings } from "./settings";
import type { Shape } from "./shapes/geometry";
import { flat, type Pin, type Shapes } from "./shapes/pins";
import { Solver } from "./solver";
import { en } from "./words/en";

/** What a match is computed from. */
export type Inputs = Shapes & { readonly settings: Chosen };

/** A match with what it was computed from: whoever shows or saves φ takes the shapes and settings from here. */
export type Result = Inputs & { readonly frame: FrameReply };

/** What the solver has been told, and whether it is a first look only, to be gone on from. */
type Sent = Inputs & { readonly glance: boolean };

/** What a run is of, and whom it tells. */
export type Subject = {
  readonly shapes: ReadonlySignal<Shapes>;
  readonly settings: ReadonlySignal<Chosen>;
  /** Whether the hand is moving something that the match has to follow. */
  followsHand(): boolean;
  /** A sentence for the user, or null when the last one no longer holds. */
  say(problem: string | null): void;
};

/** The finest level of a first look, which is there within a moment. */
const GLANCE_LEVEL = 7;

/** Between an edit and the new run it causes; a drag makes many. */
const RESTART_MILLIS = 250;

export class Run {
  private readonly subject: Subject;
  private readonly solver: Solver;
  private readonly follower = new Follower((at) => this.sendFollowing(at));
  private readonly latency = new Latency();
  private readonly restarting = new Delay(RESTART_MILLIS);

  private readonly state = signal<Phase>("idle");
  /** What the solver is at work on: its frames belong to this. */
  private sent: Sent | null = null;
  /** The last frame. */
  private readonly last = signal<Result | null>(null);

  readonly phase: ReadonlySignal<Phase> = this.state;
  /** The solver has been fetched and compiled. */
  readonly loaded = signal(false);
  readonly energies = signal<readonly Iteration[]>([]);
  /** Whether the finest grid resolves the shapes, as far as that is known. */
  readonly inspection = signal<Inspection | null>(null);
  /** Whether `match` belongs to the run under way, not to the one before. */
  readonly fresh = signal(false);
  /** What to show: nothing while the shapes are others than those it was computed for, unless a new run is on. */
  readonly result = computed(() => {
    const last = this.last.value;
    return last && (isRunning(this.state.value) || sameShapes(last, this.subject.shapes.value)) ? last : null;
  });
  readonly match = computed(() => this.result.value?.frame ?? null);
  /** What the result was computed with and is no longer the present one, while nothing is under way to change that. */
  readonly outdated = computed<"settings" | "pins" | null>(() => {
    const result = this.result.value;
    if (!result || isRunning(this.state.value)) return null;
    if (!sameSettings(result.settings, this.subject.settings.value)) return "settings";
    return samePins(result.pins, this.subject.shapes.value.pins) ? null : "pins";
  });
  readonly stale = computed(() => this.outdated.value !== null);

  constructor(engine: Engine, subject: Subject) {
    this.subject = subject;
    this.solver = new Solver(engine, {
      ready: () => {
        this.loaded.value = true;
      },
      frame: (frame) => this.receive(frame),
      refused: (message) => this.refuse(sentence(message)),
      inspected: (inspection) => {
        this.inspection.value = inspection;
      },
      unavailable: (message) => this.fail(sentence(message)),
      crashed: (message) => this.fail(en.solver.stopped(message)),
    });
  }

  get established(): boolean {
    return isEstablished(this.state.value);
  }

  /** The match that is shown is of the present shapes and settings, and the solver can go on from it. */
  get upToDate(): boolean {
    return this.state.value === "matched" && this.result.value !== null && !this.stale.value;
  }

  start(): void {
    this.subject.say(null);
    this.begins(this.subject.settings.value, false);
  }

  /** A match for whoever has just come: at once on a grid that is quick, then on to the finest. What was said stays. */
  glance(): void {
    const chosen = this.subject.settings.value;
    const level = Math.max(coarsestLevel(chosen), Math.min(GLANCE_LEVEL, finestLevel(chosen)));
    this.begins({ ...chosen, finest: level }, true);
  }

  pause(): void {
    if (this.advance("pause")) this.solver.pause();
  }

  /** What has been chosen since the pause counts: then there is nothing to go on with. */
  resume(): void {
    const { sent, present } = this;
    if (sent && !(samePins(sent.pins, present.pins) && sameSettings(sent.settings, present.settings))) this.start();
    else if (this.advance("resume")) this.solver.resume();
  }

  /** The user ends the run. */
  cancel(): void {
    this.end("cancel");
    this.solver.cancel();
  }

  /** The run is of no use any more. */
  drop(): void {
    this.end("drop");
    this.solver.cancel();
  }

  /** Shows a match that was saved. */
  restore(match: SavedMatch): void {
    this.drop();
    this.energies.value = [];
    this.last.value = { ...this.present, frame: { kind: "frame", run: 0, trail: [], rest: null, ...match } };
    this.fresh.value = true;
    this.advance("restore");
  }

  /** Something moves under the hand: the match goes after it, or comes into being first. */
  follow(at: number): void {
    if (this.established) this.follower.follow(at);
    else if (!isRunning(this.state.value)) this.start();
  }

  /** The hand has let go: goes on to the finest level, or begins anew where there is nothing to go on from. */
  settle(): void {
    this.follower.stop();
    if (!this.established || this.state.value === "astray") this.start();
    else {
      this.latency.forget();
      this.advance("refine");
      this.update(this.subject.settings.value);
    }
  }

  /** A run under way starts again with what has changed; without one, the user decides. */
  restartSoon(): void {
    if (!isWorking(this.state.value) || isPaused(this.state.value)) return;
    this.restarting.start(() => this.start());
  }

  /** To be called when `frame` has been drawn: reports how long it took from the hand to the picture. */
  drawn(frame: FrameReply | null): void {
    if (frame === this.last.value?.frame) this.latency.drawn();
  }

  /** Forgets what is known of the shapes' narrow parts. */
  changed(): void {
    this.inspection.value = null;
  }

  /** Asks about the shapes' narrow parts. */
  inspect({ reference, template }: Pick<Shapes, "reference" | "template">): void {
    this.solver.inspect(curves(reference), curves(template), { finest: finestLevel(this.subject.settings.value) });
  }

  private begins(settings: Chosen, glance: boolean): void {
    this.forget();
    this.energies.value = [];
    this.advance("start");
    const { reference, template, pins } = this.begin(settings, glance);
    // The last picture stays until the first frame of the new run, but not its numbers.
    this.fresh.value = false;
    this.solver.start(reference, template, { ...settings, pins });
  }

  private get present(): Inputs {
    return { ...this.subject.shapes.value, settings: this.subject.settings.value };
  }

  /** Whether the event has changed the state. */
  private advance(event: PhaseEvent): boolean {
    const before = this.state.value;
    this.state.value = next(before, event);
    return this.state.value !== before;
  }

  private receive(frame: FrameReply): void {
    // First of all, for the next update is to be on its way before this frame is drawn.
    this.follower.answered();
    const { status } = frame;
    const before = this.last.value?.frame;
    const { value: phase } = this.state;
    this.latency.receive();
    if (phase === "astray") this.subject.say(null);
    const { reference, template, pins, settings } = this.sent ?? this.present;
    this.last.value = { reference, template, pins, settings, frame };
    this.fresh.value = true;
    // Each update's energies are a history of their own, and too short to be read while the hand moves.
    if (!isFollowing(phase)) {
      this.energies.value = before?.run === frame.run ? [...this.energies.value, ...frame.trail] : frame.trail;
    }
    const refined = phase === "refining" || phase === "pausedRefining";
    if (status.finished && refined && !(status.mismatch.max <= SETTLED_CELLS)) {
      this.start();
      return;
    }
    const ended = this.advance(status.finished ? "finish" : "frame") && this.state.value === "matched";
    if (ended && this.sent?.glance && this.stale.value) this.settle();
    // The hand has moved on during a full match: catch up with it.
    if (ended && this.subject.followsHand()) this.follow(performance.now());
  }

  private refuse(message: string): void {
    if (this.state.value === "refining" || this.state.value === "pausedRefining") this.start();
    else if (isFollowing(this.state.value)) {
      this.advance("refuse");
      this.follower.answered();
      this.subject.say(message);
    } else this.fail(message);
  }

  private fail(message: string): void {
    this.end("drop");
    this.subject.say(message);
  }

  private end(event: "cancel" | "drop"): void {
    this.forget();
    this.advance(event);
    this.last.value = null;
  }

  private forget(): void {
    this.restarting.stop();
    this.follower.stop();
    this.latency.forget();
  }

  private sendFollowing(at: number): void {
    const chosen = this.subject.settings.value;
    this.latency.ask(at);
    this.advance("follow");
    this.update({ ...chosen, finest: Math.min(LIVE_LEVEL, finestLevel(chosen)) });
  }

  private update(settings: Chosen): void {
    const { reference, template, pins } = this.begin(settings, false);
    this.solver.update(reference, template, { ...complete(settings), pins });
  }

  private begin(settings: Chosen, glance: boolean) {
    const { reference, template, pins } = this.subject.shapes.value;
    this.sent = { reference, template, pins, settings, glance };
    return { reference: curves(reference), template: curves(template), pins: flat(pins) };
  }
}

function sameShapes(a: Shapes, b: Shapes): boolean {
  return a.reference === b.reference && a.template === b.template;
}

function samePins(a: readonly Pin[], b: readonly Pin[]): boolean {
  return a === b || (a.length === 0 && b.length === 0);
}

function curves(shape: Shape) {
  return { kind: "curves" as const, loops: [...shape] };
}

/** What the solver says, as a sentence of the page. */
export function sentence(message: string): string {
  return asSentence(en.solver.words(message));
}

export function asSentence(words: string): string {
  const text = words.charAt(0).toUpperCase() + words.slice(1);
  return /[.!?]$/.test(text) ? text : `${text}.`;
}
