/** Points set one after another, with a cursor for those who draw with the keyboard, until they make an outline. */

import type { Point } from "../shapes/geometry";
import { type Frame, pixelX, pixelY, trace } from "../view/canvas";
import type { Theme } from "../view/palette";
import { told } from "../words/drawing";
import { drawCursor, stepped } from "./cursor";
import { type Ground, TARGET } from "./hand";
import { open } from "./kit";
import { said } from "./tool";

/** Where the cursor is while nothing is set. */
const MIDDLE: Point = { x: 0.5, y: 0.5 };

export class Outline {
  points: readonly Point[] = [];
  private cursor: Point | null = null;
  /** The point that Delete would delete. */
  private chosen: number | null = null;
  /** The point that the arrow keys carry, and where it was. */
  private carried: { readonly index: number; readonly from: Point } | null = null;

  /** `close` is told of enough points; `least` are enough. */
  constructor(
    readonly ground: Ground,
    readonly least: number,
    private readonly close: (points: readonly Point[]) => void,
  ) {}

  get isOpen(): boolean {
    return this.points.length > 0;
  }

  add(point: Point): void {
    this.points = [...this.points, boxed(point)];
    this.changed();
  }

  move(index: number, point: Point): void {
    this.points = this.points.map((old, i) => (i === index ? boxed(point) : old));
    this.ground.repaint();
  }

  /** Takes the last point back. */
  back(): void {
    this.remove(this.points.length - 1);
  }

  finish(): void {
    if (this.points.length < this.least) {
      said.value = told.tooFew(this.points.length, this.least);
      return;
    }
    const { points } = this;
    this.clear();
    this.close(points);
  }

  giveUp(): void {
    const wasOpen = this.isOpen;
    this.clear();
    if (wasOpen) said.value = told.givenUp;
  }

  clear(): void {
    this.points = [];
    this.chosen = null;
    this.carried = null;
    this.changed();
  }

  /** The pointer takes over. */
  hideCursor(): void {
    this.cursor = null;
  }

  /** The point within reach, CSS pixels. */
  pointAt({ x, y }: Point, reach: number): number | null {
    const away = this.points.map((p) => Math.hypot(p.x - x, p.y - y) * this.ground.pixelsPerUnit);
    const nearest = away.indexOf(Math.min(...away));
    return nearest >= 0 && away[nearest] <= reach ? nearest : null;
  }

  /** Whether a press on this point closes the outline: the first, or the last once more. */
  closes(index: number): boolean {
    const { length } = this.points;
    return length >= this.least && (index === 0 || index === length - 1);
  }

  key(event: KeyboardEvent): boolean {
    const at = this.cursor ?? this.points[this.points.length - 1] ?? MIDDLE;
    const next = stepped(at, event);
    if (next) this.walk(next);
    else if (event.key === "Enter") this.enter(at);
    else if (event.key === " ") this.press(at);
    else if (event.key === "PageDown" || event.key === "PageUp") this.leap(event.key === "PageDown" ? 1 : -1);
    else if (event.key === "Delete" || event.key === "Backspace") {
      if (!this.isOpen) return false;
      this.remove(this.chosen ?? this.points.length - 1);
    } else if (event.key === "Escape") this.escape();
    else return false;
    this.ground.repaint();
    return true;
  }

  paint(context: CanvasRenderingContext2D, frame: Frame, colours: Theme): void {
    const { ratio } = frame;
    const own = this.ground.side === "reference" ? colours.reference : colours.template;
    context.beginPath();
    trace(
      context,
      frame,
      this.points.flatMap(({ x, y }) => [x, y]),
      false,
    );
    if (this.cursor && this.isOpen && !this.carried)
      context.lineTo(pixelX(frame, this.cursor.x), pixelY(frame, this.cursor.y));
    context.strokeStyle = own;
    context.lineWidth = 2.5 * ratio;
    context.lineJoin = "round";
    context.stroke();
    this.points.forEach(({ x, y }, i) => {
      const marked = i === this.chosen || i === this.carried?.index;
      context.beginPath();
      context.arc(pixelX(frame, x), pixelY(frame, y), (marked ? 7 : i === 0 ? 6 : 4.5) * ratio, 0, 2 * Math.PI);
      context.fillStyle = marked ? colours.ink : i === 0 ? colours.paper : own;
      context.fill();
      context.lineWidth = 2 * ratio;
      context.strokeStyle = own;
      context.stroke();
    });
    if (this.cursor && document.activeElement === this.ground.canvas) drawCursor(context, frame, colours, this.cursor);
  }

  private walk(next: Point): void {
    this.cursor = next;
    if (this.carried) this.move(this.carried.index, next);
    const index = this.carried ? null : this.pointAt(next, TARGET.mouse);
    if (!this.carried) this.chosen = index;
    said.value = told.walk(next, index, this.points.length, index !== null && this.closes(index));
  }

  /** Closes, where the pointer or the cursor is at an end; else as Space does. */
  private enter(at: Point): void {
    const index = this.pointAt(at, TARGET.mouse);
    const atEnd = index === 0 || (index !== null && index === this.points.length - 1);
    if (!this.carried && this.isOpen && (this.cursor === null || atEnd)) this.finish();
    else this.press(at);
  }

  /** Sets a point, or takes up the one that is there, or sets it down. */
  private press(at: Point): void {
    this.cursor = at;
    if (this.carried) {
      const { index } = this.carried;
      this.carried = null;
      said.value = told.moved(index, this.points[index]);
      return;
    }
    const index = this.pointAt(at, TARGET.mouse);
    if (index !== null) {
      this.chosen = index;
      this.carried = { index, from: this.points[index] };
      said.value = told.takenUp(index);
      return;
    }
    this.chosen = null;
    this.add(at);
    said.value = told.set(this.points.length - 1, at);
  }

  /** To the next point, or the one before. */
  private leap(by: number): void {
    const { length } = this.points;
    if (length === 0 || this.carried) return;
    const index = ((this.chosen ?? (by > 0 ? -1 : 0)) + by + length) % length;
    this.chosen = index;
    this.cursor = this.points[index];
    said.value = told.chosen(index, length, this.points[index], this.closes(index));
  }

  private remove(index: number): void {
    if (index < 0) return;
    this.points = this.points.filter((_, i) => i !== index);
    this.chosen = null;
    this.carried = null;
    this.changed();
    said.value = told.deleted(index, this.points.length);
  }

  private escape(): void {
    if (!this.carried) {
      this.giveUp();
      return;
    }
    this.move(this.carried.index, this.carried.from);
    this.cursor = this.carried.from;
    this.carried = null;
    said.value = told.putBack;
  }

  /** Tells the page what can be done with it. */
  private changed(): void {
    const mine = open.peek()?.outline === this;
    if (this.isOpen) open.value = { outline: this, count: this.points.length };
    else if (mine) open.value = null;
    this.ground.repaint();
  }
}

export function boxed({ x, y }: Point): Point {
  const inside = (value: number) => Math.min(1, Math.max(0, value));
  return { x: inside(x), y: inside(y) };
}
