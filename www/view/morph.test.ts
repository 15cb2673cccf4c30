import { readFileSync } from "node:fs";
import { beforeAll, expect, test } from "vitest";
import { PRESETS } from "../shapes/presets";
import { initSync, Registration } from "../wasm/thinshell.js";
import { signedDistance } from "./along";
import { foldOf } from "./fold";
import { identity } from "./identity";
import { movedAt, movedGrid, movedLoops, wayOf } from "./morph";
import type { Match } from "./result";

beforeAll(() => {
  initSync({ module: readFileSync("www/wasm/thinshell_bg.wasm") });
});

const ELLIPSE = Float64Array.from({ length: 120 }, (_, k) => {
  const t = (Math.PI * (k >> 1)) / 30;
  return k % 2 === 0 ? 0.4 + 0.3 * Math.cos(t) : 0.5 + 0.1 * Math.sin(t);
});

/** x ↦ b + scale R(angle)(x − a), as a match of the ellipse on level 3. */
function similarity(angle: number, scale: number, shift: number): Match {
  const image = (points: Float64Array) => {
    const out = new Float64Array(points.length);
    for (let i = 0; i < points.length; i += 2) {
      const [x, y] = [points[i] - 0.5, points[i + 1] - 0.5];
      out[i] = 0.5 + shift + scale * (Math.cos(angle) * x - Math.sin(angle) * y);
      out[i + 1] = 0.5 + scale * (Math.sin(angle) * x + Math.cos(angle) * y);
    }
    return out;
  };
  const curves = { reference: [ELLIPSE], template: [image(ELLIPSE)], matched: [image(ELLIPSE)] };
  return { level: 3, deformation: image(identity(8)), curves };
}

function area(loop: Float64Array): number {
  let twice = 0;
  for (let i = 0, j = loop.length - 2; i < loop.length; j = i, i += 2)
    twice += loop[j] * loop[i + 1] - loop[i] * loop[j + 1];
  return twice / 2;
}

/** What the loops enclose, holes taken off; which of them are holes is told by `before`. */
function enclosed(loops: readonly Float64Array[], before: readonly Float64Array[]): number {
  return loops.reduce((sum, loop, l) => {
    const others = before.filter((_, k) => k !== l);
    const isHole = signedDistance(others, before[l][0], before[l][1]) < 0;
    return sum + (isHole ? -1 : 1) * Math.abs(area(loop));
  }, 0);
}

test("the way begins at the identity and ends at the match, to the bit", () => {
  const match = similarity(2, 1.5, 0.1);
  expect(movedGrid(match, 1).deformation).toBe(match.deformation);
  expect(movedLoops(match, 1)[0]).toBe(match.curves.matched[0]);
  movedGrid(match, 0).deformation.forEach((value, k) => {
    expect(value).toBeCloseTo(identity(8)[k], 12);
  });
});

test("a similarity is met exactly: halfway it has half its angle and the root of its scale", () => {
  const way = wayOf(similarity(2, 4, 0.1));
  expect([way.angle, way.growth]).toEqual([expect.closeTo(2, 10), expect.closeTo(Math.log(4), 10)]);
  const halfway = movedLoops(similarity(2, 4, 0), 0.5)[0];
  expect(area(halfway) / area(ELLIPSE)).toBeCloseTo(4, 10);
});

test("half a turn keeps its area on the whole way, and no cell folds", () => {
  const match = similarity(3.1, 1, 0.2);
  for (const s of [0.25, 0.5, 0.75]) expect(area(movedLoops(match, s)[0]) / area(ELLIPSE)).toBeCloseTo(1, 10);
  expect(foldOf(match)).toBeNull();
});

test("without curves the way is straight", () => {
  const curves = { reference: [], template: [], matched: [] };
  const way = wayOf({ deformation: new Float64Array(0), curves });
  expect([...movedAt(way, [0.2, 0.4], Float64Array.of(0.6, 0.8), 0.25)]).toEqual([
    expect.closeTo(0.3, 12),
    expect.closeTo(0.5, 12),
  ]);
});

test("a plane that is turned over about its middle folds on the way, and the part is named", () => {
  const { deformation, curves } = similarity(0, 1, 0);
  // The curves stay, the plane around them turns by half: no similarity of the curves takes that away.
  const turned = similarity(Math.PI, 1, 0).deformation;
  expect(turned).not.toEqual(deformation);
  const [first, last] = foldOf({ level: 3, deformation: turned, curves }) ?? [Number.NaN, Number.NaN];
  expect(first).toBeLessThanOrEqual(0.5);
  expect(last).toBeGreaterThanOrEqual(0.5);
});

test.each(PRESETS.map((preset) => [preset.title, preset] as const))(
  "on its way to the match “%s” always encloses at least half of what lies between both ends",
  async (_, { reference, template }) => {
    const registration = await Registration.create(
      { kind: "curves", loops: [...reference] },
      { kind: "curves", loops: [...template] },
      { finest: 6 },
    );
    let status = await registration.step(50);
    while (!status.finished) status = await registration.step(50);
    const match = { level: status.level, deformation: registration.deformation(), curves: registration.curves() };
    registration.free();
    const before = match.curves.reference;
    const [from, to] = [enclosed(before, before), enclosed(match.curves.matched, before)];
    for (let s = 0.05; s < 1; s += 0.05) {
      expect(enclosed(movedLoops(match, s), before)).toBeGreaterThan(0.5 * ((1 - s) * from + s * to));
    }
  },
);
