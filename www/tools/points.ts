/** The knots of finished curves, taken up, added and deleted: with the pointer, or with a cursor by the keyboard. */

import type { Loop, Point, Shape } from "../shapes/geometry";
import { type Frame, pixelX, pixelY } from "../view/canvas";
import type { Theme } from "../view/palette";
import { told } from "../words/drawing";
import { drawCursor, stepped } from "./cursor";
import { type Contact, type Ground, TARGET, type Tool } from "./hand";
import { knot } from "./kit";
import { added, type Knots, keep, knotsOf, LEAST, loopOf, moved, nearestPlace, removed } from "./knots";
import { boxed } from "./outline";
import { said } from "./tool";

export interface Bench extends Ground {
  shape(): Shape;
  /** The shape while the hand is still moving. `at` is the time of the event. */
  preview(shape: Shape, at: number): void;
  /** Puts back the shape of before the gesture. */
  restore(): void;
  commit(shape: Shape): void;
}

/** A knot of the shape. */
type At = { readonly loop: number; readonly index: number };

/** The knot in the hand, or carried by the arrow keys. */
type Held = At & { readonly before: Shape; readonly knots: Knots; readonly start: Point; shape: Shape; moved: boolean };

export class Points implements Tool {
  private held: Held | null = null;
  /** Where a press would add a knot. */
  private ahead: Point | null = null;
  private cursor: Point | null = null;

  constructor(private readonly bench: Bench) {}

  get side() {
    return this.bench.side;
  }

  press({ point, kind }: Contact): void {
    this.cursor = null;
    this.ahead = null;
    this.take(this.at(point, TARGET[kind]) ?? this.add(point, TARGET[kind]), point);
  }

  drag({ point, at }: Contact): void {
    const { held } = this;
    if (!held) return;
    const [x, y] = [point.x - held.start.x, point.y - held.start.y];
    held.moved ||= Math.hypot(x, y) * this.bench.pixelsPerUnit > 3;
    const from = held.knots[held.index].point;
    if (held.moved) this.carry({ x: from.x + x, y: from.y + y }, at);
  }

  release(): void {
    this.setDown();
  }

  hover(contact: Contact | null): string {
    const index = contact && this.at(contact.point, TARGET[contact.kind]);
    const place = contact && !index ? this.place(contact.point, TARGET[contact.kind]) : null;
    this.ahead = place?.point ?? null;
    this.bench.repaint();
    return index ? "grab" : place ? "copy" : "default";
  }

  key(event: KeyboardEvent): boolean {
    const chosen = this.chosen();
    const at = this.cursor ?? (chosen && this.pointOf(chosen)) ?? { x: 0.5, y: 0.5 };
    const next = stepped(at, event);
    if (next) this.walk(next, event.timeStamp);
    else if (event.key === "Enter" || event.key === " ") this.enter(at);
    else if (event.key === "PageDown" || event.key === "PageUp") this.leap(event.key === "PageDown" ? 1 : -1);
    else if (event.key === "Delete" || event.key === "Backspace") {
      if (!chosen) return false;
      this.remove();
    } else if (event.key === "Escape") {
      if (this.held) this.putBack();
      else knot.value = null;
    } else return false;
    this.bench.repaint();
    return true;
  }

  undo(): boolean {
    const { held } = this;
    if (held) this.putBack();
    return held !== null;
  }

  cancel(): void {
    if (this.held?.moved) this.bench.restore();
    this.held = null;
    this.ahead = null;
    this.bench.repaint();
  }

  dispose(): void {
    if (knot.peek()?.tool === this) knot.value = null;
  }

  /** Deletes the chosen knot. */
  remove(): void {
    const chosen = this.chosen();
    if (!chosen) return;
    this.cancel();
    const shape = this.bench.shape();
    const knots = knotsOf(shape[chosen.loop]);
    if (knots.length <= LEAST) {
      said.value = told.keepsThree;
      return;
    }
    knot.value = null;
    this.bench.commit(replaced(shape, chosen.loop, loopOf(removed(knots, chosen.index))));
    said.value = told.deleted(chosen.index, knots.length - 1);
  }

  paint(context: CanvasRenderingContext2D, frame: Frame, colours: Theme): void {
    const own = this.bench.side === "reference" ? colours.reference : colours.template;
    const chosen = this.chosen();
    const dot = ({ x, y }: Point, radius: number, fill: string) => {
      context.beginPath();
      context.arc(pixelX(frame, x), pixelY(frame, y), radius * frame.ratio, 0, 2 * Math.PI);
      context.fillStyle = fill;
      context.fill();
      context.lineWidth = 2 * frame.ratio;
      context.strokeStyle = own;
      context.stroke();
    };
    this.bench.shape().forEach((loop, l) => {
      knotsOf(loop).forEach(({ point }, i) => {
        const marked = chosen?.loop === l && chosen.index === i;
        dot(point, marked ? 7 : 4.5, marked ? colours.ink : colours.paper);
      });
    });
    if (this.ahead) dot(this.ahead, 3, own);
    if (this.cursor && document.activeElement === this.bench.canvas) drawCursor(context, frame, colours, this.cursor);
  }

