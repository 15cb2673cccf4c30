import type { ReadonlySignal } from "@preact/signals";
import type { RefObject } from "preact";
import { space as say } from "../words/space";
import { type Lens, lensOf, projected, rayThrough } from "./camera";
import type { Shown } from "./partners";
import { picked, pointOf } from "./pick";
import { carried, type Pin, withEnd, without } from "./pins";
import type { Side, SpaceSession } from "./session";
import { minus, type Vector } from "./solid";

type View = {
  readonly session: SpaceSession;
  readonly shown: Shown;
  readonly morph: ReadonlySignal<number>;
  readonly canvas: RefObject<HTMLCanvasElement | null>;
  /** Of the canvas; nothing before it is on the page. */
  readonly size: ReadonlySignal<Size>;
};

/** Pixels. */
export type Size = { readonly width: number; readonly height: number };

/** What a pin moves by an arrow key, in pixels. */
const STEP = 6;
/** A pin so much farther away than what is seen in its place lies behind it. Box lengths. */
const BEHIND = 0.01;

/** The pins over one of the views, by number; those of the two sides are moved and deleted there. */
export function PinMarks({ session, shown, morph, canvas, size }: View) {
  const pins = session.pins.value;
  const begun = session.begun.value;
  const [seen, target] = [size.value, canvas.current];
  if (!target || seen.width === 0 || (pins.length === 0 && !session.pinning.value)) return null;
  const lens = lensOf(session.pose.value);
  const solid = shown === "result" ? null : session.step.value[shown];
  const mark = (point: Vector) => ({ style: place(lens, point, seen), "data-behind": isBehind(lens, point, solid) });
  if (shown === "result") {
    const result = session.shown.value;
    if (!result) return null;
    const { reference, frame } = result;
    return result.pins.map((pin, i) => {
      const to = carried(pin.reference, reference.positions, frame.matched);
      const [x, y, z] = [0, 1, 2].map((k) => pin.reference[k] + morph.value * (to[k] - pin.reference[k]));
      return (
        <span key={numbered(i)} class="pin" style={place(lens, [x, y, z], seen)} aria-hidden="true">
          {i + 1}
        </span>
      );
    });
  }
  return (
    <>
      {pins.map((pin, i) => (
        <button
          key={numbered(i)}
          type="button"
          class="pin"
          aria-label={say.pins.name(i + 1, shown)}
          aria-describedby="space-pins"
          {...mark(pin[shown])}
          {...hold(session, shown, i, target)}
        >
          {i + 1}
        </button>
      ))}
      {begun?.side === shown && (
        <span class="pin begun" {...mark(begun.point)} aria-hidden="true">
          {pins.length + 1}
        </span>
      )}
      {session.pinning.value && <span class="cross" aria-hidden="true" />}
    </>
  );
}

/** Sets an end of a pin where the canvas has been pressed, or in its middle. */
export function setPin(session: SpaceSession, side: Side, canvas: HTMLCanvasElement, at?: Pixel): void {
  const point = pointAt(session, side, canvas, at ?? { x: canvas.clientWidth / 2, y: canvas.clientHeight / 2 });
  if (point) session.setPin(side, point);
}

export type Pixel = { readonly x: number; readonly y: number };

/** What a pin does under the hand: it is dragged along its surface, stepped by arrows, and deleted. */
function hold(session: SpaceSession, side: Side, index: number, canvas: HTMLCanvasElement) {
  const move = (at: Pixel) => {
    const point = pointAt(session, side, canvas, at);
    if (point) session.moving.value = withEnd(session.step.value.pins, index, side, point);
  };
  const end = () => {
    const pins = session.moving.value;
    session.moving.value = null;
    if (pins) session.commit({ pins });
  };
  const stop = () => {
    session.moving.value = null;
  };
  return {
    onPointerDown: (event: PointerEvent) => (event.currentTarget as Element).setPointerCapture(event.pointerId),
    onPointerMove: ({ currentTarget, pointerId, clientX, clientY }: PointerEvent) => {
      if (!(currentTarget as Element).hasPointerCapture(pointerId)) return;
      const { left, top } = canvas.getBoundingClientRect();
      move({ x: clientX - left, y: clientY - top });
    },
    onPointerUp: end,
    onPointerCancel: stop,
    onKeyUp: end,
    onBlur: end,
    onKeyDown: (event: KeyboardEvent) => {
      const [x, y] = ARROWS[event.key] ?? [0, 0];
      if (x !== 0 || y !== 0) {
        const [right, up] = projected(lensOf(session.pose.peek()), session.pins.peek()[index][side]);
        const from = pixel({ width: canvas.clientWidth, height: canvas.clientHeight }, right, up);
        move({ x: from.x + STEP * x, y: from.y + STEP * y });
      } else if (event.key === "Delete" || event.key === "Backspace") {
        stop();
        session.commit({ pins: without(session.step.value.pins, index) });
        canvas.focus();
      } else if (event.key === "Escape") stop();
      else return;
      event.preventDefault();
    },
  };
}

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** The point of the surface that is seen there. */
function pointAt(session: SpaceSession, side: Side, canvas: HTMLCanvasElement, { x, y }: Pixel): Vector | null {
  const { clientWidth: width, clientHeight: height } = canvas;
  const lens = lensOf(session.pose.peek());
  const { positions, indices } = session.step.peek()[side];
  const hit = picked(
    lens.eye,
    rayThrough(lens, (2 * x - width) / height, (height - 2 * y) / height),
    positions,
    indices,
  );
  return hit && pointOf(hit, positions, indices);
}

function pixel({ width, height }: Size, right: number, up: number): Pixel {
  return { x: (width + height * right) / 2, y: (height - height * up) / 2 };
}

function place(lens: Lens, point: Vector, size: Size) {
  const [right, up] = projected(lens, point);
  const { x, y } = pixel(size, right, up);
  return { left: `${x}px`, top: `${y}px` };
}

function isBehind(
  lens: Lens,
  point: Vector,
  solid: Pick<SpaceSession["step"]["value"]["reference"], "positions" | "indices"> | null,
) {
  if (!solid) return false;
  const ray = minus(point, lens.eye);
  const hit = picked(lens.eye, ray, solid.positions, solid.indices);
  const away = (to: Vector) => Math.hypot(...minus(to, lens.eye));
  return hit !== null && away(point) > away(pointOf(hit, solid.positions, solid.indices)) + BEHIND;
}

/** Pins have no names but their numbers. */
function numbered(index: number): string {
  return `pin ${index}`;
}

/** Whether presses set pins, and how that is done. */
export function PinActions({ session }: { session: SpaceSession }) {
  const pins: readonly Pin[] = session.pins.value;
  return (
    <>
      <button
        type="button"
        aria-pressed={session.pinning.value}
        title={say.pins.help}
        onClick={() => {
          session.pinning.value = !session.pinning.value;
          session.begun.value = null;
        }}
      >
        {say.pins.set}
      </button>
      {pins.length > 0 && (
        <button type="button" onClick={() => session.commit({ pins: [] })}>
          {say.pins.deleteAll}
        </button>
      )}
    </>
  );
}

/** What is to be done next; spoken, too. */
export function PinGuide({ session }: { session: SpaceSession }) {
  const begun = session.begun.value;
  const count = session.step.value.pins.length;
  return (
    <p id="space-pins" class="help" aria-live="polite">
      {begun ? say.pins.begun(count + 1, begun.side) : session.pinning.value ? say.pins.guide : ""}
      {count > 0 && !begun && ` ${say.pins.keys}`}
    </p>
  );
}
