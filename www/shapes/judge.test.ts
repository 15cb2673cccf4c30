import { describe, expect, test } from "vitest";
import { bounds, type Point, signedArea } from "./geometry";
import { judged, judgedLoop, withoutKnots } from "./judge";

const LIMITS = { cell: 1 / 128 };

function along(curve: (t: number) => Point, count = 80): Point[] {
  return Array.from({ length: count }, (_, i) => curve((2 * Math.PI * i) / count));
}

function circle(radius: number, x = 0.5, y = 0.5): Point[] {
  return along((t) => ({ x: x + radius * Math.cos(t), y: y + radius * Math.sin(t) }));
}

const EIGHT = along((t) => ({ x: 0.5 + 0.3 * Math.sin(t), y: 0.5 + 0.2 * Math.sin(2 * t) }));

test("a fair stroke is the loop that it draws", () => {
  const judgement = judged(circle(0.2), LIMITS);
  expect(judgement.kind).toBe("loop");
  if (judgement.kind !== "loop") return;
  expect(Math.abs(signedArea(judgement.loop))).toBeCloseTo(Math.PI * 0.04, 2);
});

test("a tap is a tap", () => {
  expect(judged([{ x: 0.5, y: 0.5 }], LIMITS).kind).toBe("tap");
  expect(judged(circle(0.001), LIMITS).kind).toBe("tap");
});

describe("a stroke that crosses itself", () => {
  test("is said to, and the larger of its parts can be kept", () => {
    const judgement = judged(EIGHT, LIMITS);
    expect(judgement.kind).toBe("crossing");
    if (judgement.kind !== "crossing" || !judgement.mended) throw new Error("there is a way out");
    expect(judgedLoop(judgement.mended, LIMITS).kind).toBe("loop");
    const box = bounds([judgement.mended]);
    expect((box?.right ?? 0) - (box?.left ?? 0)).toBeCloseTo(0.3, 1);
  });

  test("only in a knot as small as a tremor loses the knot without a word", () => {
    const knotted = circle(0.2);
    const { x, y } = knotted[20];
    knotted.splice(
      20,
      0,
      ...along((t) => ({ x: x + 0.006 * Math.sin(t), y: y + 0.006 * (1 - Math.cos(t)) }), 12).reverse(),
    );
    const judgement = judged(knotted, LIMITS, 0);
    expect(judgement.kind).toBe("loop");
  });

  test("has no crossing left once all knots are cut", () => {
    const rose = along(
      (t) => ({ x: 0.5 + 0.3 * Math.cos(2 * t) * Math.cos(t), y: 0.5 + 0.3 * Math.cos(2 * t) * Math.sin(t) }),
      200,
    );
    const loop = withoutKnots(Float64Array.from(rose.flatMap(({ x, y }) => [x, y])), 1);
    expect(judgedLoop(loop, LIMITS).kind).not.toBe("crossing");
  });
});

test("a line there and back encloses nothing, and nothing can be made of it", () => {
  const line = [...Array(30).keys()].map((i) => ({ x: 0.2 + i / 50, y: 0.5 }));
  expect(judged([...line, ...line.toReversed()], LIMITS)).toMatchObject({ kind: "flat", mended: null });
  expect(judged(line, LIMITS)).toMatchObject({ kind: "flat", mended: null });
});

test("a curve of a few cells is too small, and can be enlarged where it is", () => {
  const judgement = judged(circle(0.012, 0.03, 0.7), LIMITS);
  expect(judgement.kind).toBe("small");
  if (judgement.kind !== "small" || !judgement.mended) throw new Error("there is a way out");
  expect(judgement.size).toBeLessThan(4);
  expect(judgedLoop(judgement.mended, LIMITS).kind).toBe("loop");
  expect(bounds([judgement.mended])?.top).toBeCloseTo(0.74, 1);
});

test.each([
  ["a curve over the left border", circle(0.2, 0.1, 0.5)],
  ["a curve over a corner", circle(0.2, 0.95, 1)],
  ["a curve larger than the box", circle(0.7)],
])("%s can be moved inside", (_, stroke) => {
  const judgement = judged(stroke, LIMITS);
  expect(judgement.kind).toBe("border");
  if (judgement.kind !== "border" || !judgement.mended) throw new Error("there is a way out");
  expect(judgedLoop(judgement.mended, LIMITS).kind).toBe("loop");
});

test("a coarser grid asks for more room", () => {
  expect(judged(circle(0.46), { cell: 1 / 128 }).kind).toBe("loop");
  expect(judged(circle(0.46), { cell: 1 / 32 }).kind).toBe("border");
});