  /** The knot that is marked, if it is one of this surface's that is still there. */
  private chosen(): At | null {
    const marked = knot.peek();
    if (marked?.tool !== this) return null;
    const loop = this.bench.shape()[marked.loop];
    return loop && marked.index < knotsOf(loop).length ? marked : null;
  }

  private pointOf({ loop, index }: At): Point {
    return knotsOf(this.bench.shape()[loop])[index].point;
  }

  private all(): At[] {
    return this.bench.shape().flatMap((loop, l) => knotsOf(loop).map((_, index) => ({ loop: l, index })));
  }

  /** The knot within reach, CSS pixels. */
  private at(point: Point, reach: number): At | null {
    const away = (at: At) => {
      const { x, y } = this.pointOf(at);
      return Math.hypot(x - point.x, y - point.y) * this.bench.pixelsPerUnit;
    };
    const near = this.all().filter((at) => away(at) <= reach);
    return near.reduce<At | null>((best, at) => (best && away(best) <= away(at) ? best : at), null);
  }

  /** The place on a curve within reach. */
  private place(point: Point, reach: number) {
    const places = this.bench.shape().map((loop, l) => ({ loop: l, ...nearestPlace(knotsOf(loop), point) }));
    const near = places.filter(({ distance }) => distance * this.bench.pixelsPerUnit <= reach);
    return near.length > 0 ? near.reduce((best, place) => (best.distance <= place.distance ? best : place)) : null;
  }

  /** The curve stays as it is, so that there is nothing to undo. */
  private add(point: Point, reach: number): At | null {
    const place = this.place(point, reach);
    if (!place) return null;
    const loop = this.bench.shape()[place.loop];
    keep(loop, added(knotsOf(loop), place));
    return { loop: place.loop, index: place.after + 1 };
  }

  private take(at: At | null, start: Point): void {
    knot.value = at && { tool: this, ...at };
    if (!at) return;
    const before = this.bench.shape();
    this.held = { ...at, before, knots: knotsOf(before[at.loop]), start, shape: before, moved: false };
  }

  private carry(point: Point, at: number): void {
    const { held } = this;
    if (!held) return;
    held.shape = replaced(held.before, held.loop, loopOf(moved(held.knots, held.index, boxed(point))));
    this.bench.preview(held.shape, at);
  }

  private setDown(): void {
    const { held } = this;
    this.held = null;
    if (held?.moved) this.bench.commit(held.shape);
  }

  private putBack(): void {
    const { held } = this;
    this.cancel();
    if (held) this.cursor = held.knots[held.index].point;
    said.value = told.putBack;
  }

  private walk(next: Point, at: number): void {
    this.cursor = next;
    if (this.held) {
      this.held.moved = true;
      this.carry(next, at);
      said.value = told.walk(next, null, 0, false);
      return;
    }
    const found = this.at(next, TARGET.mouse);
    knot.value = found && { tool: this, ...found };
    said.value = found ? told.walk(next, found.index, this.count(found), false) : told.walk(next, null, 0, false);
  }

  /** Takes up the knot that is there, or one that it adds; or sets down what it carries. */
  private enter(at: Point): void {
    this.cursor = at;
    if (this.held) {
      const { index } = this.held;
      this.setDown();
      said.value = told.moved(index, at);
      return;
    }
    const found = this.at(at, TARGET.mouse);
    const taken = found ?? this.add(at, TARGET.mouse);
    this.take(taken, at);
    if (taken) this.cursor = this.pointOf(taken);
    said.value = !taken ? told.noCurve : found ? told.takenUp(taken.index) : told.added(taken.index);
  }

  /** To the next knot, or the one before. */
  private leap(by: number): void {
    const all = this.all();
    if (all.length === 0 || this.held) return;
    const chosen = this.chosen();
    const now = chosen ? all.findIndex(({ loop, index }) => loop === chosen.loop && index === chosen.index) : -1;
    const next = all[((now < 0 && by < 0 ? 0 : now) + by + all.length) % all.length];
    knot.value = { tool: this, ...next };
    this.cursor = this.pointOf(next);
    said.value = told.chosen(next.index, this.count(next), this.cursor, false);
  }

  private count({ loop }: At): number {
    return knotsOf(this.bench.shape()[loop]).length;
  }
}

function replaced(shape: Shape, index: number, loop: Loop): Shape {
  return shape.map((old, l) => (l === index ? loop : old));
}
