/**
 * Freehand drawing with mouse, touch and pen. A press near the curve pulls it, on the grip moves it, anywhere else
 * draws a new loop; two fingers move, turn and scale.
 */

import type { Ground, Hand } from "../tools/hand";
import type { Frame } from "../view/canvas";
import type { Theme } from "../view/palette";
import { drawPen } from "../view/pen";
import { keyed, pulled, settled, withLoop } from "./edit";
import {
  centroid,
  type Loop,
  type Nearest,
  nearestVertex,
  type Point,
  type Shape,
  shift,
  transformed,
} from "./geometry";
import { type Judgement, judged, type Limits } from "./judge";

/** Reach of the pointer in CSS pixels, around the curve and around the grip. */
const REACH = { mouse: 8, pen: 10, touch: 16 };
/** Around an untouched example: who just misses its curve means to bend it, and not to draw another in its place. */
const EXAMPLE_REACH = 16;
const GRIP_REACH = { mouse: 12, pen: 14, touch: 20 };

export interface DrawingHost extends Ground {
  readonly side: "reference" | "template";
  shape(): Shape;
  /** An untouched example: the first stroke replaces it. */
  isExample(): boolean;
  /** The shape while the hand is still moving; comes often. `at` is the time of the event. */
  preview(shape: Shape, at: number): void;
  /** Puts back the shape of before the gesture. */
  restore(): void;
  /** The shape when the hand lets go; one step to undo. */
  commit(shape: Shape): void;
  limits(): Limits;
  /** Asks what is to become of a stroke that is no shape; `take` draws what has been made of it. */
  ask(judgement: Exclude<Judgement, { kind: "tap" | "loop" }>, take: (loop: Loop) => void): void;
}

type Gesture =
  | { readonly kind: "stroke"; readonly points: Point[] }
  | { readonly kind: "pull"; readonly grip: Nearest; readonly start: Point; readonly before: Shape; moved: boolean }
  | { readonly kind: "move"; readonly start: Point; readonly before: Shape; moved: boolean }
  | { readonly kind: "pinch"; readonly start: readonly [Point, Point]; readonly before: Shape };

export class Drawing implements Hand {
  private readonly host: DrawingHost;
  private readonly fingers = new Map<number, Point>();
  private readonly listening = new AbortController();
  private gesture: Gesture | null = null;
  private hovered: Nearest | null = null;

  constructor(host: DrawingHost) {
    this.host = host;
    const { canvas } = host;
    const options = { signal: this.listening.signal };
    canvas.addEventListener("pointerdown", (event) => this.press(event), options);
    canvas.addEventListener("pointermove", (event) => this.move(event), options);
    canvas.addEventListener("pointerup", (event) => this.release(event), options);
    canvas.addEventListener("pointercancel", (event) => this.abandon(event), options);
    canvas.addEventListener("pointerleave", () => this.hover(null), options);
  }

  /** Moves, turns, scales and clears the shape. */
  key(event: KeyboardEvent): boolean {
    if (event.key === "Escape") {
      this.cancel();
      return true;
    }
    const shape = keyed(this.host.shape(), event.key, event.shiftKey);
    if (shape) this.host.commit(shape);
    return shape !== null;
  }

  paint(context: CanvasRenderingContext2D, frame: Frame, colours: Theme): void {
    drawPen(context, frame, colours, this.host.side, this);
  }

  get stroke(): readonly Point[] {
    return this.gesture?.kind === "stroke" ? this.gesture.points : [];
  }

  /** Where the shape can be gripped; hidden while a stroke is drawn and while there is nothing to move. */
  get grip(): Point | null {
    const shape = this.host.shape();
    return shape.length > 0 && this.gesture?.kind !== "stroke" ? centroid(shape) : null;
  }

  /** The point of the curve that is, or would be, pulled. */
  get pull(): Point | null {
    const near = this.gesture?.kind === "pull" ? this.gesture.grip : this.gesture ? null : this.hovered;
    const loop = near && this.host.shape()[near.loop];
    if (!near || !loop || 2 * near.vertex + 1 >= loop.length) return null;
    return { x: loop[2 * near.vertex], y: loop[2 * near.vertex + 1] };
  }

  get busy(): boolean {
    return this.gesture !== null;
  }

  /** Puts back what the unfinished gesture has changed. */
  cancel(): void {
    const gesture = this.gesture;
    this.gesture = null;
    if (gesture && gesture.kind !== "stroke") this.host.restore();
    this.host.repaint();
  }

  dispose(): void {
    this.listening.abort();
    this.cancel();
    this.host.canvas.style.cursor = "";
  }

