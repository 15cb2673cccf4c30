import type { ReadonlySignal } from "@preact/signals";
import type { RefObject } from "preact";
import { lensOf, projected, rayThrough } from "./camera";
import { picked, pointOf } from "./pick";
import type { Partners, Side, SpaceSession } from "./session";
import type { Vector } from "./solid";

export type Shown = Side | "result";

/** Finds what is under the pointer, and where it belongs; nothing while something is held or no match is there. */
export function point(
  session: SpaceSession,
  shown: Shown,
  { currentTarget, offsetX, offsetY, buttons }: Pointed,
): void {
  const { clientWidth: width, clientHeight: height } = currentTarget;
  const lens = lensOf(session.pose.peek());
  const ray = rayThrough(lens, (2 * offsetX - width) / height, (height - 2 * offsetY) / height);
  session.partners.value = buttons > 0 ? null : found(session, shown, lens.eye, ray);
}

type Pointed = Pick<PointerEvent, "offsetX" | "offsetY" | "buttons"> & { readonly currentTarget: HTMLCanvasElement };

function found(session: SpaceSession, shown: Shown, eye: Vector, ray: Vector): Partners | null {
  const result = session.shown.peek();
  if (!result) return null;
  const { reference, template, frame } = result;
  if (shown === "template") {
    const hit = picked(eye, ray, template.positions, template.indices);
    if (!hit || !frame.partners) return null;
    const partner = pointOf(hit, frame.partners, template.indices);
    // Not a number where the deformed box does not reach.
    if (Number.isNaN(partner[0])) return null;
    return { reference: partner, template: pointOf(hit, template.positions, template.indices) };
  }
  const part = shown === "result" ? session.morph.peek() : 0;
  const seen = part === 0 ? reference.positions : reference.positions.map((x, k) => x + part * (frame.matched[k] - x));
  const hit = picked(eye, ray, seen, reference.indices);
  return (
    hit && {
      reference: pointOf(hit, reference.positions, reference.indices),
      template: pointOf(hit, frame.matched, reference.indices),
    }
  );
}

type Marked = {
  readonly session: SpaceSession;
  readonly shown: Shown;
  readonly morph: ReadonlySignal<number>;
  readonly canvas: RefObject<HTMLCanvasElement | null>;
};

/** A ring around the point under the pointer, or its partner, over one of the views. */
export function Mark({ session, shown, morph, canvas }: Marked) {
  const partners = session.partners.value;
  if (!partners || !canvas.current) return null;
  const { clientWidth: width, clientHeight: height } = canvas.current;
  const part = shown === "template" ? 1 : shown === "reference" ? 0 : morph.value;
  const [x, y, z] = [0, 1, 2].map((k) => (1 - part) * partners.reference[k] + part * partners.template[k]);
  const [right, up] = projected(lensOf(session.pose.value), [x, y, z]);
  const place = { left: `${(width + height * right) / 2}px`, top: `${(height - height * up) / 2}px` };
  return <span class="partner" style={place} aria-hidden="true" />;
}
