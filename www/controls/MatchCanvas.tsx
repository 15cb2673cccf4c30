import { effect, type ReadonlySignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { Surface } from "../view/canvas";
import { framing, type Square, seenOf } from "../view/framing";
import { movedAt, movedLoops, wayOf } from "../view/morph";
import { drawMark, probeAt, stepped } from "../view/probe";
import type { ResultScene } from "../view/result";
import { arrows, draw, guess, lazy, local, picture, probe, view } from "./viewing";

/** Of a pointer to the curves, in CSS pixels. */
const REACH = 24;

type Properties = {
  readonly label: ReadonlySignal<string> | string;
  readonly scene: ReadonlySignal<ResultScene>;
  /** Where the view's scale ends; see views.ts. */
  readonly limit: ReadonlySignal<number>;
  readonly drawn?: (scene: ResultScene) => void;
};

/** A match in the chosen view. Pointing at the curve, or walking along it with the arrow keys, probes it. */
export function MatchCanvas({ label, scene, limit, drawn }: Properties) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const surface = useRef<Surface>(null);

  useEffect(() => {
    if (!canvas.current) return;
    let square: Square | null = null;
    let legend = false;
    const seen = () => {
      // Another kind of square begins anew.
      if (legend !== (view.peek() !== "grid")) square = null;
      legend = view.peek() !== "grid";
      square = framing(seenOf(scene.peek()), square, { legend });
      return square;
    };
    const made = new Surface(canvas.current, seen, (context, frame, colours) => {
      const now = scene.peek();
      const { match } = now;
      draw(context, frame, colours, now, limit.peek());
      const at = probe.peek();
      const numbers = match && at && local.peek()?.localNumbers(match, at);
      if (numbers) {
        const partner = Float64Array.of(numbers.partnerX, numbers.partnerY);
        const [x, y] = movedAt(wayOf(match), [numbers.x, numbers.y], partner, now.morph);
        drawMark(context, frame, colours, numbers, colours.reference);
        drawMark(context, frame, colours, { x, y }, colours.template);
      }
      drawn?.(now);
    });
    surface.current = made;
    const stop = effect(() => {
      for (const shown of [scene, limit, view, lazy, picture, probe, local, arrows, guess]) shown.value;
      made.invalidate();
    });
    return () => {
      stop();
      made.dispose();
    };
  }, [scene, limit, drawn]);

  const point = (event: PointerEvent) => {
    const { match, morph } = scene.peek();
    if (!match || !surface.current) return;
    const { x, y } = surface.current.pointFrom(event);
    const asked = guess.peek();
    if (asked?.of === match.deformation) {
      asked.moved({ x, y });
      if (event.type === "pointerdown") asked.place();
      return;
    }
    const { reference } = match.curves;
    probe.value = probeAt(reference, movedLoops(match, morph), x, y, REACH / surface.current.pixelsPerUnit);
  };
  const press = (event: KeyboardEvent) => {
    const asked = guess.peek();
    if (asked && asked.of === scene.peek().match?.deformation && (event.key === "Enter" || asked.key(event.key))) {
      event.preventDefault();
      if (event.key === "Enter") asked.place();
      return;
    }
    const steps = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
    const { match } = scene.peek();
    if (event.key === "Escape") probe.value = null;
    if (!steps || !match) return;
    event.preventDefault();
    probe.value = stepped(match.curves.reference, probe.peek(), event.shiftKey ? steps : 5 * steps);
  };
  return (
    <canvas
      ref={canvas}
      role="img"
      tabIndex={0}
      aria-label={label}
      aria-describedby="result-keys"
      class="result"
      onPointerMove={point}
      onPointerDown={point}
      onPointerLeave={() => {
        probe.value = null;
      }}
      onKeyDown={press}
    />
  );
}
