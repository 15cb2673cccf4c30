import { effect, type ReadonlySignal, useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { space as say } from "../words/space";
import { keyed, orbited, type Pose, panned, zoomed } from "./camera";
import { PinMarks, type Pixel, type Size, setPin } from "./Pins";
import { Mark, point, type Shown } from "./partners";
import type { SpaceSession } from "./session";
import { type Scene, Stage } from "./stage";

type Properties = {
  readonly session: SpaceSession;
  readonly scene: ReadonlySignal<Scene>;
  readonly morph: ReadonlySignal<number>;
  readonly label: string;
  readonly role: "application" | "img";
  readonly id: string;
  /** Whose surface it shows: what is under the pointer has its partner in the other views. */
  readonly shown: Shown;
  /** Told of the canvas's drawing, for pictures; null when there is none. */
  readonly staged?: (stage: Stage | null) => void;
};

/** A press that moves by no more sets a pin and does not turn. Pixels. */
const STILL_HAND = 4;

/** A scene that can be turned, moved and zoomed by mouse, fingers and keys; every view turns with it. */
export function SolidCanvas({ session, scene, morph, label, role, id, shown, staged }: Properties) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const pressed = useRef<Pixel | null>(null);
  const size = useSignal<Size>({ width: 0, height: 0 });

  useEffect(() => {
    if (!canvas.current) return;
    const target = canvas.current;
    let stage: Stage;
    try {
      stage = new Stage(target);
    } catch {
      session.problem.value = say.noWebGl;
      return;
    }
    staged?.(stage);
    let pending = 0;
    let drawn: Scene | null = null;
    const draw = () => {
      pending = 0;
      if (drawn !== scene.peek()) stage.show(scene.peek());
      drawn = scene.peek();
      stage.draw(session.pose.peek(), morph.peek());
    };
    const invalidate = () => {
      pending ||= requestAnimationFrame(draw);
    };
    const stop = effect(() => {
      for (const seen of [scene, morph, session.pose]) seen.value;
      invalidate();
    });
    const watcher = new ResizeObserver(() => {
      size.value = { width: target.clientWidth, height: target.clientHeight };
      invalidate();
    });
    watcher.observe(target);
    const unbind = gestures(target, session);
    return () => {
      staged?.(null);
      unbind();
      watcher.disconnect();
      stop();
      cancelAnimationFrame(pending);
      stage.dispose();
    };
  }, [session, scene, morph, staged, size]);

  const press = (event: KeyboardEvent) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "Enter" && shown !== "result" && session.pinning.peek() && canvas.current) {
      event.preventDefault();
      setPin(session, shown, canvas.current);
      return;
    }
    if (event.key === "Escape") session.begun.value = null;
    const pose = keyed(session.pose.value, event.key, event.shiftKey);
    if (!pose) return;
    event.preventDefault();
    session.pose.value = pose;
  };
  return (
    <>
      <canvas
        ref={canvas}
        tabIndex={0}
        role={role}
        id={id}
        aria-label={label}
        aria-describedby="space-keys"
        onKeyDown={press}
        onPointerDown={({ offsetX: x, offsetY: y }) => {
          pressed.current = { x, y };
        }}
        onClick={({ offsetX: x, offsetY: y }) => {
          const from = pressed.current;
          const isDrag = !from || Math.hypot(x - from.x, y - from.y) > STILL_HAND;
          if (shown !== "result" && session.pinning.peek() && !isDrag && canvas.current)
            setPin(session, shown, canvas.current, { x, y });
        }}
        onPointerMove={(event) => point(session, shown, event)}
        onPointerLeave={() => {
          session.partners.value = null;
        }}
      />
      <PinMarks session={session} shown={shown} morph={morph} canvas={canvas} size={size} />
      <Mark session={session} shown={shown} morph={morph} canvas={canvas} />
    </>
  );
}

/** Pointers and the wheel; returns what ends it. */
function gestures(canvas: HTMLCanvasElement, session: SpaceSession): () => void {
  const held = new Map<number, PointerEvent>();
  const change = (pose: Pose) => {
    session.pose.value = pose;
  };
  const down = (event: PointerEvent) => {
    held.set(event.pointerId, event);
    canvas.setPointerCapture(event.pointerId);
  };
  const move = (event: PointerEvent) => {
    const before = held.get(event.pointerId);
    if (!before) return;
    held.set(event.pointerId, event);
    const side = canvas.clientWidth || 1;
    const [dx, dy] = [(event.clientX - before.clientX) / side, (event.clientY - before.clientY) / side];
    const pose = session.pose.peek();
    const other = [...held.values()].find(({ pointerId }) => pointerId !== event.pointerId);
    if (other) {
      const apart = (at: PointerEvent) => Math.hypot(at.clientX - other.clientX, at.clientY - other.clientY) || 1;
      change(zoomed(panned(pose, dx / 2, -dy / 2), apart(event) / apart(before)));
    } else if (event.shiftKey || event.buttons > 1) change(panned(pose, dx, -dy));
    else change(orbited(pose, -Math.PI * dx, Math.PI * dy));
  };
  const up = ({ pointerId }: PointerEvent) => {
    held.delete(pointerId);
  };
  // Only where it has been chosen: the page is to scroll past it.
  const wheel = (event: WheelEvent) => {
    if (document.activeElement !== canvas && !event.ctrlKey) return;
    event.preventDefault();
    change(zoomed(session.pose.peek(), Math.exp(-event.deltaY / 500)));
  };
  const menu = (event: Event) => event.preventDefault();
  const bound = [
    ["pointerdown", down],
    ["pointermove", move],
    ["pointerup", up],
    ["pointercancel", up],
    ["wheel", wheel],
    ["contextmenu", menu],
  ] as [string, EventListener][];
  for (const [type, listener] of bound) canvas.addEventListener(type, listener, { passive: false });
  return () => {
    for (const [type, listener] of bound) canvas.removeEventListener(type, listener);
  };
}
