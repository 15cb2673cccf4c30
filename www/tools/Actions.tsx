import { useRef } from "preact/hooks";
import { kit as pins } from "../pins/kit";
import type { Session, Side } from "../session";
import type { Loop } from "../shapes/geometry";
import { actions, guides, told } from "../words/drawing";
import { focusOn } from "./focus";
import { curve, knot, open } from "./kit";
import { rounded } from "./rounding";
import { said, tool } from "./tool";

/** What can be done by a press to the outline under way, or to the chosen curve. */
export function Actions({ session }: { session: Session }) {
  const waiting = open.value?.outline;
  if (waiting) {
    const { side } = waiting.ground;
    // What was pressed may be gone by that.
    const then = (act: () => void) => () => {
      act();
      focusOn(side);
    };
    return (
      <div class="group next">
        <button type="button" onClick={then(() => waiting.finish())}>
          {actions.close}
        </button>
        <button type="button" onClick={then(() => waiting.back())}>
          {actions.back}
        </button>
        <button type="button" class="quiet" onClick={then(() => waiting.giveUp())}>
          {actions.giveUp}
        </button>
      </div>
    );
  }
  const marked = tool.value === "points" && knot.value?.tool;
  if (marked) {
    const remove = () => {
      marked.remove();
      focusOn(marked.side);
    };
    return (
      <div class="group next">
        <button type="button" onClick={remove}>
          {actions.deletePoint}
        </button>
      </div>
    );
  }
  const chosen = tool.value === "points" ? null : curve.value;
  const shape = chosen && session.shapes.value[chosen.side];
  const loop = chosen && shape?.[chosen.loop];
  if (!chosen || !loop) return null;
  const remove = () => {
    session.commitShape(
      chosen.side,
      shape.filter((_, l) => l !== chosen.loop),
    );
    curve.value = null;
    said.value = told.curveDeleted(chosen.side);
    focusOn(chosen.side);
  };
  return (
    <div class="group next">
      <Rounding session={session} side={chosen.side} index={chosen.loop} loop={loop} />
      {shape.length > 1 && (
        <button type="button" onClick={remove}>
          {actions.deleteCurve}
        </button>
      )}
    </div>
  );
}

/** What can be done next with the tool. */
export function guide(): string | null {
  if (open.value) return guides.open(open.value.count, open.value.outline.least);
  const name = tool.value;
  return name === "draw" || name === "pin" ? null : guides[name];
}

/** What a smoothed curve was before, and by how much it is smoothed: the slider goes both ways. */
const origins = new WeakMap<Loop, { readonly base: Loop; readonly percent: number }>();

/** After so long without a key, what keys have smoothed is one step to undo. */
const REST_MILLIS = 700;

type RoundingProperties = {
  readonly session: Session;
  readonly side: Side;
  readonly index: number;
  readonly loop: Loop;
};

function Rounding({ session, side, index, loop }: RoundingProperties) {
  const byKey = useRef(false);
  const resting = useRef<ReturnType<typeof setTimeout>>(undefined);
  const { base, percent } = origins.get(loop) ?? { base: loop, percent: 0 };

  const preview = (wanted: number, at: number) => {
    const before = session.present;
    const next = rounded(base, wanted / 100);
    if (next !== base) origins.set(next, { base, percent: wanted });
    const shape = before[side].map((old, l) => (l === index ? next : old));
    const carried = before.pins.length > 0 && pins.peek()?.followed(before.pins, side, before[side], shape);
    const { reference, template, pins: none } = before;
    session.previewShapes({ reference, template, pins: carried || none, [side]: shape }, at);
  };
  const commit = () => {
    clearTimeout(resting.current);
    if (!session.moves) return;
    session.commitShapes(session.shapes.value, { ...session.present.examples, [side]: false });
    said.value = told.rounded(origins.get(session.shapes.value[side][index])?.percent ?? 0, side);
  };
  return (
    <label class="rounding">
      {actions.rounding}
      <input
        type="range"
        min={0}
        max={100}
        value={percent}
        aria-valuetext={actions.roundness(percent)}
        onInput={(event) => preview(event.currentTarget.valueAsNumber, event.timeStamp)}
        onPointerDown={() => {
          byKey.current = false;
        }}
        onKeyDown={(event) => {
          byKey.current = true;
          // Undo is to find the step.
          if (event.ctrlKey || event.metaKey) commit();
        }}
        onChange={() => {
          clearTimeout(resting.current);
          if (byKey.current) resting.current = setTimeout(commit, REST_MILLIS);
          else commit();
        }}
        onBlur={commit}
      />
    </label>
  );
}
