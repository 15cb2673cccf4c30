import { computed, effect, untracked } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { isDone, isWorking } from "../phase";
import { begun, chosen, kit } from "../pins/kit";
import type { Session, Side } from "../session";
import { finestLevel } from "../settings";
import { bounds, CLEARANCE } from "../shapes/geometry";
import type { Hand } from "../tools/hand";
import { curve, kit as further, knot } from "../tools/kit";
import { hands, tool } from "../tools/tool";
import { nearest } from "../view/along";
import { Surface } from "../view/canvas";
import { arcLengthParts } from "../view/curve";
import { BOX } from "../view/framing";
import { probeAt } from "../view/probe";
import { zip } from "../view/result";
import { drawSketch } from "../view/sketch";
import { en } from "../words/en";
import { Enlarge } from "./Enlarge";
import { ImportButton } from "./Import";
import { guess, probe } from "./viewing";

/** Of the pointer to the reference, in CSS pixels, to show the partner of its nearest point. */
const PROBE_REACH = 24;

/** Which lines of the page tell what keys do; see index.html. */
const KEYS = {
  draw: "keys",
  circle: "outline-keys",
  polygon: "outline-keys",
  mirror: "outline-keys",
  points: "outline-keys",
  pin: "pin-keys",
};

/** One sketch surface with its heading and Clear button. */
export function SketchPanel({ session, side }: { session: Session; side: Side }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const hand = useRef<Hand>(null);
  const ground = useRef<Surface>(null);

  useEffect(() => {
    if (!canvas.current) return;
    const surface = new Surface(
      canvas.current,
      () => BOX,
      (context, frame, colours) => {
        drawSketch(context, frame, colours, {
          side,
          shape: session.shapes.value[side],
          coloured: colouredLoops(session, side),
          tooClose: tooClose(session, side),
          mark: markOf(session, side),
        });
        const chosen = chosenLoop(session, side);
        if (chosen) further.peek()?.drawChosen(context, frame, colours, side, chosen);
        kit.peek()?.drawPins(context, frame, colours, session.shapes.value, side);
        const question = session.question.value;
        if (question?.side === side) hands.peek()?.drawFaulty(context, frame, colours, question.loop);
        hand.current?.tool.paint(context, frame, colours);
      },
    );
    ground.current = surface;
    const stopHand = effect(() => {
      const [wanted, fetched] = [tool.value, hands.value];
      untracked(() => {
        hand.current?.dispose();
        hand.current = fetched?.handOf(wanted, session, side, surface) ?? null;
      });
      surface.invalidate();
    });
    // Computed, so that this surface rests while only the other shape or the match moves.
    const shape = computed(() => session.shapes.value[side]);
    const pins = computed(() => session.shapes.value.pins);
    const coloured = computed(() => colourOf(session, side));
    const mark = computed(() => markOf(session, side));
    const stop = effect(() => {
      const signals = [shape, pins, coloured, mark, begun, chosen, kit, further, curve, knot, session.question];
      for (const shown of [...signals, session.settings]) shown.value;
      surface.invalidate();
    });
    return () => {
      stop();
      stopHand();
      hand.current?.dispose();
      surface.dispose();
    };
  }, [session, side]);

  const repaint = () => ground.current?.invalidate();

  const press = (event: KeyboardEvent) => {
    const holds = hand.current?.tool;
    // A point of what is under way, before a step of the page's history.
    const isUndo = (event.ctrlKey || event.metaKey) && !event.shiftKey && event.key.toLowerCase() === "z";
    if (isUndo && holds?.undo?.()) event.stopPropagation();
    else if (event.ctrlKey || event.metaKey || event.altKey || !holds?.key(event)) return;
    event.preventDefault();
  };

  const point = (event: PointerEvent) => {
    const loops = session.match.value?.curves.reference;
    // While the solver works, points come and go with every frame, and the hand is to be answered first.
    if (!canvas.current || !loops || event.buttons !== 0 || isWorking(session.phase.value)) return;
    const box = canvas.current.getBoundingClientRect();
    const x = (event.clientX - box.left) / box.width;
    const y = (box.bottom - event.clientY) / box.height;
    probe.value = probeAt(loops, [], x, y, PROBE_REACH / box.width);
  };

  const empty = session.shapes.value[side].length === 0;
  return (
    <section class="sketch" aria-labelledby={`${side}-name`}>
      <header>
        <h2 id={`${side}-name`} class={side}>
          {en.sketch.names[side]}
        </h2>
        <div class="tools">
          <ImportButton side={side} />
          <button
            type="button"
            class="quiet"
            aria-label={en.sketch.clearSide(side)}
            disabled={empty}
            onClick={() => session.commitShape(side, [])}
          >
            {en.sketch.clear}
          </button>
        </div>
      </header>
      <div class="surface">
        {/* biome-ignore lint/a11y/noInteractiveElementToNoninteractiveRole: application is the role of a surface with keys of its own */}
        <canvas
          ref={canvas}
          tabIndex={0}
          role="application"
          id={`${side}-surface`}
          aria-label={en.sketch.surface[side]}
          aria-describedby={KEYS[tool.value]}
          onKeyDown={press}
          onFocus={repaint}
          onBlur={repaint}
          onPointerMove={side === "reference" ? point : undefined}
          onPointerLeave={() => {
            probe.value = null;
          }}
        />
        {empty && <p class="invitation">{en.sketch.invitation}</p>}
        <Enlarge session={session} side={side} />
      </div>
    </section>
  );
}

/** The curve that is smoothed or deleted next. */
function chosenLoop(session: Session, side: Side) {
  const at = tool.value === "draw" ? curve.value : null;
  return at?.side === side ? session.shapes.value[side][at.loop] : undefined;
}

/** The place pointed at on the reference, and its partner on the template. */
function markOf(session: Session, side: Side) {
  const match = session.match.value;
  const at = probe.value;
  if (!match || !at) return null;
  if (side === "reference") return at;
  const near = nearest(match.curves.reference, at.x, at.y);
  const loop = near && match.curves.matched[near.loop];
  return near && loop ? { x: loop[2 * near.point], y: loop[2 * near.point + 1] } : null;
}

/** The solver refuses a shape this close to the border: show it before it does. */
function tooClose(session: Session, side: Side): number | null {
  const limit = CLEARANCE / 2 ** finestLevel(session.settings.value);
  const box = bounds(session.shapes.value[side]);
  const distance = box ? Math.min(box.left, box.bottom, 1 - box.right, 1 - box.top) : 1;
  return distance < limit ? limit : null;
}

/** The reference always shows its arc length; the template shows that of its partners once they are found. */
function colouredLoops(session: Session, side: Side) {
  const shape = session.shapes.value[side];
  if (side === "reference") return zip(shape, arcLengthParts(shape));
  const match = colourOf(session, side);
  return match && zip(match.curves.matched, arcLengthParts(match.curves.reference));
}

/** The finished match that gives the template its colours. */
function colourOf(session: Session, side: Side) {
  // Nor while somebody is to guess what they tell.
  return side === "template" && isDone(session.phase.value) && !guess.value ? session.match.value : null;
}
