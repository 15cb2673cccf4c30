/** What the page knows of surfaces: what is chosen, the run of it, how it is looked at. Signals; no DOM. */

import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { Delay } from "../delay";
import type { Engine } from "../engine";
import { begun, changed, redone, undone } from "../history";
import { isPaused, isRunning, isWorking, next, type Phase, type PhaseEvent } from "../phase";
import type { AnyFrame } from "../protocol";
import { sentence } from "../run";
import { type Chosen, type SettingField, sameSettings, withSetting } from "../settings";
import { Solver } from "../solver";
import { space as say } from "../words/space";
import { type Pose, START } from "./camera";
import { flat, type Pin, samePins } from "./pins";
import type { Plane } from "./slice";
import type { Solid, Vector } from "./solid";

export type Side = "reference" | "template";
export const SIDES: readonly Side[] = ["reference", "template"];

export type View = "colours" | "area" | "distance" | "slice";
export const VIEWS: readonly View[] = ["colours", "area", "distance", "slice"];

/** One step that can be undone. */
export type Step = {
  readonly reference: Solid;
  readonly template: Solid;
  readonly pins: readonly Pin[];
  readonly settings: Chosen;
};

export type SolidFrame = AnyFrame & {
  /** φ at the nodes of the level, x y z a node, x fastest. */
  readonly deformation: Float64Array;
  /** φ at the reference's vertices. */
  readonly matched: Float64Array;
  /** φ⁻¹ at the template's vertices, once the match is final; not a number outside of the image of the box. */
  readonly partners: Float64Array | null;
};

/** A match with what it was computed from. */
export type Result = Step & { readonly frame: SolidFrame };

export type Look = {
  readonly view: View;
  readonly morph: number;
  readonly plane: Plane;
  readonly pose: Pose;
};

/** A point of the reference and the one of the template that it goes to. */
export type Partners = { readonly reference: Vector; readonly template: Vector };

export const FIRST_LOOK: Look = { view: "colours", morph: 1, plane: { axis: 2, part: 0.5 }, pose: START };

const RESTART_MILLIS = 250;

export class SpaceSession {
  private readonly solver: Solver<SolidFrame>;
  private readonly history;
  private readonly state = signal<Phase>("idle");
  private readonly last = signal<Result | null>(null);
  private readonly restarting = new Delay(RESTART_MILLIS);
  private sent: Step | null = null;

  /** Whether a match begins with every change. */
  readonly live = signal(false);
  readonly problem = signal<string | null>(null);
  readonly loaded = signal(false);
  /** Whether the result belongs to the run under way, not to the one before. */
  readonly fresh = signal(false);
  readonly phase: ReadonlySignal<Phase> = this.state;

  readonly view = signal<View>("colours");
  readonly morph = signal(1);
  readonly plane = signal<Plane>(FIRST_LOOK.plane);
  readonly pose = signal<Pose>(START);
  /** Whether a press on a surface sets a pin. */
  readonly pinning = signal(false);
  /** The end of a pin that waits for its partner. */
  readonly begun = signal<{ readonly side: Side; readonly point: Vector } | null>(null);
  /** Pins while the hand moves one. */
  readonly moving = signal<readonly Pin[] | null>(null);
  readonly pins = computed(() => this.moving.value ?? this.step.value.pins);
  /** The template, seen through the match. */
  readonly showsTarget = signal(false);

  readonly step;
  readonly canUndo;
  readonly canRedo;

  /** What is shown: nothing of surfaces that are no longer chosen, unless a new run is on. */
  readonly result = computed(() => {
    const last = this.last.value;
    return last && (isRunning(this.state.value) || sameSurfaces(last, this.step.value)) ? last : null;
  });
  /** The last frame of each level of the run, coarsest first. */
  private readonly ends = signal<readonly Result[]>([]);
  /** The level whose match is shown; null for the last. */
  readonly chosenLevel = signal<number | null>(null);
  /** Levels that can be looked back to. */
  readonly levels = computed(() => (this.result.value ? this.ends.value.map(({ frame }) => frame.status.level) : []));
  /** The match after the chosen level. */
  readonly shown = computed(() => {
    const end = this.ends.value.find(({ frame }) => frame.status.level === this.chosenLevel.value);
    return this.result.value && (end ?? this.result.value);
  });
  /** What is under the pointer, and where it belongs. */
  readonly partners = signal<Partners | null>(null);
  readonly stale = computed(() => {
    const result = this.result.value;
    if (result === null || isWorking(this.state.value)) return false;
    const { settings, pins } = this.step.value;
    return !sameSettings(result.settings, settings) || !samePins(result.pins, pins);
  });

