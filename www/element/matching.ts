/** Two shapes and their match, as the element holds them: each element has its own. Signals; no DOM. */

import { computed, effect, signal } from "@preact/signals";
import { decode } from "../link/text";
import { isDone } from "../phase";
import { Run } from "../run";
import type { Chosen } from "../settings";
import type { Loop } from "../shapes/geometry";
import { isInBox, type Shapes } from "../shapes/pins";
import { mapped } from "../view/field";
import { VIEWS, type View } from "../view/names";
import { engine } from "./engine";

/** A closed polygon: x y x y …, or a list of points. */
export type GivenLoop = ArrayLike<number> | readonly GivenPoint[];
export type GivenPoint = readonly [x: number, y: number];
export type GivenPin = readonly [x: number, y: number, u: number, v: number];

export class Matching {
  readonly shapes = signal<Shapes>({ reference: [], template: [], pins: [] });
  readonly settings = signal<Chosen>({});
  readonly view = signal<View>("grid");
  readonly morph = signal(1);
  readonly problem = signal<string | null>(null);
  private readonly run = new Run(engine(), {
    shapes: this.shapes,
    settings: this.settings,
    followsHand: () => false,
    say: (problem) => {
      this.problem.value = problem;
    },
  });
  readonly phase = this.run.phase;
  readonly match = this.run.match;
  /** The match of what is given now, once it is final. */
  readonly final = computed(() => (isDone(this.phase.value) && !this.run.stale.value ? this.match.value : null));

  /** Matches what is given, unless a side is still missing. */
  start(): void {
    const { reference, template } = this.shapes.peek();
    if (reference.length > 0 && template.length > 0) this.run.start();
  }

  /** What a link of the page holds. Throws a sentence's part, and then nothing has changed. */
  set(state: string): void {
    const { reference, template, pins, settings, view, morph } = decode(state.replace(/^#/, ""));
    this.shapes.value = { reference, template, pins };
    this.settings.value = settings;
    this.view.value = view;
    this.morph.value = morph;
  }

  setShape(side: "reference" | "template", loops: readonly GivenLoop[]): void {
    if (!Array.isArray(loops)) throw new Error(`the ${side} must be a list of loops`);
    this.shapes.value = { ...this.shapes.peek(), [side]: loops.map((loop) => loopFrom(loop, side)) };
  }

  setPins(pins: readonly GivenPin[]): void {
    if (!Array.isArray(pins) || !pins.every((pin) => isNumbers(pin, 4)))
      throw new Error("pins must be a list of [x, y, u, v]: a point of the reference and one of the template");
    this.shapes.value = {
      ...this.shapes.peek(),
      pins: pins.map(([x, y, u, v]) => ({ reference: { x, y }, template: { x: u, y: v } })),
    };
  }

  /** The solver says which of them there are not. */
  setSettings(settings: Chosen): void {
    if (typeof settings !== "object" || settings === null)
      throw new Error("settings must be an object, like { bending: 0 }");
    this.settings.value = { ...settings };
  }

  setMorph(part: number): void {
    if (!(part >= 0 && part <= 1)) throw new Error("morph must be a number from 0 to 1");
    this.morph.value = part;
  }

  setView(name: string): void {
    const known = VIEWS.find((view) => view === name);
    if (!known) throw new Error(`there is no view “${name}”; there are ${VIEWS.join(", ")}`);
    this.view.value = known;
  }

  /** φ at points of the box; null without a match. */
  map(points: readonly GivenPoint[]): [number, number][] | null {
    if (
      !Array.isArray(points) ||
      !Array.from(points).every((point) => isNumbers(point, 2) && isInBox(point[0]) && isInBox(point[1]))
    )
      throw new Error("points must be a list of points [x, y] of the box, from 0 to 1");
    const match = this.match.peek();
    if (!match) return null;
    const grid = { cells: 2 ** match.status.level, deformation: match.deformation };
    return points.map(([x, y]) => mapped(grid, x, y));
  }

  /** Tells of each final match. Returns how to stop that. */
  whenFinal(tell: () => void): () => void {
    return effect(() => {
      if (this.final.value) tell();
    });
  }

  dispose(): void {
    this.run.drop();
  }
}

function isNumbers(given: unknown, count: number): boolean {
  const all = Array.isArray(given) || ArrayBuffer.isView(given) ? Array.from(given as ArrayLike<unknown>) : [];
  return all.length === count && all.every(Number.isFinite);
}

function loopFrom(given: GivenLoop, side: string): Loop {
  // Of nothing, a number or a text there are no points.
  const numbers =
    typeof given === "object" && given ? Array.from(given as ArrayLike<number | readonly number[]>).flat() : [];
  if (numbers.length < 6 || numbers.length % 2 !== 0 || !numbers.every(Number.isFinite))
    throw new Error(`each loop of the ${side} must be at least three points, as [[x, y], …] or x y x y …`);
  return Float64Array.from(numbers);
}
