/** What the page knows: shapes and their history, settings, the run of them. Signals; no DOM. */

import { computed, effect, signal } from "@preact/signals";
import type { Engine } from "./engine";
import { begun, changed, type History, redone, undone } from "./history";
import { isFollowing, isPaused } from "./phase";
import { fetchKit, kit } from "./pins/kit";
import type { MatchRecord } from "./record";
import { type Result, Run } from "./run";
import { Runs } from "./runs";
import { type Chosen, FIELDS, type SettingField, withSetting } from "./settings";
import { fitted, type Loop, type Shape } from "./shapes/geometry";
import type { Pin, Shapes } from "./shapes/pins";
import type { Preset } from "./shapes/presets";
import { encode, type Opened, open, remember } from "./state";

export type Side = "reference" | "template";

/** The two shapes and their pins as they stand in the history. */
export type Pair = Shapes & {
  /** The preset that both are, untouched. */
  readonly preset: string | null;
  /** Which of them are untouched examples: the first stroke replaces those. */
  readonly examples: { readonly reference: boolean; readonly template: boolean };
};

/** What is to be decided before a stroke becomes a shape. */
export type Question = {
  readonly side: Side;
  /** What has been drawn. */
  readonly loop: Loop;
  readonly words: string;
  readonly ways: readonly { readonly label: string; readonly go: () => void }[];
};

/** Between an edit and its being written to the address, which browsers allow some three times a second. */
const REMEMBER_MILLIS = 400;
/** Between an edit and the question whether the grid resolves what has come out. */
const INSPECT_MILLIS = 300;

export class Session {
  private readonly history;
  private readonly run: Run;
  private remembering: ReturnType<typeof setTimeout> | undefined;
  private inspecting: ReturnType<typeof setTimeout> | undefined;

  /** The shapes while the hand moves one of them or a pin, not yet in the history. */
  private readonly moving = signal<Shapes | null>(null);
  readonly settings = signal<Chosen>({});
  /** Whether the match follows the hand. */
  readonly live = signal(false);
  readonly problem = signal<string | null>(null);
  readonly question = signal<Question | null>(null);
  /** 0 shows the identity, 1 the match. */
  readonly morph = signal(1);

  /** The matches so far. */
  readonly runs = new Runs();

  readonly shapes;
  readonly canUndo;
  readonly canRedo;
  readonly preset;

  constructor(
    readonly engine: Engine,
    opened: Opened,
  ) {
    const { saved, problem } = opened;
    this.history = signal<History<Pair>>(begun(pairFrom(saved, saved.preset)));
    this.settings.value = saved.settings;
    this.problem.value = problem;
    this.shapes = computed<Shapes>(() => this.moving.value ?? this.history.value.present);
    this.canUndo = computed(() => this.history.value.past.length > 0);
    this.canRedo = computed(() => this.history.value.future.length > 0);
    this.preset = computed(() => this.history.value.present.preset);
    this.run = new Run(engine, {
      shapes: this.shapes,
      settings: this.settings,
      followsHand: () => this.live.value && this.moving.value !== null,
      say: (problem) => {
        this.problem.value = problem;
      },
    });
    this.rememberChanges(opened.remembered ? null : this.link());
    this.inspectChanges();
    this.keepRuns();
    effect(() => {
      if (this.shapes.value.pins.length === 0 || kit.peek()) return;
      fetchKit().catch((error: Error) => {
        this.problem.value = error.message;
      });
    });
  }

  /** Shows one of the matches so far, with the shapes and settings that it was computed from. */
  showAgain(result: Result): void {
    const { reference, template, pins } = this.history.value.present;
    this.settings.value = result.settings;
    if (result.reference !== reference || result.template !== template || result.pins !== pins)
      this.commit(pairFrom(result, null));
    this.morph.value = 1;
    this.run.restore(result.frame);
  }

  get phase() {
    return this.run.phase;
  }

  get loaded() {
    return this.run.loaded;
  }

  get match() {
    return this.run.match;
  }

  /** The match that is shown, with the shapes and settings that it was computed from. */
  get result() {
    return this.run.result;
  }

  /** What was other when the match that is shown was computed. */
  get outdated() {
    return this.run.outdated;
  }

  /** Whether the match that is shown belongs to other settings or pins than the present ones. */
  get stale() {
    return this.run.stale;
  }

  get fresh() {
    return this.run.fresh;
  }

  get inspection() {
    return this.run.inspection;
  }

  get energies() {
    return this.run.energies;
  }

  isExample(side: Side): boolean {
    return this.history.value.present.examples[side];
  }

  /** The shape while the hand is still moving. `at` is the time of the event. */
  previewShape(side: Side, shape: Shape, at: number): void {
    this.preview(edited(this.history.value.present, side, shape), at);
  }

