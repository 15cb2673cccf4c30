/** A circle, dragged from its middle outwards. */

import { type Loop, type Point, SAMPLES } from "../shapes/geometry";
import { judgedLoop } from "../shapes/judge";
import { type Frame, pixelX, pixelY, trace } from "../view/canvas";
import type { Theme } from "../view/palette";
import { told } from "../words/drawing";
import { drawCursor, stepped } from "./cursor";
import type { Contact, Tool } from "./hand";
import type { Easel } from "./polygon";
import { said } from "./tool";

export class Circle implements Tool {
  private centre: Point | null = null;
  private rim: Point | null = null;
  /** The place that the arrow keys move. */
  private cursor: Point | null = null;

  constructor(private readonly easel: Easel) {}

  press({ point }: Contact): void {
    this.cursor = null;
    this.centre = point;
    this.rim = point;
  }

  drag({ point }: Contact): void {
    if (this.centre) this.rim = point;
  }

  release(): void {
    this.finish();
  }

  key(event: KeyboardEvent): boolean {
    const at = this.cursor ?? { x: 0.5, y: 0.5 };
    const next = stepped(at, event);
    if (next) {
      this.cursor = next;
      if (this.centre) this.rim = next;
      said.value = this.centre ? told.rim(next, this.radius) : told.walk(next, null, 0, false);
    } else if (event.key === "Enter" || event.key === " ") {
      this.cursor = at;
      if (this.centre) this.finish();
      else {
        this.centre = at;
        this.rim = at;
        said.value = told.centre(at);
      }
    } else if (event.key === "Escape") {
      if (this.centre) said.value = told.circleGivenUp;
      this.cancel();
    } else return false;
    this.easel.repaint();
    return true;
  }

  cancel(): void {
    this.centre = null;
    this.rim = null;
    this.easel.repaint();
  }

  paint(context: CanvasRenderingContext2D, frame: Frame, colours: Theme): void {
    const { centre, radius } = this;
    const { ratio } = frame;
    if (centre) {
      context.strokeStyle = this.easel.side === "reference" ? colours.reference : colours.template;
      context.fillStyle = context.strokeStyle;
      context.lineWidth = 2.5 * ratio;
      context.beginPath();
      trace(context, frame, circle(centre, radius), true);
      context.stroke();
      context.beginPath();
      context.arc(pixelX(frame, centre.x), pixelY(frame, centre.y), 3.5 * ratio, 0, 2 * Math.PI);
      context.fill();
    }
    if (this.cursor && document.activeElement === this.easel.canvas) drawCursor(context, frame, colours, this.cursor);
  }

  private get radius(): number {
    const { centre, rim } = this;
    return centre && rim ? Math.hypot(rim.x - centre.x, rim.y - centre.y) : 0;
  }

  /** A press without a drag draws nothing. */
  private finish(): void {
    const { centre, radius } = this;
    this.cancel();
    if (centre) this.easel.draw(judgedLoop(circle(centre, radius), this.easel.limits()));
  }
}

function circle({ x, y }: Point, radius: number): Loop {
  const out = new Float64Array(2 * SAMPLES);
  for (let k = 0; k < SAMPLES; k += 1) {
    const t = (2 * Math.PI * k) / SAMPLES;
    out[2 * k] = x + radius * Math.cos(t);
    out[2 * k + 1] = y + radius * Math.sin(t);
  }
  return out;
}
