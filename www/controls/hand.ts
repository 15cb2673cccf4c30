/** Puts a tool into the hand that works on a surface. */

import type { kit } from "../pins/kit";
import type { Session, Side } from "../session";
import { finestLevel } from "../settings";
import { Drawing } from "../shapes/draw";
import type { Loop, Shape } from "../shapes/geometry";
import type { Judgement } from "../shapes/judge";
import type { Pin } from "../shapes/pins";
import type { Ground, Hand } from "../tools/hand";
import type { Tool } from "../tools/tool";
import type { Surface } from "../view/canvas";
import { faultWords, WAYS } from "../words/strokes";

export { drawFaulty } from "../view/pen";

type Faulty = Exclude<Judgement, { kind: "tap" | "loop" }>;

export function handOf(tool: Tool, fetched: typeof kit.value, session: Session, side: Side, surface: Surface): Hand {
  const ground: Ground & { side: Side; restore(): void } = {
    side,
    canvas: surface.canvas,
    get pixelsPerUnit() {
      return surface.pixelsPerUnit;
    },
    pointFrom: (event) => surface.pointFrom(event),
    repaint: () => surface.invalidate(),
    restore: () => session.restoreShape(),
  };
  if (tool === "pin" && fetched) {
    const host = Object.assign(ground, {
      shapes: () => session.shapes.value,
      preview: (pins: readonly Pin[], at: number) => session.previewPins(pins, at),
      commit: (pins: readonly Pin[]) => session.commitPins(pins),
      goOn: () => document.getElementById(`${side === "reference" ? "template" : "reference"}-surface`)?.focus(),
    });
    return new fetched.PinHand(host);
  }
  const host = Object.assign(ground, {
    shape: () => session.shapes.value[side],
    isExample: () => session.isExample(side),
    preview: (shape: Shape, at: number) => session.previewShape(side, shape, at),
    commit: (shape: Shape) => session.commitShape(side, shape),
    limits: () => ({ cell: 1 / 2 ** finestLevel(session.settings.value) }),
    ask: ({ kind, size, loop, mended }: Faulty, take: (loop: Loop) => void) => {
      const ways = mended ? [{ label: WAYS[kind], go: () => take(mended) }] : [];
      session.question.value = { side, loop, words: faultWords(kind, size), ways };
    },
  });
  return new Drawing(host);
}
