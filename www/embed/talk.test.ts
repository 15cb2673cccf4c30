/** What a frame answers: only to its parent, only to what is meant for it, and never half. */

import { expect, test, vi } from "vitest";
import { answer, type Host, MOST_LETTERS, MOST_POINTS } from "./talk";

const PARENT = { isParent: true, origin: "https://course.example" };
const STRANGER = { isParent: false, origin: "https://course.example" };

function host(): Host<string> & { readonly states: string[] } {
  const states: string[] = [];
  return {
    states,
    set: (state) => {
      if (!state.startsWith("v=2")) throw new Error("it is no link of this page");
      states.push(state);
    },
    report: () => "the report",
    map: (points) => points.map(([x, y]) => [x / 2, y / 2]),
  };
}

test("the parent sets a state, with or without its #, and hears that it is done", () => {
  const own = host();
  expect(answer({ thinshell: 1, kind: "set", id: 7, state: "#v=2&preset=star" }, PARENT, null, own)).toEqual({
    thinshell: 1,
    id: 7,
    kind: "done",
  });
  answer({ thinshell: 1, kind: "set", state: "v=2&preset=leaf" }, PARENT, null, own);
  expect(own.states).toEqual(["v=2&preset=star", "v=2&preset=leaf"]);
});

test("the parent gets the report, and points carried by φ", () => {
  expect(answer({ thinshell: 1, kind: "get", id: "a" }, PARENT, null, host())).toEqual({
    thinshell: 1,
    id: "a",
    kind: "report",
    report: "the report",
  });
  expect(answer({ thinshell: 1, kind: "map", points: [[0.5, 1]] }, PARENT, null, host())).toEqual({
    thinshell: 1,
    kind: "mapped",
    points: [[0.25, 0.5]],
  });
});

test.each([null, undefined, 1, "thinshell", [], {}, { kind: "set" }, new Map([["thinshell", 1]])])(
  "%j is not for this page, and is not answered",
  (data) => {
    expect(answer(data, PARENT, null, host())).toBeNull();
  },
);

test("a refusal is not answered, or two frames would talk for ever", () => {
  expect(answer({ thinshell: 1, kind: "refused", message: "no" }, PARENT, null, host())).toBeNull();
});

const far = Array.from({ length: MOST_POINTS + 1 }, () => [0, 0]);

test.each([
  [{ thinshell: 2, kind: "get" }, /thinshell must be 1/],
  [{ thinshell: 1 }, /kind must be one of set, get, map/],
  [{ thinshell: 1, kind: "toString" }, /kind must be/],
  [{ thinshell: 1, kind: { valueOf: "get" } }, /kind must be/],
  [{ thinshell: 1, kind: "get", state: "v=2" }, /has no “state”/],
  [{ thinshell: 1, kind: "set", state: "v=2", run: "alert(1)" }, /has no “run”/],
  [{ thinshell: 1, kind: "set" }, /state must be a text/],
  [{ thinshell: 1, kind: "set", state: { v: 2 } }, /state must be a text/],
  [{ thinshell: 1, kind: "set", state: "javascript:alert(1)" }, /no link of this page/],
  [{ thinshell: 1, kind: "set", state: `v=2${"x".repeat(MOST_LETTERS)}` }, /at most 200000 letters/],
  [{ thinshell: 1, kind: "map" }, /points must be/],
  [{ thinshell: 1, kind: "map", points: [[0, 1, 2]] }, /points must be/],
  [{ thinshell: 1, kind: "map", points: [[0, Number.NaN]] }, /points must be/],
  [{ thinshell: 1, kind: "map", points: [[0, 1.5]] }, /points must be/],
  [{ thinshell: 1, kind: "map", points: [["0", "1"]] }, /points must be/],
  [{ thinshell: 1, kind: "map", points: new Array(3) }, /points must be/],
  [{ thinshell: 1, kind: "map", points: [Object.assign(new Array(2), { 0: 0.5 })] }, /points must be/],
  [{ thinshell: 1, kind: "map", points: far }, /at most 10000 points/],
])("a message that is wrong is refused by a sentence, and changes nothing: case %#", (data, words) => {
  const own = host();
  const said = answer({ id: 3, ...data }, PARENT, null, own);
  expect(said).toMatchObject({ thinshell: 1, id: 3, kind: "refused" });
  expect(said?.kind === "refused" && said.message).toMatch(words);
  expect(own.states).toEqual([]);
});

test("a window that does not hold the frame is refused, whatever it asks", () => {
  const own = host();
  const report = vi.spyOn(own, "report");
  for (const kind of ["set", "get", "map"])
    expect(answer({ thinshell: 1, kind, ...(kind === "set" && { state: "v=2" }) }, STRANGER, null, own)).toMatchObject({
      kind: "refused",
      message: "only the page that holds this frame is answered",
    });
  expect(own.states).toEqual([]);
  expect(report).not.toHaveBeenCalled();
});

test("where the address names an origin, a parent of another is refused", () => {
  const own = host();
  const message = { thinshell: 1, kind: "set", state: "v=2" };
  expect(answer(message, PARENT, "https://other.example", own)).toMatchObject({
    kind: "refused",
    message: "only https://other.example is answered, as this frame's address says",
  });
  expect(own.states).toEqual([]);
  expect(answer(message, PARENT, PARENT.origin, own)).toMatchObject({ kind: "done" });
});

test("an id that is neither a number nor a text is left out of the answer", () => {
  expect(answer({ thinshell: 1, kind: "get", id: { a: 1 } }, PARENT, null, host())).not.toHaveProperty("id");
});

test("without a match no point is mapped, and that is said", () => {
  const own = { ...host(), map: () => null };
  expect(answer({ thinshell: 1, kind: "map", points: [] }, PARENT, null, own)).toMatchObject({
    kind: "refused",
    message: expect.stringContaining("no match yet"),
  });
});