  /** The pins while the hand moves one. */
  previewPins(pins: readonly Pin[], at: number): void {
    this.preview({ ...this.history.value.present, pins }, at);
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
      ...edited(this.shapes.value, side, shape),
      preset: null,
      examples: { ...present.examples, [side]: false },
    });
  }

  /** One step to undo. */
  commitPins(pins: readonly Pin[]): void {
    this.commit({ ...this.history.value.present, pins });
  }

  /** Scales both shapes to a comfortable size and centres them. */
  fit(): void {
    const { present } = this.history.value;
    const centred = (shapes: Shapes, side: Side) => edited(shapes, side, fitted(present[side]));
    this.commit({ ...present, ...centred(centred(present, "reference"), "template"), preset: null });
  }

  choosePreset(preset: Preset): void {
    this.commit(pairFrom({ ...preset, pins: [] }, preset.id));
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
    const { saved, problem, later } = open(hash, null);
    if (problem) {
      this.problem.value = problem;
      return;
    }
    this.settings.value = saved.settings;
    this.commit(pairFrom(saved, saved.preset));
    if (!later) this.glance();
  }

  /** Shows a saved match as it was; the shapes before it are one undo away. */
  restore({ settings, match, ...shapes }: MatchRecord): void {
    this.settings.value = settings;
    this.commit(pairFrom(shapes, null));
    // Nothing is to be computed, not even where the match follows the hand.
    if (!match) this.run.drop();
    else {
      this.morph.value = 1;
      this.run.restore(match);
    }
  }

  changeSetting(field: SettingField, value: number | string | boolean): void {
    this.settings.value = withSetting(this.settings.value, field, value);
    this.settingsChanged();
  }

  /** Chooses a value and matches with it. */
  tryOut(field: SettingField, value: number): void {
    this.changeSetting(field, value);
    if (!this.live.value && !this.empty) this.start();
  }

  /** Takes a grid of this level for the finest and matches on it. */
  matchOn(level: number): void {
    const finest = FIELDS.find((field) => field.name === "finest");
    if (finest) this.changeSetting(finest, level);
    if (!this.live.value) this.start();
  }

  /** The setting while its slider is still moving. `at` is the time of the event. */
  previewSetting(field: SettingField, value: number, at: number): void {
    if (this.live.value) this.follow(at);
    this.settings.value = withSetting(this.settings.value, field, value);
    if (!this.live.value) this.run.restartSoon();
  }

  resetSettings(): void {
    this.settings.value = {};
    this.settingsChanged();
  }

  /** Switching on begins with a full match, unless there is one to go on from. */
  setLive(on: boolean): void {
    this.live.value = on;
    if (!on && isFollowing(this.phase.value)) this.settle();
    if (!on || this.empty || this.run.upToDate) return;
    this.start();
  }

  /** A match without being asked for one: for whoever has just come, or has opened a link. */
  glance(): void {
    if (!this.empty) this.run.glance();
  }

  start(): void {
    this.run.start();
  }

  pause(): void {
    this.run.pause();
  }

  resume(): void {
    this.run.resume();
  }

  cancel(): void {
    this.run.cancel();
  }

  /** Whatever was said or asked is of what is no longer there. */
  dismiss(): void {
    this.problem.value = null;
    this.question.value = null;
  }

  /** The address that brings back what is on the page now. */
  link(): string {
    return encode({ ...this.history.value.present, settings: this.settings.value });
  }

  /** To be called when the match has been drawn. */
  drawn(): void {
    this.run.drawn(this.match.value);
  }

  private preview(shapes: Shapes, at: number): void {
    // Before the page is drawn anew: then the solver works while the page draws.
    if (this.live.value) this.follow(at);
    this.moving.value = shapes;
    if (!this.live.value) this.shapesChanged();
  }

  private commit(pair: Pair): void {
    this.moving.value = null;
    this.history.value = changed(this.history.value, pair);
    this.dismiss();
    this.shapesChanged();
  }

  private travel(to: History<Pair>): void {
    if (to === this.history.value) return;
    this.moving.value = null;
    this.history.value = to;
    this.dismiss();
    this.shapesChanged();
  }

  private get empty(): boolean {
    const { reference, template } = this.shapes.value;
    return reference.length === 0 || template.length === 0;
  }

  /** Something moves under the hand. What has just been refused waits until the problem is gone. */
  private follow(at: number): void {
    if (this.run.established || !this.problem.value) this.run.follow(at);
  }

  private settle(): void {
    if (this.empty) this.run.drop();
    else this.run.settle();
  }

  private settingsChanged(): void {
    this.dismiss();
    if (this.live.value) this.settle();
    else this.run.restartSoon();
  }

  private shapesChanged(): void {
    if (this.live.value) this.settle();
    else if (this.empty || isPaused(this.phase.value)) this.run.drop();
    else this.run.restartSoon();
  }

  /** What only follows the hand is no run to come back to. */
  private keepRuns(): void {
    effect(() => {
      const { result, stale, phase } = this.run;
      if (phase.value === "matched" && result.value && !stale.value && !this.live.value) this.runs.add(result.value);
    });
  }

  private inspectChanges(): void {
    effect(() => {
      const { reference, template } = this.history.value.present;
      void this.settings.value;
      clearTimeout(this.inspecting);
      this.run.changed();
      if (reference.length === 0 || template.length === 0) return;
      this.inspecting = setTimeout(() => this.run.inspect({ reference, template }), INSPECT_MILLIS);
    });
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

/** The shapes after one has been changed; its ends of the pins go along. */
function edited(shapes: Shapes, side: Side, shape: Shape): Shapes {
  const { pins } = shapes;
  const carried = pins.length > 0 && kit.peek()?.carried(pins, side, shapes[side], shape);
  return { ...shapes, [side]: shape, pins: carried || pins };
}

function pairFrom({ reference, template, pins }: Shapes, preset: string | null): Pair {
  const example = preset !== null;
  return { reference, template, pins, preset, examples: { reference: example, template: example } };
}

/** The setting fields whose value is not the default. */
export function changedFields(settings: Chosen): readonly SettingField[] {
  return FIELDS.filter((field) => settings[field.name] !== undefined);
}
