/** What the page knows: what has been drawn and chosen, the run of it, and what is said. Signals; no DOM. */

import { computed, effect, signal } from "@preact/signals";
import type { Engine } from "./engine";
import { addressOf, linkIn, type Opened, reason } from "./link/open";
import { encode, type Saved } from "./link/text";
import type { Memory } from "./memory/memory";
import { fetchKit, kit } from "./pins/kit";
import type { MatchRecord } from "./record";
import { type Result, Run } from "./run";
import { Runs } from "./runs";
import { Edits, edited, type Side, type Step, sameShapes, stepOf } from "./session/edits";
import { Live } from "./session/live";
import type { Looks } from "./session/looks";
import { inspectChanges } from "./session/narrow";
import { rememberChanges } from "./session/remembering";
import { type Chosen, FIELDS, type SettingField, sameSettings, withSetting } from "./settings";
import { fitted, type Loop, type Shape } from "./shapes/geometry";
import type { Pin, Shapes } from "./shapes/pins";
import type { Preset } from "./shapes/presets";
import { links } from "./words/links";
import { memory as words } from "./words/memory";

export type { Side } from "./session/edits";

/** What is to be decided before a stroke becomes a shape. */
export type Question = {
  readonly side: Side;
  /** What has been drawn. */
  readonly loop: Loop;
  readonly words: string;
  readonly ways: readonly { readonly label: string; readonly go: () => void }[];
};

export class Session {
  private readonly edits: Edits;
  private readonly run: Run;
  private readonly following: Live;

  readonly problem = signal<string | null>(null);
  /** What stays true whatever is done next, until it has been read. */
  readonly notice = signal<string | null>(null);
  readonly question = signal<Question | null>(null);
  /** 0 shows the identity, 1 the match. */
  readonly morph = signal(1);

  /** The matches so far. */
  readonly runs = new Runs();

  readonly preset;

  constructor(
    readonly engine: Engine,
    opened: Opened,
    private readonly looks: Looks,
    readonly memory: Memory,
  ) {
    const { saved, problem } = opened;
    this.edits = new Edits(stepOf(saved, saved.settings, saved.preset));
    this.problem.value = problem;
    this.preset = computed(() => this.edits.present.preset);
    this.run = new Run(engine, {
      shapes: this.shapes,
      settings: this.settings,
      followsHand: () => this.live.value && this.edits.moves,
      say: (problem) => {
        this.problem.value = problem;
      },
    });
    this.following = new Live(this.run, this.shapes, this.problem);
    const text = computed(() => this.link());
    rememberChanges(text, opened.unwritten ? null : encode(saved), (now) => memory.remember(now));
    memory.onFailure = () => {
      this.notice.value = words.failed;
    };
    this.look(saved);
    inspectChanges(
      computed(() => this.edits.present),
      this.run,
    );
    this.keepRuns();
    effect(() => {
      if (this.shapes.value.pins.length === 0 || kit.peek()) return;
      fetchKit().catch((error: Error) => {
        this.problem.value = error.message;
      });
    });
  }

  /** As they are seen, under the hand too. */
  get shapes() {
    return this.edits.shapes;
  }

  get settings() {
    return this.edits.settings;
  }

  get canUndo() {
    return this.edits.canUndo;
  }

  get canRedo() {
    return this.edits.canRedo;
  }

  /** Whether the match follows the hand. */
  get live() {
    return this.following.on;
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
    return this.edits.present.examples[side];
  }

  /** The shape while the hand is still moving. `at` is the time of the event. */
  previewShape(side: Side, shape: Shape, at: number): void {
    this.preview(edited(this.edits.present, side, shape), at);
  }

  /** What stands in the history, whatever the hand moves. */
  get present(): Step {
    return this.edits.present;
  }

  /** Whether something moves under the hand. */
  get moves(): boolean {
    return this.edits.moves;
  }

  /** Shapes and pins while the hand changes them. */
  previewShapes(shapes: Shapes, at: number): void {
    this.preview({ ...this.edits.present, ...shapes }, at);
  }

  /** The pins while the hand moves one. */
  previewPins(pins: readonly Pin[], at: number): void {
    this.preview({ ...this.edits.present, pins }, at);
  }

  /** The setting while its slider is still moving. */
  previewSetting(field: SettingField, value: number, at: number): void {
    this.preview(this.withSetting(field, value), at);
  }

  /** Takes back what was previewed. */
  restoreShape(): void {
    this.edits.restore();
    this.following.changed("shapes");
  }

  /** One step to undo. */
  commitShape(side: Side, shape: Shape): void {
    const { present } = this.edits;
    const { reference, template, pins } = edited(this.edits.seen, side, shape);
    const examples = { ...present.examples, [side]: false };
    this.commit({ ...present, reference, template, pins, preset: null, examples });
  }

  /** One step to undo. */
  commitPins(pins: readonly Pin[]): void {
    this.commit({ ...this.edits.present, pins });
  }

  /** Both shapes with their pins; one step to undo. */
  commitShapes(shapes: Shapes, examples: Step["examples"]): void {
    this.commit({ ...this.edits.present, ...shapes, examples, preset: null });
  }

