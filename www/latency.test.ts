import { expect, test } from "vitest";
import { Latency } from "./latency";

function bench() {
  const reported: number[] = [];
  return { reported, latency: new Latency((from) => reported.push(from)) };
}

test("the first frame after an update is reported with its event's time, once it is drawn", () => {
  const { reported, latency } = bench();
  latency.ask(5);
  latency.receive();
  expect(reported).toEqual([]);
  latency.drawn();
  latency.drawn();
  expect(reported).toEqual([5]);
});

test("an update's further frames, and those of a full match, answer no event", () => {
  const { reported, latency } = bench();
  latency.ask(5);
  latency.receive();
  latency.receive();
  latency.drawn();
  latency.ask(6);
  latency.forget();
  latency.receive();
  latency.drawn();
  expect(reported).toEqual([]);
});
