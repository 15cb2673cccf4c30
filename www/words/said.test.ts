import { expect, test } from "vitest";
import type { Phase } from "../phase";
import type { Status } from "../protocol";
import { VIEWS } from "../view/names";
import { en } from "./en";
import { captions } from "./later";
import { headline, resultState, verdict } from "./said";

function status(more: Partial<Status> = {}): Status {
  return {
    finished: true,
    stop: "Converged: the energy falls no more.",
    level: 6,
    iteration: 12,
    evaluations: 40,
    energies: { membrane: 0, bending: 0, mismatch: 0, volume: 0, pins: 0, total: 0 },
    leastDeterminant: 0.5,
    mismatch: { mean: 0.01, max: 0.02 },
    cover: { mean: 0.01, max: 0.03 },
    stretch: { mean: 1, deviation: 0 },
    measure: 1,
    backend: "cpu",
    verdict: "Fits: nowhere more than 0.03 cells off.",
    facts: Float64Array.of(0, 0, 4),
    approach: "Matching directly",
    ...more,
  };
}

const SAID: readonly (readonly [Phase, string, string])[] = [
  ["idle", "Ready: press Match.", "Ready: press Match."],
  ["cancelled", "Cancelled. Press Match to start again.", "Cancelled. Press Match to start again."],
  ["preparing", "Preparing the shapes …", "Preparing the shapes …"],
  ["solving", "Matching …", "Matching directly, on the 65 × 65 grid …"],
  ["paused", "Paused.", "Paused."],
  ["following", "Following your hand …", "Following your hand …"],
  ["astray", "Following your hand …", "Following your hand …"],
  ["refining", "Matching …", "Matching directly, on the 65 × 65 grid …"],
  ["pausedRefining", "Paused.", "Paused."],
  ["matched", "The shapes have changed: press Match.", "Fits: nowhere more than 0.03 cells off, too small to see."],
  ["restored", "The shapes have changed: press Match.", "Fits: nowhere more than 0.03 cells off, too small to see."],
];

test.each(SAID)("in the state “%s” the sentence is “%s” without a frame, “%s” with one", (phase, without, with_) => {
  const told = { phase, loaded: true, stale: false };
  expect(headline({ ...told, status: null })).toBe(without);
  expect(headline({ ...told, status: status() })).toBe(with_);
});

test("until the solver is there, that is what is waited for", () => {
  expect(headline({ phase: "preparing", loaded: false, status: null, stale: false })).toBe("Loading the solver …");
});

test("a result of other settings is no answer to those chosen now", () => {
  const told = { phase: "matched", loaded: true, status: status(), stale: true } as const;
  expect(headline(told)).toBe("The settings have changed: press Match.");
  expect(resultState(told)).toBe("matched, but with other settings than those chosen now");
  expect(headline({ ...told, otherPins: true })).toBe("The pins have changed: press Match.");
  expect(resultState({ ...told, otherPins: true })).toBe("matched, but with other pins than those set now");
});

test("what fits is called too small to see only where it is, on whatever grid", () => {
  const off = (level: number, max: number) => verdict(status({ level, cover: { mean: 0.01, max } }));
  for (const [level, max] of [
    [5, 0.06],
    [7, 0.24],
    [9, 0.9],
  ])
    expect(off(level, max)).toMatch(/, too small to see\.$/);
  for (const [level, max] of [
    [5, 0.07],
    [7, 0.26],
  ])
    expect(off(level, max)).toBe("Fits: nowhere more than 0.03 cells off.");
});

test("what does not fit is never called too small to see", () => {
  expect(
    verdict(
      status({
        facts: Float64Array.of(0, 0, 6),
        verdict: "Does not fit. The largest distance is 2.00 cells, at (0.5, 0.5).",
      }),
    ),
  ).toBe("Does not fit. The largest distance is 2.00 cells, at (0.5, 0.5).");
  expect(verdict(status({ facts: Float64Array.of(0, 0, 3), verdict: "Crumpled (measure 1.30).", measure: 1.3 }))).toBe(
    "Crumpled (measure 1.30). The moved curve lies in folds: it is 1.3 times as long as the target.",
  );
  expect(verdict(status({ verdict: null }))).toBe("Converged: the energy falls no more.");
  expect(verdict(status({ verdict: null, stop: null }))).toBe("Finished.");
});

test.each([
  ["matched", status(), "matched, at most 0.03 cells off, no cell folded"],
  [
    "matched",
    status({ mismatch: { mean: Number.NaN, max: Number.NaN } }),
    "matched, but the grid does not see the curve",
  ],
  ["solving", status(), "matching on the 65 by 65 grid"],
  ["paused", status(), "paused on the 65 by 65 grid"],
  ["following", status(), "following your hand on the 65 by 65 grid"],
  ["preparing", null, "the solver is starting"],
  ["idle", null, "not matched yet, the grid is undeformed"],
] as const)("the result's name ends by the state: %s", (phase, told, text) => {
  expect(resultState({ phase, status: told, stale: false })).toBe(text);
});

test("every view has a caption of whole sentences that names what is seen", () => {
  for (const view of VIEWS) {
    const caption = captions[view];
    expect(en.views[view]).toMatch(/^[A-Z]/);
    expect(caption).toMatch(/^[A-Z].*\.$/);
    expect(caption.length).toBeGreaterThan(80);
  }
});
