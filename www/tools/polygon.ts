/** Corner after corner; the first again, or the last once more, closes the outline. */

import { type Loop, type Point, perimeter, SAMPLES } from "../shapes/geometry";
import { type Judgement, judgedLoop, type Limits } from "../shapes/judge";
import { type Frame, pixelX, pixelY } from "../view/canvas";
import type { Theme } from "../view/palette";
import { type Contact, type Ground, TARGET, type Tool } from "./hand";
import { Outline } from "./outline";

/** Where what has been drawn goes. */
export interface Easel extends Ground {
  limits(): Limits;
  draw(judgement: Judgement): void;
}

export class Polygon implements Tool {
  private readonly outline: Outline;
  /** The corner under the finger; `fresh` if this press has set it. */
  private held: { readonly index: number; readonly start: Point; readonly fresh: boolean; moved: boolean } | null =
    null;
  /** The pointer, while it hovers. */
  private ahead: Point | null = null;

  constructor(private readonly easel: Easel) {
    this.outline = new Outline(easel, 3, (points) => easel.draw(judgedLoop(polygon(points), easel.limits())));
  }

  press({ point, kind }: Contact): void {
    this.outline.hideCursor();
    this.ahead = null;
    const index = this.outline.pointAt(point, TARGET[kind]);
    if (index === null) this.outline.add(point);
    this.held = {
      index: index ?? this.outline.points.length - 1,
      start: point,
      fresh: index === null,
      moved: false,
    };
  }

  drag({ point }: Contact): void {
    const { held } = this;
    if (!held) return;
    const far = Math.hypot(point.x - held.start.x, point.y - held.start.y) * this.easel.pixelsPerUnit;
    held.moved ||= far > 4;
    if (held.moved) this.outline.move(held.index, point);
  }

  release(): void {
    const { held } = this;
    this.held = null;
    if (held && !held.fresh && !held.moved && this.outline.closes(held.index)) this.outline.finish();
  }

  hover(contact: Contact | null): string {
    this.ahead = contact && this.outline.isOpen ? contact.point : null;
    this.easel.repaint();
    const index = contact && this.outline.pointAt(contact.point, TARGET[contact.kind]);
    if (index === null) return "crosshair";
    return this.outline.closes(index) ? "pointer" : "grab";
  }

  key(event: KeyboardEvent): boolean {
    this.ahead = null;
    return this.outline.key(event);
  }

  undo(): boolean {
    const wasOpen = this.outline.isOpen;
    this.outline.back();
    return wasOpen;
  }

  cancel(): void {
    const { held } = this;
    this.held = null;
    // A second finger has come: the first meant no corner.
    if (held?.fresh) this.outline.back();
    else if (held) this.outline.move(held.index, held.start);
  }

  dispose(): void {
    this.outline.clear();
  }

  paint(context: CanvasRenderingContext2D, frame: Frame, colours: Theme): void {
    const last = this.outline.points[this.outline.points.length - 1];
    if (last && this.ahead) {
      context.beginPath();
      context.moveTo(pixelX(frame, last.x), pixelY(frame, last.y));
      context.lineTo(pixelX(frame, this.ahead.x), pixelY(frame, this.ahead.y));
      context.strokeStyle = this.easel.side === "reference" ? colours.reference : colours.template;
      context.lineWidth = 1.5 * frame.ratio;
      context.setLineDash([2 * frame.ratio, 5 * frame.ratio]);
      context.stroke();
      context.setLineDash([]);
    }
    this.outline.paint(context, frame, colours);
  }
}

/** The closed polygon with points along its edges as well, so that it can be bent anywhere. Every corner is kept. */
export function polygon(corners: readonly Point[]): Loop {
  const bare = Float64Array.from(corners.flatMap(({ x, y }) => [x, y]));
  const step = perimeter(bare) / SAMPLES;
  return Float64Array.from(
    corners.flatMap((from, i) => {
      const to = corners[(i + 1) % corners.length];
      const count = Math.max(1, Math.round(Math.hypot(to.x - from.x, to.y - from.y) / step));
      return Array.from({ length: count }, (_, k) => [
        from.x + (k / count) * (to.x - from.x),
        from.y + (k / count) * (to.y - from.y),
      ]).flat();
    }),
  );
}
