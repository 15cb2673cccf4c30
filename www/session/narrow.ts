/** Asks, a moment after each step, whether the finest grid resolves the shapes. */

import { effect, type ReadonlySignal } from "@preact/signals";
import { Delay } from "../delay";
import type { Shapes } from "../shapes/pins";

const INSPECT_MILLIS = 300;

type Outlines = Pick<Shapes, "reference" | "template">;

/** `forget` what was known; `inspect` what is there now. */
export function inspectChanges(
  step: ReadonlySignal<Outlines>,
  inspector: { changed(): void; inspect(shapes: Outlines): void },
): void {
  const delay = new Delay(INSPECT_MILLIS);
  effect(() => {
    const { reference, template } = step.value;
    delay.stop();
    inspector.changed();
    if (reference.length === 0 || template.length === 0) return;
    delay.start(() => inspector.inspect({ reference, template }));
  });
}
