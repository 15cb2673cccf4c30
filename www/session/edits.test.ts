import { effect } from "@preact/signals";
import { expect, test } from "vitest";
import { PRESETS } from "../shapes/presets";
import { Edits, edited, stepOf } from "./edits";

const [FIRST, SECOND] = PRESETS;
const BEGIN = stepOf({ ...FIRST, pins: [] }, {}, FIRST.id);

test("what moves under the hand is seen, but is no step until it is set down", () => {
  const edits = new Edits(BEGIN);
  edits.preview(edited(BEGIN, "template", SECOND.template));
  expect([edits.shapes.value.template, edits.present.template]).toEqual([SECOND.template, FIRST.template]);
  expect([edits.moves, edits.canUndo.value]).toEqual([true, false]);
  edits.restore();
  expect([edits.moves, edits.shapes.value.template]).toEqual([false, FIRST.template]);
});

test("a step is undone with its settings, and done again with them", () => {
  const edits = new Edits(BEGIN);
  edits.commit({ ...BEGIN, settings: { bending: 0 } });
  edits.commit(stepOf({ ...SECOND, pins: [] }, { finest: 6 }, SECOND.id));
  expect(edits.undo()).toBe(true);
  expect([edits.shapes.value.reference, edits.settings.value]).toEqual([FIRST.reference, { bending: 0 }]);
  edits.undo();
  expect([edits.settings.value, edits.canUndo.value, edits.undo()]).toEqual([{}, false, false]);
  edits.redo();
  edits.redo();
  expect([edits.present.preset, edits.settings.value, edits.redo()]).toEqual([SECOND.id, { finest: 6 }, false]);
});

test("a setting that changes leaves the shapes the object that they were", () => {
  const edits = new Edits(BEGIN);
  let seen = 0;
  effect(() => {
    void edits.shapes.value;
    seen += 1;
  });
  edits.commit({ ...BEGIN, settings: { bending: 0 } });
  edits.preview({ ...edits.present, settings: { bending: 1 } });
  expect(seen).toBe(1);
});
