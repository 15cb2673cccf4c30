/** What the page knows: what has been drawn and chosen, the run of it, and what is said. Signals; no DOM. */

import { computed, effect, signal } from "@preact/signals";
import type { Engine } from "./engine";
import { linkIn, type Opened, reason } from "./link/open";
import { encode } from "./link/text";
import type { Memory } from "./memory/memory";
import { fetchKit, kit } from "./pins/kit";
import type { MatchRecord } from "./record";
import { type Result, Run } from "./run";
import { Runs } from "./runs";
import { Choices } from "./session/choices";
import { changeOf, Edits, edited, type Side, type Step, sameShapes, stepOf } from "./session/edits";
import { keepRuns } from "./session/keeping";
import { Live } from "./session/live";
import type { Looks } from "./session/looks";
import { inspectChanges } from "./session/narrow";
import type { Question } from "./session/question";
import { rememberChanges } from "./session/remembering";
import { Sharing } from "./session/sharing";
import { fitted, type Shape } from "./shapes/geometry";
import type { Pin, Shapes } from "./shapes/pins";
import type { Preset } from "./shapes/presets";
import { links } from "./words/links";
import { memory as words } from "./words/memory";

export type { Side } from "./session/edits";

export class Session {
  private readonly edits: Edits;
  private readonly run: Run;
  private readonly following: Live;
  private readonly sharing: Sharing;

  readonly problem = signal<string | null>(null);
  /** What stays true whatever is done next, until it has been read. */
  readonly notice = signal<string | null>(null);
  readonly question = signal<Question | null>(null);
  /** What the settings are chosen to be. */
  readonly choices: Choices;
  /** 0 shows the identity, 1 the match. */
  readonly morph = signal(1);

  /** The matches so far. */
  readonly runs = new Runs();

  readonly preset;
  /** As they are seen, under the hand too. */
  readonly shapes: Edits["shapes"];
  readonly settings: Edits["settings"];
  readonly canUndo: Edits["canUndo"];
  readonly canRedo: Edits["canRedo"];
  /** Whether the match follows the hand. */
  readonly live: Live["on"];
  readonly phase: Run["phase"];
  readonly loaded: Run["loaded"];
  readonly match: Run["match"];
  /** The match that is shown, with the shapes and settings that it was computed from. */
  readonly result: Run["result"];
  /** What was other when the match that is shown was computed. */
  readonly outdated: Run["outdated"];
  /** Whether the match that is shown belongs to other settings or pins than the present ones. */
  readonly stale: Run["stale"];
  readonly fresh: Run["fresh"];
  readonly inspection: Run["inspection"];
  readonly energies: Run["energies"];

  constructor(
    readonly engine: Engine,
    opened: Opened,
    looks: Looks,
    readonly memory: Memory,
  ) {
    const { saved, problem } = opened;
    this.edits = new Edits(stepOf(saved, saved.settings, saved.preset));
    const { edits } = this;
    this.shapes = edits.shapes;
    this.settings = edits.settings;
    this.canUndo = edits.canUndo;
    this.canRedo = edits.canRedo;
    this.problem.value = problem;
    this.preset = computed(() => edits.present.preset);
    this.run = new Run(engine, {
      shapes: this.shapes,
      settings: this.settings,
      followsHand: () => this.live.value && edits.moves,
      say: (problem) => {
        this.problem.value = problem;
      },
    });
    const { run } = this;
    this.phase = run.phase;
    this.loaded = run.loaded;
    this.match = run.match;
    this.result = run.result;
    this.outdated = run.outdated;
    this.stale = run.stale;
    this.fresh = run.fresh;
    this.inspection = run.inspection;
    this.energies = run.energies;
    this.following = new Live(run, this.shapes, this.problem);
    const { following } = this;
    this.live = following.on;
    this.choices = new Choices(edits, {
      get isEmpty() {
        return following.empty;
      },
      commit: (step) => this.commit(step),
      preview: (step, at) => this.preview(step, at),
      restored: () => following.changed("settings"),
      match: () => {
        if (!this.live.value) this.start();
      },
    });
    this.sharing = new Sharing(looks, this.morph, this.problem);
    const text = computed(() => this.link());
    rememberChanges(text, opened.unwritten ? null : encode(saved), (now) => memory.remember(now));
    memory.onFailure = () => {
      this.notice.value = words.failed;
    };
    this.sharing.look(saved);
    inspectChanges(
      computed(() => edits.present),
      run,
    );
    keepRuns(run, this.live, this.runs);
    effect(() => {
      if (this.shapes.value.pins.length === 0 || kit.peek()) return;
      fetchKit().catch((error: Error) => {
        this.problem.value = error.message;
      });
    });
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
      this.sharing.look(link.saved);
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
    return this.sharing.link(this.edits.present);
  }

  /** The same as an address of this page. */
  address(): string {
    return this.sharing.address(this.edits.present);
  }

  /** To be called when the match has been drawn. */
  drawn(): void {
    this.run.drawn(this.match.value);
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

  /** Goes to another step, if there is one. */
  private travel(go: () => boolean): void {
    const before = this.edits.present;
    if (!go()) return;
    this.dismiss();
    this.memory.keep(this.link());
    this.following.changed(changeOf(this.edits.present, before));
  }
}
