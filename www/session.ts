/** What the page knows: shapes and their history, settings, the run under way. Signals; no DOM. */

import { computed, effect, signal } from "@preact/signals";
import { begun, changed, type History, redone, undone } from "./history";
import { Follower, LIVE_LEVEL, SETTLED_CELLS } from "./live";
import type { FrameReply, Iteration } from "./protocol";
import type { MatchRecord } from "./record";
import { type Chosen, complete, FIELDS, finestLevel, type SettingField, withSetting } from "./settings";
import { fitted, type Shape } from "./shapes/geometry";
import type { Preset } from "./shapes/presets";
import { Solver } from "./solver";
import { encode, type Opened, open, remember } from "./state";

export type Side = "reference" | "template";
export type Phase = "idle" | "solving" | "following" | "paused" | "finished";

/** The two shapes as they stand in the history. */
export type Pair = {
  readonly reference: Shape;
  readonly template: Shape;
  /** The preset that both are, untouched. */
  readonly preset: string | null;
  /** Which of them are untouched examples: the first stroke replaces those. */
  readonly examples: { readonly reference: boolean; readonly template: boolean };
};

/** Between an edit and the new run it causes; a drag makes many. */
const RESTART_MILLIS = 250;
/** Between an edit and its being written to the address, which browsers allow some three times a second. */
const REMEMBER_MILLIS = 400;

export class Session {
  private readonly history;
  private readonly solver: Solver;
  private readonly follower = new Follower((at) => this.sendLive(at));
  /** The solver holds a match that has been through all levels once, so that updates can go on from it. */
  private established = false;
  /** Whether the run under way refines an update, not a full run. */
  private refining = false;
  /** Whether the last update was refused. */
  private refused = false;
  /** Time of the event that the update under way was made from, until its first frame is there. */
  private asked: number | null = null;
  /** The same for the frame that is to be drawn next. */
  private received: number | null = null;
  private restarting: ReturnType<typeof setTimeout> | undefined;
  private remembering: ReturnType<typeof setTimeout> | undefined;

  /** The shape under the hand, not yet in the history. */
  private readonly moving = signal<{ readonly side: Side; readonly shape: Shape } | null>(null);
  readonly settings = signal<Chosen>({});
  /** Whether the match follows the hand. */
  readonly live = signal(false);
  readonly phase = signal<Phase>("idle");
  readonly energies = signal<readonly Iteration[]>([]);
  readonly problem = signal<string | null>(null);
  /** 0 shows the identity, 1 the match. */
  readonly morph = signal(1);

  private readonly frame = signal<FrameReply | null>(null);
  /** The shapes of the run that `frame` belongs to. */
  private readonly solved = signal<{ readonly reference: Shape; readonly template: Shape } | null>(null);

  readonly shapes;
  readonly canUndo;
  readonly canRedo;
  readonly preset;
  /** The frame to show: none while the shapes are others than those it was computed for, unless a new run is on. */
  readonly match;

  constructor(
    readonly module: Promise<WebAssembly.Module>,
    opened: Opened,
  ) {
    const { saved, problem } = opened;
    this.history = signal<History<Pair>>(begun(pairFrom(saved.reference, saved.template, saved.preset)));
    this.settings.value = saved.settings;
    this.problem.value = problem;
    this.shapes = computed(() => {
      const { reference, template } = this.history.value.present;
      const moving = this.moving.value;
      return {
        reference: moving?.side === "reference" ? moving.shape : reference,
        template: moving?.side === "template" ? moving.shape : template,
      };
    });
    this.canUndo = computed(() => this.history.value.past.length > 0);
    this.canRedo = computed(() => this.history.value.future.length > 0);
    this.preset = computed(() => this.history.value.present.preset);
    this.match = computed(() => (this.running || this.current ? this.frame.value : null));
    this.solver = new Solver(module, {
      frame: (frame) => this.receive(frame),
      refused: (message) => this.refuse(sentence(message)),
      unavailable: (message) => this.fail(sentence(message)),
      crashed: (message) =>
        this.fail(
          `The solver stopped unexpectedly (${message}). Your shapes are kept; press Match to try again with a fresh one.`,
        ),
    });
    this.rememberChanges(opened.remembered ? null : this.link());
  }

  isExample(side: Side): boolean {
    return this.history.value.present.examples[side];
  }

  /** The shape while the hand is still moving. `at` is the time of the event. */
  previewShape(side: Side, shape: Shape, at: number): void {
    // Before the page is drawn anew: then the solver works while the page draws.
    if (this.live.value) this.follow(at);
    this.moving.value = { side, shape };
    if (!this.live.value) this.shapesChanged();
  }

