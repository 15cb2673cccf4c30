import { expect, test } from "vitest";
import { begun, changed, redone, undone } from "./history";

test("undo and redo walk through all that was", () => {
  const third = changed(changed(begun("a"), "b"), "c");
  expect(undone(third).present).toBe("b");
  expect(undone(undone(third)).present).toBe("a");
  expect(redone(undone(third))).toEqual(third);
});

test("the ends of the history hold", () => {
  const only = begun("a");
  expect(undone(only)).toBe(only);
  expect(redone(only)).toBe(only);
});

test("a change after an undo drops what was undone", () => {
  const history = changed(undone(changed(begun("a"), "b")), "c");
  expect(history).toEqual({ past: ["a"], present: "c", future: [] });
});

test("a long history forgets its oldest steps first", () => {
  let history = begun(0);
  for (let i = 1; i <= 500; i += 1) history = changed(history, i);
  expect(history.past).toHaveLength(200);
  expect(history.past[0]).toBe(300);
});
