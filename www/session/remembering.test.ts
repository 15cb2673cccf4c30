import { signal } from "@preact/signals";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { rememberChanges } from "./remembering";

let leave = () => {};

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal("addEventListener", (_: string, listener: () => void) => {
    leave = listener;
  });
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

function stage(last: string | null) {
  const text = signal("a");
  const written: string[] = [];
  rememberChanges(text, last, (now) => written.push(now));
  return { text, written };
}

test("many changes in a moment are written once, as the last of them", () => {
  const { text, written } = stage("a");
  for (const now of ["b", "c", "d"]) {
    text.value = now;
    vi.advanceTimersByTime(100);
  }
  expect(written).toEqual([]);
  vi.advanceTimersByTime(1000);
  expect(written).toEqual(["d"]);
});

test("what is written down already is not written again, and what is not yet, is", () => {
  const known = stage("a");
  known.text.value = "b";
  known.text.value = "a";
  vi.advanceTimersByTime(1000);
  expect(known.written).toEqual([]);
  const unknown = stage(null);
  vi.advanceTimersByTime(1000);
  expect(unknown.written).toEqual(["a"]);
});

test("leaving the page at once loses nothing", () => {
  const { text, written } = stage("a");
  text.value = "b";
  leave();
  vi.advanceTimersByTime(1000);
  expect(written).toEqual(["b"]);
});