  /** Takes back what was previewed. */
  restoreShape(): void {
    this.moving.value = null;
    this.shapesChanged();
  }

  /** One step to undo. */
  commitShape(side: Side, shape: Shape): void {
    const { present } = this.history.value;
    this.commit({
      ...present,
      [side]: shape,
      preset: null,
      examples: { ...present.examples, [side]: false },
    });
  }

  /** Scales both shapes to a comfortable size and centres them. */
  fit(): void {
    const { present } = this.history.value;
    this.commit({ ...present, reference: fitted(present.reference), template: fitted(present.template), preset: null });
  }

  choosePreset(preset: Preset): void {
    this.commit(pairFrom(preset.reference, preset.template, preset.id));
    this.start();
  }

  undo(): void {
    this.travel(undone(this.history.value));
  }

  redo(): void {
    this.travel(redone(this.history.value));
  }

  /** Shows what a link holds; the shapes before it are one undo away. */
  openLink(hash: string): void {
    const { saved, problem } = open(hash, null);
    if (problem) {
      this.problem.value = problem;
      return;
    }
    this.settings.value = saved.settings;
    this.commit(pairFrom(saved.reference, saved.template, saved.preset));
  }

  /** Shows a saved match as it was; the shapes before it are one undo away. */
  restore({ reference, template, settings, match }: MatchRecord): void {
    this.settings.value = settings;
    this.commit(pairFrom(reference, template, null));
    // Nothing is to be computed, not even where the match follows the hand.
    this.cancel();
    if (!match) return;
    this.energies.value = [];
    this.morph.value = 1;
    this.solved.value = { reference, template };
    this.frame.value = { kind: "frame", run: 0, trail: [], ...match };
    this.fresh.value = true;
    this.phase.value = "finished";
  }

  changeSetting(field: SettingField, value: number | string | boolean): void {
    this.settings.value = withSetting(this.settings.value, field, value);
    this.settingsChanged();
  }

  /** The setting while its slider is still moving. `at` is the time of the event. */
  previewSetting(field: SettingField, value: number, at: number): void {
    if (this.live.value) this.follow(at);
    this.settings.value = withSetting(this.settings.value, field, value);
    if (!this.live.value) this.restartSoon();
  }

  resetSettings(): void {
    this.settings.value = {};
    this.settingsChanged();
  }

  /** Switching on begins with a full match, unless there is one to go on from. */
  setLive(on: boolean): void {
    this.live.value = on;
    if (!on && this.phase.value === "following") this.settle();
    if (!on || this.empty || (this.phase.value === "finished" && this.established && this.current)) return;
    this.start();
  }

  start(): void {
    clearTimeout(this.restarting);
    this.forgetRun();
    const { reference, template } = this.shapes.value;
    this.problem.value = null;
    this.energies.value = [];
    this.phase.value = "solving";
    // The last picture stays until the first frame of the new run, but not its numbers.
    this.solved.value = { reference, template };
    this.fresh.value = false;
    this.solver.start(curves(reference), curves(template), this.settings.value);
  }

  pause(): void {
    if (this.phase.value !== "solving") return;
    this.solver.pause();
    this.phase.value = "paused";
  }

  resume(): void {
    if (this.phase.value !== "paused") return;
    this.solver.resume();
    this.phase.value = "solving";
  }

  cancel(): void {
    clearTimeout(this.restarting);
    this.forgetRun();
    this.solver.cancel();
    this.phase.value = "idle";
    this.frame.value = null;
  }

  dismissProblem(): void {
    this.problem.value = null;
  }

  /** The address that brings back what is on the page now. */
  link(): string {
    const { reference, template, preset } = this.history.value.present;
    return encode({ reference, template, settings: this.settings.value, preset });
  }

  /** Whether `match` belongs to the run under way, not to the one before. */
  readonly fresh = signal(false);

  /** To be called when `frame` has been drawn: reports how long it took from the hand to the picture. */
  drawn(frame: FrameReply | null): void {
    if (this.received === null || frame !== this.frame.value) return;
    performance.measure("live-frame", { start: this.received, end: performance.now() });
    // Observers have it; kept in the page's timeline, every frame would cost memory for good.
    performance.clearMeasures("live-frame");
    this.received = null;
  }

