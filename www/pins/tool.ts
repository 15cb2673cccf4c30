/** Sets, moves and deletes pins on one of the two surfaces, by pointer and by key. */

import type { Point } from "../shapes/geometry";
import { MOST_PINS, type Pin, type Shapes } from "../shapes/pins";
import { drawCursor, stepped } from "../tools/cursor";
import { type Contact, type Ground, TARGET, type Tool } from "../tools/hand";
import { said } from "../tools/tool";
import type { Frame } from "../view/canvas";
import type { Theme } from "../view/palette";
import { place } from "../words/place";
import { drawPin } from "./draw";
import { begun, chosen } from "./kit";
import { snapped, withEnd, without } from "./places";
import { told } from "./words";

export interface PinHost extends Ground {
  shapes(): Shapes;
  /** The pins while the hand moves one; `at` is the time of the event. */
  preview(pins: readonly Pin[], at: number): void;
  restore(): void;
  /** One step to undo. */
  commit(pins: readonly Pin[]): void;
  /** Puts the keyboard on the other surface. */
  goOn(): void;
}

/** A pin set so near to its curve lies on it. CSS pixels. */
const SNAP = 16;

type Gesture =
  | { readonly kind: "set"; point: Point }
  | { readonly kind: "move"; readonly index: number; readonly before: readonly Pin[]; moved: boolean };

export class PinTool implements Tool {
  private readonly host: PinHost;
  private gesture: Gesture | null = null;
  private cursor: Point | null = null;
  /** The pin that the arrow keys carry, and the pins as they were. */
  private carried: { readonly index: number; readonly before: readonly Pin[] } | null = null;

  constructor(host: PinHost) {
    this.host = host;
  }

  cancel(): void {
    if ((this.gesture?.kind === "move" && this.gesture.moved) || this.carried) this.host.restore();
    this.gesture = null;
    this.carried = null;
    this.host.repaint();
  }

  key(event: KeyboardEvent): boolean {
    const { pins } = this.host.shapes();
    const at = this.cursor ?? this.end(chosen.value ?? -1) ?? { x: 0.5, y: 0.5 };
    const next = stepped(at, event);
    if (next) this.walk(next, event.timeStamp);
    else if (event.key === "Enter" || event.key === " ") this.enter(at);
    else if (event.key === "PageDown" || event.key === "PageUp") this.leap(event.key === "PageDown" ? 1 : -1);
    else if (event.key === "Escape") this.escape();
    else if (event.key === "Delete" || event.key === "Backspace") {
      if (chosen.value !== null && pins[chosen.value]) this.remove(chosen.value);
    } else return false;
    this.host.repaint();
    return true;
  }

  paint(context: CanvasRenderingContext2D, frame: Frame, colours: Theme): void {
    const waiting = begun.value?.side === this.host.side ? begun.value.point : null;
    const tentative = this.gesture?.kind === "set" ? this.snapped(this.gesture.point) : waiting;
    if (tentative) {
      drawPin(context, frame, colours, tentative, this.host.shapes().pins.length, colours.muted, true);
    }
    if (this.cursor && document.activeElement === this.host.canvas) drawCursor(context, frame, colours, this.cursor);
  }

  press({ point, kind }: Contact): void {
    this.cursor = null;
    const index = this.pinAt(point, TARGET[kind]);
    if (index === null) this.gesture = { kind: "set", point };
    else {
      this.gesture = { kind: "move", index, before: this.host.shapes().pins, moved: false };
      this.choose(index);
    }
  }

  hover(contact: Contact | null): string {
    return contact && this.pinAt(contact.point, TARGET[contact.kind]) !== null ? "grab" : "crosshair";
  }

  drag({ point, at }: Contact): void {
    const { gesture } = this;
    if (gesture?.kind === "set") gesture.point = point;
    if (gesture?.kind !== "move") return;
    const { index, before } = gesture;
    const from = before[index][this.host.side];
    gesture.moved ||= Math.hypot(point.x - from.x, point.y - from.y) * this.host.pixelsPerUnit > 4;
    if (gesture.moved) this.host.preview(withEnd(before, index, this.host.side, this.snapped(point)), at);
  }