  constructor(engine: Engine, step: Step, look: Look = FIRST_LOOK) {
    this.history = signal(begun(step));
    this.step = computed(() => this.history.value.present);
    this.canUndo = computed(() => this.history.value.past.length > 0);
    this.canRedo = computed(() => this.history.value.future.length > 0);
    this.look(look);
    this.solver = new Solver<SolidFrame>(engine, {
      ready: () => {
        this.loaded.value = true;
      },
      frame: (frame) => this.receive(frame),
      refused: (message) => this.fail(sentence(message)),
      unavailable: (message) => this.fail(sentence(message)),
      crashed: (message) => this.fail(say.crashed(message)),
    });
  }

  look({ view, morph, plane, pose }: Look): void {
    this.view.value = view;
    this.morph.value = morph;
    this.plane.value = plane;
    this.pose.value = pose;
  }

  start(): void {
    this.restarting.stop();
    this.problem.value = null;
    this.advance("start");
    this.sent = this.step.value;
    this.fresh.value = false;
    this.ends.value = [];
    this.chosenLevel.value = null;
    const { reference, template, pins, settings } = this.sent;
    this.solver.start(mesh(reference), mesh(template), { ...settings, pins: flat(pins) });
  }

  /** Switching on begins a match, unless there is one of what is chosen. */
  setLive(on: boolean): void {
    this.live.value = on;
    if (!on || isWorking(this.state.value)) return;
    if (this.result.value === null || this.stale.value) this.start();
  }

  pause(): void {
    if (this.advance("pause")) this.solver.pause();
  }

  /** What has been chosen since the pause counts. */
  resume(): void {
    if (this.sent !== this.step.value) this.start();
    else if (this.advance("resume")) this.solver.resume();
  }

  cancel(): void {
    this.end("cancel");
    this.solver.cancel();
  }

  /** One step to undo. Pins lead to surfaces: they go with them, unless others come. */
  commit(change: Partial<Step>): void {
    this.problem.value = null;
    this.begun.value = null;
    const kept = change.reference || change.template ? { pins: [] } : {};
    this.history.value = changed(this.history.value, { ...this.step.value, ...kept, ...change });
    this.follow();
  }

  undo(): void {
    this.begun.value = null;
    this.history.value = undone(this.history.value);
    this.follow();
  }

  redo(): void {
    this.begun.value = null;
    this.history.value = redone(this.history.value);
    this.follow();
  }

  changeSetting(field: SettingField, value: number | string | boolean): void {
    const settings = withSetting(this.step.value.settings, field, value);
    if (!sameSettings(settings, this.step.value.settings)) this.commit({ settings });
  }

  /** One end of a pin; with the other one there already, the pin. */
  setPin(side: Side, point: Vector): void {
    const begun = this.begun.value;
    if (!begun || begun.side === side) this.begun.value = { side, point };
    else {
      const pin = { [side]: point, [begun.side]: begun.point } as Pin;
      this.commit({ pins: [...this.step.value.pins, pin] });
    }
  }

  dispose(): void {
    this.restarting.stop();
    this.solver.dispose();
  }

  /** With Live, or while a run is under way, a match begins with what has changed; otherwise the user decides. */
  private follow(): void {
    const phase = this.state.value;
    if (isPaused(phase)) return;
    if (this.live.value || isWorking(phase)) this.restarting.start(() => this.start());
  }

  private receive(frame: SolidFrame): void {
    if (!this.sent) return;
    const result = { ...this.sent, frame };
    this.last.value = result;
    this.ends.value = [...this.ends.value.filter((end) => end.frame.status.level < frame.status.level), result];
    this.fresh.value = true;
    this.advance(frame.status.finished ? "finish" : "frame");
  }

  private fail(message: string): void {
    this.end("drop");
    this.problem.value = message;
  }

  private end(event: "cancel" | "drop"): void {
    this.restarting.stop();
    this.advance(event);
    this.last.value = null;
  }

  /** Whether the event has changed the state. */
  private advance(event: PhaseEvent): boolean {
    const before = this.state.value;
    this.state.value = next(before, event);
    return this.state.value !== before;
  }
}

function sameSurfaces(a: Step, b: Step): boolean {
  return a.reference === b.reference && a.template === b.template;
}

function mesh({ positions, indices }: Solid) {
  return { kind: "mesh" as const, positions, indices };
}
