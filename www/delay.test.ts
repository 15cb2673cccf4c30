import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { Delay } from "./delay";

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

test("only the last of many wishes is done, a moment after it", () => {
  const done: number[] = [];
  const delay = new Delay(100);
  for (const wish of [1, 2, 3]) {
    delay.start(() => done.push(wish));
    vi.advanceTimersByTime(99);
  }
  expect(done).toEqual([]);
  vi.advanceTimersByTime(1);
  expect(done).toEqual([3]);
});

test("what was stopped is never done", () => {
  const done: number[] = [];
  const delay = new Delay(100);
  delay.start(() => done.push(1));
  delay.stop();
  vi.advanceTimersByTime(1000);
  expect(done).toEqual([]);
});
