import { describe, expect, test } from "vitest";
import { bounds, contains, perimeter, signedArea } from "./geometry";
import { PRESETS } from "./presets";

/** Twice the cell of a 129² grid: a narrower neck or a sharper bend is not resolved. */
const RESOLVED = 2 / 128;

test("there are at least ten, each with a name of its own", () => {
  expect(PRESETS.length).toBeGreaterThanOrEqual(10);
  expect(new Set(PRESETS.map((preset) => preset.id)).size).toBe(PRESETS.length);
  expect(new Set(PRESETS.map((preset) => preset.title)).size).toBe(PRESETS.length);
});

describe.each(
  PRESETS.flatMap((preset) => [
    { name: `${preset.id}, reference`, shape: preset.reference },
    { name: `${preset.id}, template`, shape: preset.template },
  ]),
)("$name", ({ shape }) => {
  test("keeps 0.15 from the border", () => {
    const box = bounds(shape);
    expect(Math.min(box?.left ?? 0, box?.bottom ?? 0)).toBeGreaterThanOrEqual(0.15);
    expect(Math.max(box?.right ?? 1, box?.top ?? 1)).toBeLessThanOrEqual(0.85);
  });

  test("runs counter-clockwise, holes clockwise", () => {
    shape.forEach((loop, i) => {
      const others = shape.filter((_, j) => j !== i);
      const hole = contains(others, { x: loop[0], y: loop[1] });
      expect(signedArea(loop) > 0).toBe(!hole);
    });
  });

  test("bends nowhere more sharply than a 129² grid resolves", () => {
    let sharpest = 0;
    for (const loop of shape) {
      const count = loop.length / 2;
      const step = perimeter(loop) / count;
      for (let i = 0; i < count; i += 1) {
        const [h, j] = [(i + count - 1) % count, (i + 1) % count];
        const a = Math.atan2(loop[2 * i + 1] - loop[2 * h + 1], loop[2 * i] - loop[2 * h]);
        const b = Math.atan2(loop[2 * j + 1] - loop[2 * i + 1], loop[2 * j] - loop[2 * i]);
        const turn = Math.abs(Math.atan2(Math.sin(b - a), Math.cos(b - a)));
        sharpest = Math.max(sharpest, turn / step);
      }
    }
    expect(1 / sharpest).toBeGreaterThan(RESOLVED);
  });

  test("comes nowhere closer to itself than a 129² grid resolves", () => {
    const points = shape.flatMap((loop, l) =>
      Array.from({ length: loop.length / 2 }, (_, i) => ({ l, i, x: loop[2 * i], y: loop[2 * i + 1] })),
    );
    const lengths = shape.map(perimeter);
    let gap = Infinity;
    for (const p of points) {
      for (const q of points) {
        const count = shape[p.l].length / 2;
        const apart = Math.min(Math.abs(p.i - q.i), count - Math.abs(p.i - q.i));
        const along = p.l === q.l ? (apart * lengths[p.l]) / count : Infinity;
        if (along > 4 * RESOLVED) gap = Math.min(gap, Math.hypot(p.x - q.x, p.y - q.y));
      }
    }
    expect(gap).toBeGreaterThan(2 * RESOLVED);
  });
});
