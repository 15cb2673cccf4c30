/** What has been drawn and chosen: every step of it can be undone. Signals; no DOM. */

import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { begun, changed, type History, redone, undone } from "../history";
import { kit } from "../pins/kit";
import type { Chosen } from "../settings";
import type { Shape } from "../shapes/geometry";
import type { Shapes } from "../shapes/pins";

export type Side = "reference" | "template";

/** One step: both shapes, their pins and the settings. */
export type Step = Shapes & {
  readonly settings: Chosen;
  /** The preset that both shapes are, untouched. */
  readonly preset: string | null;
  /** Which of them are untouched examples: the first stroke replaces those. */
  readonly examples: { readonly reference: boolean; readonly template: boolean };
};

export class Edits {
  private readonly history;
  /** While the hand moves something, before that is a step. */
  private readonly moving = signal<Step | null>(null);

  /** As they are seen, under the hand too; the same object until one of them changes. */
  readonly shapes: ReadonlySignal<Shapes>;
  readonly settings: ReadonlySignal<Chosen>;
  readonly canUndo: ReadonlySignal<boolean>;
  readonly canRedo: ReadonlySignal<boolean>;

  constructor(first: Step) {
    this.history = signal<History<Step>>(begun(first));
    const seen = computed(() => this.moving.value ?? this.history.value.present);
    const reference = computed(() => seen.value.reference);
    const template = computed(() => seen.value.template);
    const pins = computed(() => seen.value.pins);
    this.shapes = computed(() => ({ reference: reference.value, template: template.value, pins: pins.value }));
    this.settings = computed(() => seen.value.settings);
    this.canUndo = computed(() => this.history.value.past.length > 0);
    this.canRedo = computed(() => this.history.value.future.length > 0);
  }

  /** The last step; what moves under the hand is not yet in it. */
  get present(): Step {
    return this.history.value.present;
  }

  get moves(): boolean {
    return this.moving.value !== null;
  }

  /** As it is seen, under the hand too. */
  get seen(): Step {
    return this.moving.value ?? this.present;
  }

  preview(step: Step): void {
    this.moving.value = step;
  }

  /** Takes back what was previewed. */
  restore(): void {
    this.moving.value = null;
  }

  commit(step: Step): void {
    this.go(changed(this.history.value, step));
  }

  /** Whether there was anything to undo. */
  undo(): boolean {
    return this.go(undone(this.history.value));
  }

  redo(): boolean {
    return this.go(redone(this.history.value));
  }

  private go(to: History<Step>): boolean {
    if (to === this.history.value) return false;
    this.moving.value = null;
    this.history.value = to;
    return true;
  }
}

/** A step of shapes that come as a whole. */
export function stepOf({ reference, template, pins }: Shapes, settings: Chosen, preset: string | null): Step {
  const example = preset !== null;
  return { reference, template, pins, settings, preset, examples: { reference: example, template: example } };
}

/** The step after one shape has been changed; its ends of the pins go along. */
export function edited(step: Step, side: Side, shape: Shape): Step {
  const { pins } = step;
  const carried = pins.length > 0 && kit.peek()?.carried(pins, side, step[side], shape);
  return { ...step, [side]: shape, pins: carried || pins };
}

export function sameShapes(a: Shapes, b: Shapes): boolean {
  return a.reference === b.reference && a.template === b.template && a.pins === b.pins;
}

/** What a step has changed. */
export function changeOf(now: Step, before: Step): "shapes" | "settings" {
  return sameShapes(now, before) ? "settings" : "shapes";
}
