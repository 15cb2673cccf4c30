import { describe, expect, test } from "vitest";
import { isEstablished, isRunning, isWorking, next, type Phase, type PhaseEvent } from "./phase";

function reach(...events: PhaseEvent[]): Phase {
  return events.reduce<Phase>(next, "idle");
}

/** Every state with all that leads out of it; whatever is not here leads nowhere. */
const TABLE: Readonly<Record<Phase, string>> = {
  idle: "start preparing, drop idle, restore restored",
  cancelled: "start preparing, drop idle, restore restored",
  preparing:
    "start preparing, frame solving, finish matched, refuse idle, pause paused, cancel cancelled, drop idle, restore restored",
  solving: "start preparing, finish matched, refuse idle, pause paused, cancel cancelled, drop idle, restore restored",
  paused: "start preparing, finish matched, refuse idle, resume solving, cancel cancelled, drop idle, restore restored",
  following: "start preparing, refuse astray, refine refining, cancel cancelled, drop idle, restore restored",
  astray:
    "start preparing, frame following, finish following, refine preparing, cancel cancelled, drop idle, restore restored",
  refining:
    "start preparing, finish matched, refuse preparing, pause pausedRefining, follow following, cancel cancelled, drop idle, restore restored",
  pausedRefining:
    "start preparing, finish matched, refuse preparing, resume refining, follow following, refine refining, cancel cancelled, drop idle, restore restored",
  matched: "start preparing, follow following, refine refining, cancel cancelled, drop idle, restore restored",
  restored: "start preparing, cancel cancelled, drop idle, restore restored",
};

const PHASES = Object.keys(TABLE) as Phase[];

const EVENTS: readonly PhaseEvent[] = [
  "start",
  "frame",
  "finish",
  "refuse",
  "pause",
  "resume",
  "follow",
  "refine",
  "cancel",
  "drop",
  "restore",
];

const TRANSITIONS = PHASES.flatMap((phase) => EVENTS.map((event) => [phase, event] as const));

test.each(TRANSITIONS)("%s, %s: leads where the table says, or nowhere", (phase, event) => {
  const named = TABLE[phase].split(", ").find((entry) => entry.startsWith(`${event} `));
  expect(next(phase, event)).toBe(named?.split(" ")[1] ?? phase);
});

describe("a full run", () => {
  test("prepares until the first frame, and ends matched", () => {
    expect(reach("start")).toBe("preparing");
    expect(reach("start", "frame")).toBe("solving");
    expect(reach("start", "frame", "finish")).toBe("matched");
    expect(reach("start", "finish")).toBe("matched");
  });

  test("can be cancelled in each of its states, the first included", () => {
    for (const run of [["start"], ["start", "frame"], ["start", "pause"]] as PhaseEvent[][]) {
      expect(reach(...run, "cancel")).toBe("cancelled");
      expect(reach(...run, "cancel", "start")).toBe("preparing");
    }
  });

  test("that ends while it is being paused is not left to be resumed for ever", () => {
    expect(reach("start", "frame", "pause", "finish")).toBe("matched");
  });

  test("that is refused leaves nothing", () => {
    expect(reach("start", "refuse")).toBe("idle");
  });
});

describe("a match that follows the hand", () => {
  const matched: PhaseEvent[] = ["start", "frame", "finish"];

  test("needs a match to go on from", () => {
    for (const phase of ["idle", "cancelled", "preparing", "solving", "paused", "restored"] as const) {
      expect(isEstablished(phase)).toBe(false);
      expect(next(phase, "follow")).toBe(phase);
    }
    expect(isEstablished("matched")).toBe(true);
  });

  test("is refined when the hand lets go, and refining can be paused", () => {
    expect(reach(...matched, "follow", "frame", "finish")).toBe("following");
    expect(reach(...matched, "follow", "refine", "pause", "resume")).toBe("refining");
    expect(reach(...matched, "follow", "refine", "finish")).toBe("matched");
    expect(reach(...matched, "follow", "refine", "follow")).toBe("following");
  });

  test("that was refused starts anew, unless the hand comes back", () => {
    expect(reach(...matched, "follow", "refuse", "follow")).toBe("astray");
    expect(reach(...matched, "follow", "refuse", "refine")).toBe("preparing");
    expect(reach(...matched, "follow", "refuse", "follow", "frame")).toBe("following");
  });

  test("can be cancelled", () => {
    expect(reach(...matched, "follow", "cancel")).toBe("cancelled");
    expect(reach(...matched, "follow", "refuse", "cancel")).toBe("cancelled");
  });
});

test.each(PHASES)("from %s, Match starts, a failure ends all, and late frames wake nothing that rests", (phase) => {
  expect(next(phase, "start")).toBe("preparing");
  expect(next(phase, "drop")).toBe("idle");
  expect(next(phase, "restore")).toBe("restored");
  if (!isRunning(phase) && !isWorking(phase)) {
    expect(next(phase, "frame")).toBe(phase);
    expect(next(phase, "finish")).toBe(phase);
  }
});