  private press(event: PointerEvent): void {
    if (event.button !== 0) return;
    const point = this.host.pointFrom(event);
    this.fingers.set(event.pointerId, point);
    this.host.canvas.setPointerCapture(event.pointerId);
    const [first, second] = [...this.fingers.values()];
    if (second) {
      this.cancel();
      if (this.host.shape().length > 0) {
        this.gesture = { kind: "pinch", start: [first, second], before: this.host.shape() };
      }
      return;
    }
    const before = this.host.shape();
    const kind = kindOf(event);
    const near = this.nearest(point, kind);
    if (this.onGrip(point, kind)) this.gesture = { kind: "move", start: point, before, moved: false };
    else if (near) this.gesture = { kind: "pull", grip: near, start: point, before, moved: false };
    else this.gesture = { kind: "stroke", points: [point] };
    this.host.repaint();
  }

  private move(event: PointerEvent): void {
    const point = this.host.pointFrom(event);
    if (!this.fingers.has(event.pointerId)) {
      const kind = kindOf(event);
      const onGrip = this.onGrip(point, kind);
      this.hover(onGrip ? null : this.nearest(point, kind));
      this.host.canvas.style.cursor = onGrip ? "move" : this.hovered ? "grab" : "crosshair";
      return;
    }
    this.fingers.set(event.pointerId, point);
    const { gesture } = this;
    if (!gesture) return;
    if (gesture.kind === "stroke") {
      const batch = event.getCoalescedEvents?.() ?? [];
      for (const sample of batch.length > 0 ? batch : [event]) gesture.points.push(this.host.pointFrom(sample));
      this.host.repaint();
    } else if (gesture.kind === "pinch") {
      this.host.preview(this.pinched(gesture.start, gesture.before), event.timeStamp);
    } else {
      const x = point.x - gesture.start.x;
      const y = point.y - gesture.start.y;
      gesture.moved ||= Math.hypot(x, y) * this.host.pixelsPerUnit > 2;
      if (!gesture.moved) return;
      this.host.preview(
        gesture.kind === "pull" ? pulled(gesture.before, gesture.grip, x, y) : transformed(gesture.before, shift(x, y)),
        event.timeStamp,
      );
    }
  }

  private release(event: PointerEvent): void {
    if (!this.fingers.delete(event.pointerId)) return;
    const { gesture } = this;
    this.gesture = null;
    if (!gesture) return;
    if (gesture.kind === "stroke") {
      this.draw(judged(gesture.points, this.host.limits()));
    } else if (gesture.kind === "pinch" || gesture.moved) {
      this.host.commit(settled(this.host.shape()));
    }
    this.host.repaint();
  }

  private draw(judgement: Judgement): void {
    if (judgement.kind === "tap") return;
    if (judgement.kind === "loop") this.take(judgement.loop);
    else this.host.ask(judgement, (loop) => this.take(loop));
  }

  /** The first curve replaces an example. */
  private take(loop: Loop): void {
    this.host.commit(withLoop(this.host.isExample() ? [] : this.host.shape(), loop));
  }

  private abandon(event: PointerEvent): void {
    this.fingers.delete(event.pointerId);
    this.cancel();
  }

  private hover(near: Nearest | null): void {
    const same = near?.loop === this.hovered?.loop && near?.vertex === this.hovered?.vertex;
    this.hovered = near;
    if (!same) this.host.repaint();
  }

  private nearest(point: Point, kind: keyof typeof REACH): Nearest | null {
    const near = nearestVertex(this.host.shape(), point);
    const reach = this.host.isExample() ? Math.max(EXAMPLE_REACH, REACH[kind]) : REACH[kind];
    return near && near.distance * this.host.pixelsPerUnit <= reach ? near : null;
  }

  private onGrip(point: Point, kind: keyof typeof GRIP_REACH): boolean {
    const { grip } = this;
    if (!grip) return false;
    return Math.hypot(point.x - grip.x, point.y - grip.y) * this.host.pixelsPerUnit <= GRIP_REACH[kind];
  }

  /** The similarity that takes the fingers' first places to their present ones. */
  private pinched([a, b]: readonly [Point, Point], before: Shape): Shape {
    const [c, d] = [...this.fingers.values()];
    const x = b.x - a.x;
    const y = b.y - a.y;
    const square = x * x + y * y;
    if (!d || square === 0) return before;
    const u = d.x - c.x;
    const v = d.y - c.y;
    const along = (x * u + y * v) / square;
    const across = (x * v - y * u) / square;
    return transformed(before, {
      a: along,
      b: across,
      x: c.x - along * a.x + across * a.y,
      y: c.y - across * a.x - along * a.y,
    });
  }
}

function kindOf(event: PointerEvent): keyof typeof REACH {
  return event.pointerType === "touch" || event.pointerType === "pen" ? event.pointerType : "mouse";
}
