import { expect, test } from "vitest";
import { FIELDS, type SettingField } from "../settings";
import { PRESETS } from "../shapes/presets";
import { Choices } from "./choices";
import { Edits, stepOf } from "./edits";

const [FIRST] = PRESETS;

function field(name: SettingField["name"]): SettingField {
  const found = FIELDS.find((one) => one.name === name);
  if (!found) throw new Error(`${name} is no setting of the page`);
  return found;
}

/** Notes what choices come to. */
function stage({ isEmpty = false } = {}) {
  const edits = new Edits(stepOf({ ...FIRST, pins: [] }, { bending: 1 }, FIRST.id));
  const told: string[] = [];
  const choices = new Choices(edits, {
    isEmpty,
    commit: (step) => {
      told.push(`commit ${JSON.stringify(step.settings)}`);
      edits.commit(step);
    },
    preview: (step, at) => {
      told.push(`preview ${JSON.stringify(step.settings)} at ${at}`);
      edits.preview(step);
    },
    restored: () => told.push("restored"),
    match: () => told.push("match"),
  });
  return { choices, told };
}

test("a choice is a step, and the same choice again is none", () => {
  const { choices, told } = stage();
  choices.change(field("bending"), 2);
  choices.change(field("bending"), 2);
  choices.change(field("bending"), field("bending").initial);
  choices.reset();
  expect(told).toEqual(['commit {"bending":2}', "commit {}"]);
});

test("a slider that comes back to where it was leaves nothing behind", () => {
  const { choices, told } = stage();
  choices.preview(field("bending"), 5, 17);
  choices.change(field("bending"), 1);
  expect(told).toEqual(['preview {"bending":5} at 17', "restored"]);
});

test("a value is tried out where there is something to match, and a grid is matched on whatever there is", () => {
  const some = stage();
  some.choices.tryOut(field("bending"), 0);
  some.choices.matchOn(8);
  expect(some.told).toEqual(['commit {"bending":0}', "match", 'commit {"bending":0,"finest":8}', "match"]);
  const none = stage({ isEmpty: true });
  none.choices.tryOut(field("bending"), 0);
  expect(none.told).toEqual(['commit {"bending":0}']);
});
