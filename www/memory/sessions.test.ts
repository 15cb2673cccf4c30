import { expect, test } from "vitest";
import { fakeStorage } from "../testing/storage";
import { MOST, Sessions } from "./sessions";

function stage(room?: number) {
  const storage = fakeStorage(room);
  return { storage, sessions: new Sessions(() => storage) };
}

test("each session has a key of its own, and the newest comes first", () => {
  const { sessions } = stage();
  sessions.write({ id: "a", at: 1, text: "v=2&preset=star" });
  sessions.write({ id: "b", at: 3, text: "v=2&preset=leaf" });
  sessions.write({ id: "a", at: 2, text: "v=2&preset=ring" });
  expect(sessions.list()).toEqual([
    { id: "b", at: 3, text: "v=2&preset=leaf" },
    { id: "a", at: 2, text: "v=2&preset=ring" },
  ]);
  sessions.remove("b");
  expect(sessions.read("b")).toBeNull();
  expect(sessions.read("a")?.text).toBe("v=2&preset=ring");
});

test("of sessions that hold the same, the newest is listed", () => {
  const { sessions } = stage();
  for (const [id, at] of [
    ["a", 1],
    ["b", 2],
  ] as const) {
    sessions.write({ id, at, text: "v=2&preset=star" });
  }
  expect(sessions.list().map(({ id }) => id)).toEqual(["b"]);
});

test("the session of the time before there were several is the oldest", () => {
  const { storage, sessions } = stage();
  storage.setItem("thinshell", "v=1&preset=star");
  sessions.write({ id: "a", at: 1, text: "v=2&preset=leaf" });
  expect(sessions.list().map(({ text }) => text)).toEqual(["v=2&preset=leaf", "v=1&preset=star"]);
  sessions.remove("");
  expect(sessions.list()).toHaveLength(1);
});

test("only so many are kept, and the oldest go", () => {
  const { sessions } = stage();
  for (let i = 1; i <= MOST + 5; i += 1) sessions.write({ id: `s${i}`, at: i, text: `v=2&finest=${i}` });
  expect(sessions.list().map(({ at }) => at)).toEqual(Array.from({ length: MOST }, (_, i) => MOST + 5 - i));
});

test("in a full storage the oldest make room; what does not fit alone is not kept, and says so", () => {
  const { sessions } = stage(200);
  for (let i = 1; i <= 6; i += 1) expect(sessions.write({ id: `s${i}`, at: i, text: "x".repeat(20) + i })).toBe(true);
  const kept = sessions.list();
  expect(kept[0].id).toBe("s6");
  expect(kept.length).toBeLessThan(6);
  expect(sessions.write({ id: "s7", at: 7, text: "x".repeat(300) })).toBe(false);
});

test("without a storage there are no sessions, and no error", () => {
  const sessions = new Sessions(() => {
    throw new DOMException("denied", "SecurityError");
  });
  expect(sessions.list()).toEqual([]);
  expect(sessions.write({ id: "a", at: 1, text: "v=2" })).toBe(false);
  sessions.remove("a");
});

test("what others have written under our name is no session", () => {
  const { storage, sessions } = stage();
  for (const [key, value] of Object.entries({
    "thinshell:x": "{",
    "thinshell:y": "null",
    "thinshell:z": "{}",
    other: "1",
  }))
    storage.setItem(key, value);
  expect(sessions.list()).toEqual([]);
});
