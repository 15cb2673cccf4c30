import { expect, test } from "vitest";
import { bounds, type Loop, reversed, type Shape, signedArea } from "../geometry";
import { outlined } from "./raster";
import { isTangled, type Region, united } from "./region";

function area(shape: Shape): number {
  return shape.reduce((sum, loop) => sum + signedArea(loop), 0);
}

function disc(x: number, y: number, radius: number, count = 400): Loop {
  return Float64Array.from({ length: 2 * count }, (_, k) => {
    const t = (2 * Math.PI * (k >> 1)) / count;
    return k % 2 === 0 ? x + radius * Math.cos(t) : y + radius * Math.sin(t);
  });
}

/** The same numbers every time. */
function random(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

function scribble(points: number, next: () => number, size = 1): Loop {
  const [x, y] = [next(), next()];
  return Float64Array.from({ length: 2 * points }, (_, k) => (k % 2 === 0 ? x : y) + size * next());
}

test("a disc on the raster is the disc, to a sample", () => {
  const [loop] = outlined([{ loops: [disc(7, -3, 2)], rule: "nonzero" }]);
  const sample = 4 / 1020;
  for (let i = 0; i < loop.length; i += 2) {
    expect(Math.abs(Math.hypot(loop[i] - 7, loop[i + 1] + 3) - 2)).toBeLessThan(sample);
  }
  expect(signedArea(loop) / (4 * Math.PI)).toBeCloseTo(1, 3);
});

test("the raster agrees with the exact union: overlaps, holes, either rule, either direction", () => {
  const regions: Region[] = [
    { loops: [disc(0, 0, 3), disc(0, 0, 1)], rule: "evenodd" },
    { loops: [reversed(disc(2, 1, 2))], rule: "nonzero" },
    { loops: [disc(-6, 0, 1), disc(-6, 0, 0.5)], rule: "nonzero" },
  ];
  const [exact, seen] = [united(regions), outlined(regions)];
  expect(seen).toHaveLength(exact.length);
  expect(area(seen) / area(exact)).toBeCloseTo(1, 3);
  expect(seen.map((loop) => Math.sign(signedArea(loop))).sort()).toEqual(
    exact.map((loop) => Math.sign(signedArea(loop))).sort(),
  );
});

test("one path that crosses itself many times is the same either way of counting", () => {
  // Few edges are counted by their crossings, many by a number for every sample.
  const once = scribble(600, random(1));
  const often = Float64Array.from({ length: 4 * once.length }, (_, k) => once[k % once.length]);
  for (const rule of ["nonzero", "evenodd"] as const) {
    const exact = area(united([{ loops: [once], rule }]));
    expect(area(outlined([{ loops: [once], rule }])) / exact).toBeCloseTo(1, 2);
  }
  const [a, b] = [outlined([{ loops: [once], rule: "nonzero" }]), outlined([{ loops: [often], rule: "nonzero" }])];
  // Four times around is not zero either.
  expect(area(b)).toBeCloseTo(area(a), 9);
}, 30_000);

test("a coast of a hundred thousand points is swept exactly, what is tangled is not", () => {
  const coast = disc(0, 0, 1, 100_000);
  expect(isTangled([{ loops: [coast], rule: "nonzero" }])).toBe(false);
  expect(isTangled([{ loops: [scribble(20_000, random(2))], rule: "nonzero" }])).toBe(true);
});

test("thousands of random paths, and one of twenty thousand points, have an outline", () => {
  const next = random(3);
  const paths = Array.from({ length: 3000 }, (): Region => ({ loops: [scribble(6, next, 0.1)], rule: "nonzero" }));
  const parts: number[] = [];
  const shape = united(paths, (done) => parts.push(done));
  expect(area(shape)).toBeGreaterThan(0.9);
  expect(parts.length).toBeGreaterThan(40);
  expect(bounds(shape)?.right).toBeLessThan(1.1);
  expect(area(united([{ loops: [scribble(20_000, next)], rule: "nonzero" }]))).toBeGreaterThan(0.9);
});
