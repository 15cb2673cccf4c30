/** One half is drawn; the other is its mirror image about the box's vertical middle line. */

import type { Point } from "../shapes/geometry";
import { judged, judgedLoop } from "../shapes/judge";
import { type Frame, trace } from "../view/canvas";
import type { Theme } from "../view/palette";
import type { Contact, Tool } from "./hand";
import { Outline } from "./outline";
import { type Easel, polygon } from "./polygon";

/** Where the mirror stands. */
const AXIS = 0.5;

export class Mirror implements Tool {
  private readonly outline: Outline;
  private stroke: readonly Point[] = [];

  constructor(private readonly easel: Easel) {
    this.outline = new Outline(easel, 2, (points) => easel.draw(judgedLoop(polygon(whole(points)), easel.limits())));
  }

  press({ point }: Contact): void {
    this.outline.hideCursor();
    this.outline.clear();
    this.stroke = [point];
  }

  drag({ trail }: Contact): void {
    if (this.stroke.length > 0) this.stroke = [...this.stroke, ...trail()];
  }

  release(): void {
    const { stroke } = this;
    this.stroke = [];
    if (stroke.length > 2) this.easel.draw(judged(whole(stroke), this.easel.limits()));
  }

  key(event: KeyboardEvent): boolean {
    return this.outline.key(event);
  }

  undo(): boolean {
    const wasOpen = this.outline.isOpen;
    this.outline.back();
    return wasOpen;
  }

  cancel(): void {
    this.stroke = [];
    this.easel.repaint();
  }

  dispose(): void {
    this.outline.clear();
  }

  paint(context: CanvasRenderingContext2D, frame: Frame, colours: Theme): void {
    const { ratio } = frame;
    context.beginPath();
    trace(context, frame, [AXIS, 0, AXIS, 1], false);
    context.strokeStyle = colours.muted;
    context.lineWidth = 1.5 * ratio;
    context.setLineDash([8 * ratio, 6 * ratio]);
    context.stroke();
    context.setLineDash([]);
    const half = this.stroke.length > 0 ? this.stroke : this.outline.points;
    if (half.length > 1) {
      context.beginPath();
      trace(
        context,
        frame,
        whole(half).flatMap(({ x, y }) => [x, y]),
        true,
      );
      context.strokeStyle = this.easel.side === "reference" ? colours.reference : colours.template;
      context.lineWidth = 2.5 * ratio;
      context.stroke();
    }
    this.outline.paint(context, frame, colours);
  }
}

/**
 * The half with its mirror image, once round. The half lies on that side of the axis where most of it is; what its ends
 * have beyond the axis is cut off there.
 */
export function whole(drawn: readonly Point[]): readonly Point[] {
  const side = drawn.reduce((sum, { x }) => sum + Math.sign(x - AXIS), 0) < 0 ? -1 : 1;
  const isBeyond = ({ x }: Point) => side * (x - AXIS) < 0;
  const half = trimmed(trimmed(drawn, isBeyond).toReversed(), isBeyond).toReversed();
  const image = half.map(({ x, y }) => ({ x: 2 * AXIS - x, y })).toReversed();
  // On the axis a point and its image are one.
  const isOn = ({ x }: Point) => x === AXIS;
  const [first, last] = [half[0], half[half.length - 1]];
  return [...half, ...image.slice(last && isOn(last) ? 1 : 0, first && isOn(first) ? -1 : undefined)];
}

/** From where the points first come to the near side, beginning on the axis. */
function trimmed(points: readonly Point[], isBeyond: (point: Point) => boolean): readonly Point[] {
  const first = points.findIndex((point) => !isBeyond(point));
  if (first <= 0) return first < 0 ? [] : points;
  const [out, back] = [points[first - 1], points[first]];
  const part = (AXIS - out.x) / (back.x - out.x);
  const onAxis = { x: AXIS, y: out.y + part * (back.y - out.y) };
  return [onAxis, ...points.slice(back.x === AXIS ? first + 1 : first)];
}
