import { expect, test } from "vitest";
import { Follower } from "./follower";

function bench() {
  const sent: number[] = [];
  let waiting: (() => void) | null = null;
  const follower = new Follower((at) => sent.push(at), {
    request: (then) => {
      waiting = then;
      return 1;
    },
    cancel: () => {
      waiting = null;
    },
  });
  const frame = () => {
    const then = waiting;
    waiting = null;
    then?.();
  };
  return { sent, follower, frame };
}

test("many movements between two frames are sent as one, the newest", () => {
  const { sent, follower, frame } = bench();
  for (const at of [1, 2, 3]) follower.follow(at);
  expect(sent).toEqual([]);
  frame();
  frame();
  expect(sent).toEqual([3]);
});

test("nothing is sent before the answer, and then only the newest", () => {
  const { sent, follower, frame } = bench();
  follower.follow(1);
  frame();
  follower.follow(2);
  frame();
  follower.follow(3);
  frame();
  expect(sent).toEqual([1]);
  follower.answered();
  follower.follow(4);
  frame();
  expect(sent).toEqual([1, 4]);
  follower.answered();
  frame();
  expect(sent).toEqual([1, 4]);
});

test("what was wanted before a stop is never sent, and the next movement waits for no old answer", () => {
  const { sent, follower, frame } = bench();
  follower.follow(1);
  follower.stop();
  frame();
  expect(sent).toEqual([]);
  follower.follow(2);
  frame();
  follower.stop();
  follower.follow(3);
  frame();
  expect(sent).toEqual([2, 3]);
});