  private receive(frame: FrameReply): void {
    // First of all, for the next update is to be on its way before this frame is drawn.
    this.follower.answered();
    const { status } = frame;
    const before = this.frame.value;
    this.received = this.asked;
    this.asked = null;
    if (this.refused) this.problem.value = null;
    this.refused = false;
    this.frame.value = frame;
    this.fresh.value = true;
    // Each update's energies are a history of their own, and too short to be read while the hand moves.
    if (this.phase.value !== "following") {
      this.energies.value = before?.run === frame.run ? [...this.energies.value, ...frame.trail] : frame.trail;
    }
    if (!status.finished || this.phase.value !== "solving") return;
    if (this.refining && status.mismatch.max > SETTLED_CELLS) {
      this.start();
      return;
    }
    this.established = true;
    this.refining = false;
    this.phase.value = "finished";
    // The hand has moved on during a full match: catch up with it.
    if (this.live.value && this.moving.value) this.follow(performance.now());
  }

  private refuse(message: string): void {
    if (this.refining) this.start();
    else if (this.phase.value === "following") {
      this.refused = true;
      this.follower.answered();
      this.problem.value = message;
    } else this.fail(message);
  }

  private fail(message: string): void {
    clearTimeout(this.restarting);
    this.forgetRun();
    this.phase.value = "idle";
    this.frame.value = null;
    this.problem.value = message;
  }

  private commit(pair: Pair): void {
    this.moving.value = null;
    this.history.value = changed(this.history.value, pair);
    this.problem.value = null;
    this.shapesChanged();
  }

  private travel(to: History<Pair>): void {
    if (to === this.history.value) return;
    this.moving.value = null;
    this.history.value = to;
    this.shapesChanged();
  }

  private get current(): boolean {
    const solved = this.solved.value;
    const { reference, template } = this.shapes.value;
    return solved?.reference === reference && solved.template === template;
  }

  private get running(): boolean {
    return this.phase.value === "solving" || this.phase.value === "following";
  }

  private get empty(): boolean {
    return Object.values(this.shapes.value).some((shape) => shape.length === 0);
  }

  private forgetRun(): void {
    this.follower.stop();
    this.established = false;
    this.refining = false;
    this.refused = false;
    this.asked = null;
  }

  /** Something moves under the hand: the match goes after it, or comes into being first. */
  private follow(at: number): void {
    if (this.established) this.follower.follow(at);
    else if (!this.running && !this.problem.value) this.start();
  }

  private sendLive(at: number): void {
    const chosen = this.settings.value;
    this.asked = at;
    this.refining = false;
    this.phase.value = "following";
    this.update({ ...chosen, finest: Math.min(LIVE_LEVEL, finestLevel(chosen)) });
  }

  /** The hand has let go: goes on to the finest level, or begins anew where there is nothing to go on from. */
  private settle(): void {
    this.follower.stop();
    if (this.empty) this.cancel();
    else if (!this.established || this.refused) this.start();
    else {
      this.asked = null;
      this.refining = true;
      this.phase.value = "solving";
      this.update(this.settings.value);
    }
  }

  private update(settings: Chosen): void {
    const { reference, template } = this.shapes.value;
    this.solved.value = { reference, template };
    this.solver.update(curves(reference), curves(template), complete(settings));
  }

  private settingsChanged(): void {
    if (this.live.value) this.settle();
    else this.restartSoon();
  }

  private shapesChanged(): void {
    if (this.live.value) this.settle();
    else if (this.phase.value === "paused") this.cancel();
    else this.restartSoon();
  }

  /** A run under way starts again with what has changed; without one, the user decides. */
  private restartSoon(): void {
    if (this.phase.value !== "solving") return;
    clearTimeout(this.restarting);
    this.restarting = setTimeout(() => this.start(), RESTART_MILLIS);
  }

  /** `last` is what the address and storage hold already. */
  private rememberChanges(last: string | null): void {
    effect(() => {
      const text = this.link();
      clearTimeout(this.remembering);
      if (text === last) return;
      this.remembering = setTimeout(() => {
        last = text;
        remember(text);
      }, REMEMBER_MILLIS);
    });
    // Closing the page within that time loses nothing either.
    addEventListener("pagehide", () => {
      if (this.link() !== last) remember(this.link());
    });
  }
}

function pairFrom(reference: Shape, template: Shape, preset: string | null): Pair {
  const example = preset !== null;
  return { reference, template, preset, examples: { reference: example, template: example } };
}

function curves(shape: Shape) {
  return { kind: "curves" as const, loops: [...shape] };
}

export function sentence(message: string): string {
  const text = message.charAt(0).toUpperCase() + message.slice(1);
  return /[.!?]$/.test(text) ? text : `${text}.`;
}

/** The setting fields whose value is not the default. */
export function changedFields(settings: Chosen): readonly SettingField[] {
  return FIELDS.filter((field) => settings[field.name] !== undefined);
}
