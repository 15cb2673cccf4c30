/** The hand on a sketch surface. It listens to the pointer, once for all tools, and tells the tool that it holds. */

import { type Point, type Similarity, similarityTaking } from "../shapes/geometry";
import type { Frame } from "../view/canvas";
import type { Theme } from "../view/palette";

/** The surface under a hand. */
export interface Ground {
  readonly side: "reference" | "template";
  readonly canvas: HTMLCanvasElement;
  /** CSS pixels a domain unit. */
  readonly pixelsPerUnit: number;
  pointFrom(event: { clientX: number; clientY: number }): Point;
  repaint(): void;
}

/** The pointer at one moment. */
export type Contact = {
  readonly point: Point;
  readonly kind: keyof typeof TARGET;
  /** The event's time. */
  readonly at: number;
  /** Where it has been since the last one, this place last. */
  readonly trail: () => readonly Point[];
};

/** What a tool does with the pointer and with keys. Presses, drags and releases are of one finger. */
export interface Tool {
  press(contact: Contact): void;
  drag(contact: Contact): void;
  release(contact: Contact): void;
  /** What the pointer looks like here, and what is shown of what a press would do; null when it has left. */
  hover?(contact: Contact | null): string;
  /** Two fingers, by what takes their first places to the present ones, until `release`. */
  pinch?(motion: Similarity, at: number): void;
  /** Whether the key meant something to it. */
  key(event: KeyboardEvent): boolean;
  /** Whether there was something under way of which a step could be taken back. */
  undo?(): boolean;
  /** Puts back what the gesture under way has changed. */
  cancel(): void;
  /** It is laid down. */
  dispose?(): void;
  /** Draws what it holds, over the shape. */
  paint(context: CanvasRenderingContext2D, frame: Frame, colours: Theme): void;
}

/** Of what the pointer is to hit, in CSS pixels around it: a finger's target is 44 wide. */
export const TARGET = { mouse: 12, pen: 14, touch: 22 };

export class Hand {
  private readonly fingers = new Map<number, Point>();
  private readonly listening = new AbortController();
  /** Where two fingers have begun; null while there are fewer. */
  private pinched: readonly Point[] | null = null;

  constructor(
    private readonly ground: Ground,
    readonly tool: Tool,
  ) {
    const { canvas } = ground;
    const options = { signal: this.listening.signal };
    canvas.addEventListener("pointerdown", (event) => this.press(event), options);
    canvas.addEventListener("pointermove", (event) => this.move(event), options);
    canvas.addEventListener("pointerup", (event) => this.release(event), options);
    canvas.addEventListener("pointercancel", (event) => this.abandon(event), options);
    canvas.addEventListener("pointerleave", () => tool.hover?.(null), options);
  }

  dispose(): void {
    this.listening.abort();
    this.tool.cancel();
    this.tool.dispose?.();
    this.ground.canvas.style.cursor = "";
    this.ground.repaint();
  }

  private press(event: PointerEvent): void {
    if (event.button !== 0) return;
    const contact = this.contact(event);
    this.fingers.set(event.pointerId, contact.point);
    this.ground.canvas.setPointerCapture(event.pointerId);
    if (this.fingers.size === 1) this.tool.press(contact);
    else if (this.fingers.size === 2) {
      this.tool.cancel();
      this.pinched = [...this.fingers.values()];
    }
    this.ground.repaint();
  }

  private move(event: PointerEvent): void {
    const contact = this.contact(event);
    if (!this.fingers.has(event.pointerId)) {
      this.ground.canvas.style.cursor = this.tool.hover?.(contact) ?? "crosshair";
      return;
    }
    this.fingers.set(event.pointerId, contact.point);
    if (this.pinched) {
      const motion = similarityTaking(this.pinched, [...this.fingers.values()]);
      if (motion) this.tool.pinch?.(motion, contact.at);
    } else this.tool.drag(contact);
    this.ground.repaint();
  }

  private release(event: PointerEvent): void {
    if (!this.fingers.delete(event.pointerId)) return;
    this.pinched = null;
    this.tool.release(this.contact(event));
    this.ground.repaint();
  }

  private abandon(event: PointerEvent): void {
    this.fingers.delete(event.pointerId);
    this.pinched = null;
    this.tool.cancel();
    this.ground.repaint();
  }

  private contact(event: PointerEvent): Contact {
    const { ground } = this;
    return {
      point: ground.pointFrom(event),
      kind: event.pointerType === "touch" || event.pointerType === "pen" ? event.pointerType : "mouse",
      at: event.timeStamp,
      trail: () => {
        const batch = event.getCoalescedEvents?.() ?? [];
        return (batch.length > 0 ? batch : [event]).map((sample) => ground.pointFrom(sample));
      },
    };
  }
}