  /** Scales both shapes to a comfortable size and centres them. */
  fit(): void {
    const { present } = this.edits;
    const centred = (step: Step, side: Side) => edited(step, side, fitted(present[side]));
    this.commit({ ...centred(centred(present, "reference"), "template"), preset: null });
  }

  choosePreset(preset: Preset): void {
    this.commit(stepOf({ ...preset, pins: [] }, this.settings.value, preset.id));
    this.start();
  }

  undo(): void {
    this.travel(() => this.edits.undo());
  }

  redo(): void {
    this.travel(() => this.edits.redo());
  }

  /** Shows what a link holds; what was before it is one undo away. One that cannot be read changes nothing. */
  openLink(hash: string): void {
    try {
      const link = linkIn(hash);
      if (!link) return;
      this.commit(stepOf(link.saved, link.saved.settings, link.saved.preset));
      this.look(link.saved);
      if (!link.later) this.glance();
    } catch (error) {
      this.problem.value = links.kept(reason(error));
      this.memory.remember(this.link());
    }
  }

  /** Shows a saved match as it was; what was before it is one undo away. */
  restore({ settings, match, ...shapes }: MatchRecord): void {
    this.commit(stepOf(shapes, settings, null));
    // Nothing is to be computed, not even where the match follows the hand.
    if (!match) this.run.drop();
    else {
      this.morph.value = 1;
      this.run.restore(match);
    }
  }

  /** Shows one of the matches so far, with the shapes and settings that it was computed from. */
  showAgain(result: Result): void {
    const { present } = this.edits;
    if (!sameShapes(result, present)) this.commit(stepOf(result, result.settings, null));
    else if (result.settings !== present.settings) this.commit({ ...present, settings: result.settings });
    this.morph.value = 1;
    this.run.restore(result.frame);
  }

  /** One step to undo, unless it is what it was. */
  changeSetting(field: SettingField, value: number | string | boolean): void {
    this.choose(this.withSetting(field, value));
  }

  /** Chooses a value and matches with it. */
  tryOut(field: SettingField, value: number): void {
    this.changeSetting(field, value);
    if (!this.live.value && !this.following.empty) this.start();
  }

  /** Takes a grid of this level for the finest and matches on it. */
  matchOn(level: number): void {
    const finest = FIELDS.find((field) => field.name === "finest");
    if (finest) this.changeSetting(finest, level);
    if (!this.live.value) this.start();
  }

  resetSettings(): void {
    this.choose({ ...this.edits.present, settings: {} });
  }

  setLive(on: boolean): void {
    this.following.set(on);
  }

  /** A match without being asked for one: for whoever has just come, or has opened a link. */
  glance(): void {
    if (!this.following.empty) this.run.glance();
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

  /** What brings back everything that is on the page now. */
  link(): string {
    return encode({ ...this.edits.present, view: this.looks.view.value, morph: this.morph.value });
  }

  /** The same as an address of this page. */
  address(): string {
    const url = new URL(addressOf(this.link()));
    // Whoever opens it reads it in a language of theirs.
    url.searchParams.delete("lang");
    return url.href;
  }

  /** To be called when the match has been drawn. */
  drawn(): void {
    this.run.drawn(this.match.value);
  }

  private look({ view, morph }: Pick<Saved, "view" | "morph">): void {
    this.morph.value = morph;
    if (view === this.looks.view.peek()) return;
    this.looks.choose(view).catch((error) => {
      this.problem.value = reason(error);
    });
  }

  private withSetting(field: SettingField, value: number | string | boolean): Step {
    return { ...this.edits.present, settings: withSetting(this.edits.present.settings, field, value) };
  }

  private preview(step: Step, at: number): void {
    const what = changeOf(step, this.edits.present);
    this.following.moving(at);
    this.edits.preview(step);
    this.following.moved(what);
  }

  private commit(step: Step): void {
    this.travel(() => {
      this.edits.commit(step);
      return true;
    });
  }

  private choose(step: Step): void {
    if (!sameSettings(step.settings, this.edits.present.settings)) this.commit(step);
    else if (this.edits.moves) {
      this.edits.restore();
      this.following.changed("settings");
    }
  }

  /** Goes to another step, if there is one. */
  private travel(go: () => boolean): void {
    const before = this.edits.present;
    if (!go()) return;
    this.dismiss();
    this.memory.keep(this.link());
    this.following.changed(changeOf(this.edits.present, before));
  }

  /** What only follows the hand is no run to come back to. */
  private keepRuns(): void {
    effect(() => {
      const { result, stale, phase } = this.run;
      if (phase.value === "matched" && result.value && !stale.value && !this.live.value) this.runs.add(result.value);
    });
  }
}

function changeOf(now: Step, before: Step): "shapes" | "settings" {
  return sameShapes(now, before) ? "settings" : "shapes";
}

/** The setting fields whose value is not the default. */
export function changedFields(settings: Chosen): readonly SettingField[] {
  return FIELDS.filter((field) => settings[field.name] !== undefined);
}
