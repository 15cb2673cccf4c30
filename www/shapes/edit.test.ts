import { describe, expect, test } from "vitest";
import { keyed, loopFromStroke, pulled, settled, withLoop } from "./edit";
import { contains, type Loop, type Point, perimeter, reversed, SAMPLES, signedArea } from "./geometry";

function arc(radius: number, from: number, to: number, count = 90, x = 0.5): Point[] {
  return Array.from({ length: count }, (_, i) => {
    const t = from + ((to - from) * i) / (count - 1);
    return { x: x + radius * Math.cos(t), y: 0.5 + radius * Math.sin(t) };
  });
}

function loop(radius: number, x = 0.5): Loop {
  const drawn = loopFromStroke(arc(radius, 0, 2 * Math.PI - 0.05, 90, x));
  if (!drawn) throw new Error("the stroke was taken for a tap");
  return drawn;
}

describe("strokes", () => {
  test("an open circle closes itself and is resampled", () => {
    const drawn = loop(0.3);
    expect(drawn).toHaveLength(2 * SAMPLES);
    expect(signedArea(drawn)).toBeCloseTo(Math.PI * 0.09, 2);
  });

  test("the tails of a stroke drawn past its start are cut off", () => {
    // It leaves outwards and comes back inwards, crossing itself at angle 0 and going on for 0.3 radians.
    const stroke = Array.from({ length: 160 }, (_, i) => {
      const t = -0.3 + ((2 * Math.PI + 0.6) * i) / 159;
      const r = 0.3 + (t < 0.3 ? 0.05 * t : t > 2 * Math.PI - 0.3 ? 0.05 * (2 * Math.PI - t) : 0.015);
      return { x: 0.5 + r * Math.cos(t), y: 0.5 + r * Math.sin(t) };
    });
    const drawn = loopFromStroke(stroke);
    expect(drawn && perimeter(drawn)).toBeLessThan(2 * Math.PI * 0.32);
    expect(drawn && signedArea(drawn)).toBeCloseTo(Math.PI * 0.313 ** 2, 2);
  });

  test("a tap draws nothing", () => {
    expect(loopFromStroke([{ x: 0.5, y: 0.5 }])).toBeNull();
    expect(loopFromStroke(arc(0.002, 0, 6))).toBeNull();
  });

  test("a straight stroke stays what it is: the solver says that it encloses no area", () => {
    const line = loopFromStroke(Array.from({ length: 30 }, (_, i) => ({ x: 0.3 + i * 0.01, y: 0.5 })));
    expect(line && Math.abs(signedArea(line))).toBeLessThan(1e-12);
  });
});

describe("further loops", () => {
  test("drawn inside, either way round, cut a hole", () => {
    const outer = withLoop([], loop(0.3));
    for (const hole of [loop(0.1), reversed(loop(0.1))]) {
      const ring = withLoop(outer, hole);
      expect(contains(ring, { x: 0.5, y: 0.5 })).toBe(false);
      expect(contains(ring, { x: 0.7, y: 0.5 })).toBe(true);
    }
  });

  test("drawn outside add a part, drawn across make one shape of both", () => {
    const outer = withLoop([], loop(0.15, 0.35));
    expect(contains(withLoop(outer, loop(0.1, 0.75)), { x: 0.75, y: 0.5 })).toBe(true);
    const joined = withLoop(outer, loop(0.15, 0.55));
    expect(contains(joined, { x: 0.45, y: 0.5 })).toBe(true);
    expect(contains(joined, { x: 0.65, y: 0.5 })).toBe(true);
  });

  test("drawn into a hole are an island", () => {
    const ring = withLoop(withLoop([], loop(0.3)), loop(0.2));
    expect(contains(withLoop(ring, loop(0.1)), { x: 0.5, y: 0.5 })).toBe(true);
  });
});

describe("pulling", () => {
  const before = [loop(0.3), loop(0.1)];
  const after = pulled(before, { loop: 0, vertex: 3, distance: 0 }, 0.05, 0.02);

  test("moves the gripped point with the hand", () => {
    expect(after[0][6]).toBeCloseTo(before[0][6] + 0.05, 14);
    expect(after[0][7]).toBeCloseTo(before[0][7] + 0.02, 14);
  });

  test("moves neighbours less and less, on both sides alike, and nothing far away", () => {
    const moved = (vertex: number) => after[0][2 * vertex] - before[0][2 * vertex];
    expect(moved(7)).toBeLessThan(moved(5));
    expect(moved(7)).toBeGreaterThan(0);
    expect(moved(3 + 4)).toBeCloseTo(moved(SAMPLES + 3 - 4), 3);
    expect(moved(103)).toBe(0);
  });

  test("leaves other loops alone", () => {
    expect(after[1]).toBe(before[1]);
  });

  test("stretched loops are spaced out again, others returned as they are", () => {
    const torn = pulled(before, { loop: 0, vertex: 3, distance: 0 }, 0.6, 0);
    expect(settled(torn)[0]).not.toBe(torn[0]);
    expect(settled(before)[0]).toBe(before[0]);
  });
});

describe("keys", () => {
  const shape = [loop(0.3)];

  test("arrows move, plus and minus undo each other, brackets turn back and forth", () => {
    expect(keyed(shape, "ArrowUp", false)?.[0][1]).toBeCloseTo(shape[0][1] + 0.01, 14);
    expect(keyed(shape, "ArrowLeft", true)?.[0][0]).toBeCloseTo(shape[0][0] - 0.002, 14);
    for (const [there, back] of ["+-", "[]"]) {
      const moved = keyed(shape, there, false);
      expect(moved?.[0][0]).not.toBeCloseTo(shape[0][0], 6);
      expect(moved && keyed(moved, back, false)?.[0][0]).toBeCloseTo(shape[0][0], 12);
    }
  });

  test("Delete clears, other keys do nothing", () => {
    expect(keyed(shape, "Delete", false)).toEqual([]);
    expect(keyed(shape, "a", false)).toBeNull();
    expect(keyed(shape, "Tab", false)).toBeNull();
  });
});
