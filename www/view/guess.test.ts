import { expect, test } from "vitest";
import { distance, questionOf } from "./guess";
import type { Match } from "./result";

const CIRCLE = Float64Array.from({ length: 400 }, (_, k) => {
  const t = (Math.PI * (k >> 1)) / 100;
  return 0.5 + 0.25 * (k % 2 === 0 ? Math.cos(t) : Math.sin(t));
});
const MATCH: Match = {
  level: 3,
  deformation: new Float64Array(162),
  curves: { reference: [CIRCLE], template: [CIRCLE], matched: [CIRCLE.map((value) => value + 0.1)] },
};

test("a question asks for the partner of a point", () => {
  const question = questionOf(MATCH, 0);
  if (!question) throw new Error("there is a curve to ask about");
  expect(distance(question.point, question.partner)).toBeCloseTo(Math.hypot(0.1, 0.1), 12);
});

test("ten questions are about ten places, none near another", () => {
  const points = Array.from({ length: 10 }, (_, n) => questionOf(MATCH, n)?.point ?? { x: 0, y: 0 });
  for (const [i, a] of points.entries()) {
    for (const b of points.slice(i + 1)) expect(distance(a, b)).toBeGreaterThan(0.05);
  }
});

test("without curves there is nothing to ask", () => {
  expect(questionOf({ ...MATCH, curves: { reference: [], template: [], matched: [] } }, 0)).toBeNull();
});
