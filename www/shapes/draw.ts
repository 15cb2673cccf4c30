/**
 * Freehand drawing with mouse, touch and pen. A press near the curve pulls it, on the grip moves it, anywhere else
 * draws a new loop; two fingers move, turn and scale.
 */

import { type Contact, type Ground, TARGET, type Tool } from "../tools/hand";
import type { Frame } from "../view/canvas";
import type { Theme } from "../view/palette";
import { drawPen } from "../view/pen";
import { keyed, pulled, settled } from "./edit";
import {
  centroid,
  type Nearest,
  nearestVertex,
  type Point,
  type Shape,
  type Similarity,
  shift,
  transformed,
} from "./geometry";
import { type Judgement, judged, type Limits } from "./judge";

/** Reach of the pointer in CSS pixels, around the curve and around the grip. */
const REACH = { mouse: 8, pen: 10, touch: 16 };
/** Around an untouched example: who just misses its curve means to bend it, and not to draw another in its place. */
const EXAMPLE_REACH = 16;

export interface DrawingHost extends Ground {
  shape(): Shape;
  isExample(): boolean;
  /** The shape while the hand is still moving; comes often. `at` is the time of the event. */
  preview(shape: Shape, at: number): void;
  /** Puts back the shape of before the gesture. */
  restore(): void;
  /** The shape when the hand lets go; one step to undo. */
  commit(shape: Shape): void;
  limits(): Limits;
  /** Takes what has been drawn as one more curve, or asks what is to become of it. */
  draw(judgement: Judgement): void;
  /** What is done next to one curve is done to this one; null for none. */
  choose(loop: number | null): void;
}

type Gesture =
  | { readonly kind: "stroke"; readonly points: Point[] }
  | { readonly kind: "pull"; readonly grip: Nearest; readonly start: Point; readonly before: Shape; moved: boolean }
  | { readonly kind: "move"; readonly start: Point; readonly before: Shape; moved: boolean }
  | { readonly kind: "pinch"; readonly before: Shape };

export class Drawing implements Tool {
  private readonly host: DrawingHost;
  private gesture: Gesture | null = null;
  private hovered: Nearest | null = null;

  constructor(host: DrawingHost) {
    this.host = host;
  }

  /** Moves, turns, scales and clears the shape. */
  key(event: KeyboardEvent): boolean {
    if (event.key === "Escape") {
      this.cancel();
      this.host.choose(null);
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

  /** Puts back what the unfinished gesture has changed. */
  cancel(): void {
    const gesture = this.gesture;
    this.gesture = null;
    if (gesture && gesture.kind !== "stroke") this.host.restore();
    this.host.repaint();
  }

  press({ point, kind }: Contact): void {
    const before = this.host.shape();
    const near = this.nearest(point, kind);
    if (this.onGrip(point, kind)) this.gesture = { kind: "move", start: point, before, moved: false };
    else if (near) {
      this.gesture = { kind: "pull", grip: near, start: point, before, moved: false };
      this.host.choose(near.loop);
    } else {
      this.gesture = { kind: "stroke", points: [point] };
      this.host.choose(null);
    }
  }

  hover(contact: Contact | null): string {
    const onGrip = contact !== null && this.onGrip(contact.point, contact.kind);
    const near = contact && !onGrip ? this.nearest(contact.point, contact.kind) : null;
    this.show(near);
    return onGrip ? "move" : near ? "grab" : "crosshair";
  }

  drag({ point, at, trail }: Contact): void {
    const { gesture } = this;
    if (gesture?.kind === "stroke") gesture.points.push(...trail());
    if (gesture?.kind !== "pull" && gesture?.kind !== "move") return;
    const x = point.x - gesture.start.x;
    const y = point.y - gesture.start.y;
    gesture.moved ||= Math.hypot(x, y) * this.host.pixelsPerUnit > 2;
    if (!gesture.moved) return;
    const { before } = gesture;
    this.host.preview(
      gesture.kind === "pull" ? pulled(before, gesture.grip, x, y) : transformed(before, shift(x, y)),
      at,
    );
  }

  pinch(motion: Similarity, at: number): void {
    if (this.host.shape().length === 0) return;
    if (this.gesture?.kind !== "pinch") this.gesture = { kind: "pinch", before: this.host.shape() };
    this.host.preview(transformed(this.gesture.before, motion), at);
  }

  release(): void {
    const { gesture } = this;
    this.gesture = null;
    if (!gesture) return;
    if (gesture.kind === "stroke") this.host.draw(judged(gesture.points, this.host.limits()));
    else if (gesture.kind === "pinch" || gesture.moved) this.host.commit(settled(this.host.shape()));
  }

  private show(near: Nearest | null): void {
    const same = near?.loop === this.hovered?.loop && near?.vertex === this.hovered?.vertex;
    this.hovered = near;
    if (!same) this.host.repaint();
  }

  private nearest(point: Point, kind: keyof typeof REACH): Nearest | null {
    const near = nearestVertex(this.host.shape(), point);
    const reach = this.host.isExample() ? Math.max(EXAMPLE_REACH, REACH[kind]) : REACH[kind];
    return near && near.distance * this.host.pixelsPerUnit <= reach ? near : null;
  }

  private onGrip(point: Point, kind: keyof typeof TARGET): boolean {
    const { grip } = this;
    if (!grip) return false;
    return Math.hypot(point.x - grip.x, point.y - grip.y) * this.host.pixelsPerUnit <= TARGET[kind];
  }
}