  release({ point }: Contact): void {
    const { gesture } = this;
    this.gesture = null;
    if (gesture?.kind === "set") this.set(this.snapped(point));
    else if (gesture?.moved) {
      this.host.commit(this.host.shapes().pins);
      this.say(told.moved, gesture.index);
    }
  }

  /** Begins a pin, or ties its partner to this point. */
  private set(point: Point): boolean {
    const { side } = this.host;
    const { pins } = this.host.shapes();
    const other = begun.value;
    if (pins.length >= MOST_PINS) {
      said.value = told.full(MOST_PINS);
      return false;
    }
    if (!other || other.side === side) {
      begun.value = { side, point };
      chosen.value = null;
      said.value = told.begun(pins.length, side, point);
      return false;
    }
    begun.value = null;
    const pin =
      side === "template" ? { reference: other.point, template: point } : { reference: point, template: other.point };
    this.host.commit([...pins, pin]);
    chosen.value = pins.length;
    said.value = told.set(pins.length, pin.reference, pin.template);
    return true;
  }

  private enter(at: Point): void {
    this.cursor = at;
    const { carried } = this;
    if (carried) {
      this.carried = null;
      this.host.commit(this.host.shapes().pins);
      this.say(told.moved, carried.index);
      return;
    }
    const index = this.pinAt(at, TARGET.mouse);
    if (index !== null) {
      this.choose(index);
      this.carried = { index, before: this.host.shapes().pins };
      said.value = told.takenUp(index);
      return;
    }
    const done = this.set(this.snapped(at));
    if (!done && begun.value) this.host.goOn();
  }

  private walk(next: Point, at: number): void {
    this.cursor = next;
    const { carried } = this;
    if (carried) this.host.preview(withEnd(carried.before, carried.index, this.host.side, this.snapped(next)), at);
    const index = this.pinAt(next, TARGET.mouse);
    const there = index === null ? (this.isOnCurve(next) ? told.onCurve : "") : told.atPin(index);
    said.value = `${place(next)}${carried ? "" : there}.`;
  }

  /** To the next pin, or the one before. */
  private leap(by: number): void {
    const { length } = this.host.shapes().pins;
    if (length === 0 || this.carried) return;
    const from = chosen.value ?? (by > 0 ? -1 : 0);
    const index = (from + by + length) % length;
    this.choose(index);
    this.cursor = this.end(index);
  }

  private escape(): void {
    if (this.carried || this.gesture) {
      this.cancel();
      said.value = told.putBack;
    } else if (begun.value) {
      begun.value = null;
      said.value = told.givenUp;
    } else chosen.value = null;
  }

  private choose(index: number): void {
    chosen.value = index;
    begun.value = null;
    this.say(told.chosen, index);
  }

  private remove(index: number): void {
    this.carried = null;
    this.host.commit(without(this.host.shapes().pins, index));
    chosen.value = null;
    said.value = told.deleted(index);
  }

  private say(what: (index: number, at: Point) => string, index: number): void {
    const at = this.end(index);
    if (at) said.value = what(index, at);
  }

  private end(index: number): Point | null {
    return this.host.shapes().pins[index]?.[this.host.side] ?? null;
  }

  private snapped(point: Point): Point {
    return snapped(this.host.shapes()[this.host.side], point, SNAP / this.host.pixelsPerUnit);
  }

  private isOnCurve(point: Point): boolean {
    const { x, y } = this.snapped(point);
    return x !== point.x || y !== point.y;
  }

  /** The nearest of this surface's ends within reach, CSS pixels. */
  private pinAt({ x, y }: Point, reach: number): number | null {
    let best: { readonly index: number; readonly distance: number } | null = null;
    this.host.shapes().pins.forEach((pin, index) => {
      const end = pin[this.host.side];
      const distance = Math.hypot(end.x - x, end.y - y) * this.host.pixelsPerUnit;
      if (distance <= reach && (!best || distance < best.distance)) best = { index, distance };
    });
    return (best as { readonly index: number } | null)?.index ?? null;
  }
}
