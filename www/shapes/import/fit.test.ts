import { expect, test } from "vitest";
import { bounds, type Loop, perimeter, type Shape, signedArea } from "../geometry";
import { PRESETS } from "../presets";
import { divided, thinned } from "../thin";
import { CELL, MOST_POINTS, prepared, rounded, simplified } from "./fit";
import { united } from "./region";

const FIT = { parts: "all", holes: "keep", placement: "fit", smoothing: 0 } as const;

function polar(radius: (t: number) => number, count: number, x = 0, y = 0): Loop {
  return Float64Array.from(
    Array.from({ length: count }, (_, i) => (2 * Math.PI * i) / count).flatMap((t) => [
      x + radius(t) * Math.cos(t),
      y + radius(t) * Math.sin(t),
    ]),
  );
}

/** The greatest distance of a point of `loop` from the polygon `other`. */
function furthest(loop: Loop, other: Loop): number {
  let worst = 0;
  for (let k = 0; k < loop.length; k += 2) {
    let least = Infinity;
    for (let i = 0, j = other.length - 2; i < other.length; j = i, i += 2) {
      const [u, v] = [other[i] - other[j], other[i + 1] - other[j + 1]];
      const [x, y] = [loop[k] - other[j], loop[k + 1] - other[j + 1]];
      const t = Math.min(1, Math.max(0, (x * u + y * v) / (u * u + v * v)));
      least = Math.min(least, Math.hypot(x - t * u, y - t * v));
    }
    worst = Math.max(worst, least);
  }
  return worst;
}

test("any size and place comes to the middle of the box, with a margin", () => {
  for (const scale of [1e-6, 1, 1e6]) {
    const loop = polar((t) => scale * (1 + 0.3 * Math.cos(3 * t)), 300, 7 * scale, -3 * scale);
    const box = bounds(prepared([loop], FIT).shape);
    expect(Math.min(box?.left ?? 0, box?.bottom ?? 0)).toBeGreaterThanOrEqual(0.17);
    expect(Math.max(box?.right ?? 1, box?.top ?? 1)).toBeLessThanOrEqual(0.83);
    expect((box?.left ?? 0) + (box?.right ?? 0)).toBeCloseTo(1, 9);
  }
});

test("a thousand points become at most six hundred, nowhere further off than the tolerance, with even edges", () => {
  for (const count of [5, 40, 1000, 5000]) {
    const loop = polar((t) => 0.25 + 0.05 * Math.cos(7 * t) + 0.01 * Math.sin(31 * t), count, 0.5, 0.5);
    const { points, tolerance } = simplified(loop);
    expect(points.length / 2).toBeLessThanOrEqual(MOST_POINTS);
    expect(furthest(loop, points)).toBeLessThanOrEqual(tolerance * (1 + 1e-9));
    expect(furthest(points, loop)).toBeLessThanOrEqual(tolerance * (1 + 1e-9));
    expect(tolerance).toBeLessThan(CELL / 10);
    // Longer edges would make the first pull on the curve resample it and round its corners.
    let longest = 0;
    for (let i = 0, j = points.length - 2; i < points.length; j = i, i += 2) {
      longest = Math.max(longest, Math.hypot(points[i] - points[j], points[i + 1] - points[j + 1]));
    }
    expect(longest).toBeLessThanOrEqual((2.5 * perimeter(points)) / (points.length / 2));
  }
});

test("corners stay to the bit", () => {
  const square = divided(Float64Array.of(0.2, 0.2, 0.8, 0.2, 0.8, 0.8, 0.2, 0.8), 0.001);
  expect([...thinned(square, 1e-9).points]).toEqual([0.2, 0.2, 0.8, 0.2, 0.8, 0.8, 0.2, 0.8]);
});

test("shapes that lie in the box already can stay where they are", () => {
  for (const { reference } of PRESETS) {
    const { shape } = prepared(reference, { ...FIT, placement: "asIs" });
    shape.forEach((loop, l) => {
      expect(furthest(reference[l], loop)).toBeLessThan(0.1 * CELL);
      expect(furthest(loop, reference[l])).toBeLessThan(0.1 * CELL);
    });
  }
});

test("specks are left out, said to be, and do not make the rest small", () => {
  const body = polar(() => 1, 100);
  const speck = polar(() => 1e-3, 10, 5, 0);
  const { shape, notes } = prepared([body, speck], FIT);
  expect(shape).toHaveLength(1);
  expect(notes.join()).toContain("1 speck smaller than a cell is left out.");
  const box = bounds(shape);
  expect((box?.right ?? 0) - (box?.left ?? 0)).toBeCloseTo(0.6, 6);
});

test("nothing but specks is refused", () => {
  const speck: Shape = [polar(() => 1e-4, 10, 0.5, 0.5)];
  expect(() => prepared(speck, { ...FIT, placement: "asIs" })).toThrow(/larger than a cell/);
});

test("smoothing damps a ripple as a Gaussian does, and leaves the middle radius", () => {
  const radius = 0.25;
  const waves = 60;
  const wavelength = (2 * Math.PI * radius) / waves;
  const loop = polar((t) => radius + 0.001 * Math.cos(waves * t), 4000, 0.5, 0.5);
  for (const width of [CELL / 2, CELL]) {
    const smooth = rounded(loop, width);
    let [least, most] = [Infinity, 0];
    for (let i = 0; i < smooth.length; i += 2) {
      const r = Math.hypot(smooth[i] - 0.5, smooth[i + 1] - 0.5);
      least = Math.min(least, r);
      most = Math.max(most, r);
    }
    // A Gaussian of width w damps a wave of length λ by exp(−2 π² w² / λ²).
    const damped = 0.001 * Math.exp(-2 * (Math.PI * (width / wavelength)) ** 2);
    expect((most - least) / 2 / damped).toBeGreaterThan(0.85);
    expect((most - least) / 2 / damped).toBeLessThan(1.15);
    expect(Math.abs((most + least) / 2 - radius)).toBeLessThan(CELL / 20);
  }
});

test("a neck thinner than the smoothing leaves loops that do not cross", () => {
  const dumbbell = polar((t) => 0.02 + 0.25 * Math.cos(t) ** 2, 400, 0.5, 0.5);
  const { shape } = prepared([dumbbell], { ...FIT, smoothing: 4 });
  for (const loop of shape) expect(Math.abs(signedArea(loop))).toBeGreaterThan(CELL * CELL);
  const again = united([{ loops: shape, rule: "evenodd" }]);
  const area = (loops: Shape) => loops.reduce((sum, loop) => sum + signedArea(loop), 0);
  expect(area(again)).toBeCloseTo(area(shape), 5);
});

test("a comb with more corners than a loop may have comes to an end, with as many as it may", () => {
  const teeth = 220;
  const comb = [0, 0];
  for (let tooth = 0; tooth < teeth; tooth += 1) {
    comb.push(tooth + 0.5, 0, tooth + 0.5, 40, tooth + 1, 40, tooth + 1, 0);
  }
  comb.push(teeth, -1e-3, 0, -1e-3);
  const { shape, notes } = prepared([Float64Array.from(comb)], FIT);
  expect(shape).toHaveLength(1);
  expect(shape[0].length / 2).toBeLessThanOrEqual(MOST_POINTS);
  expect(notes.join(" ")).toContain("cells are smoothed away");
});

test("of hundreds of loops the largest are taken, their holes filled or not", () => {
  const many = Array.from({ length: 900 }, (_, i) => polar(() => 0.3 + (i % 7) / 50, 8, i % 30, Math.floor(i / 30)));
  for (const holes of ["keep", "fill"] as const) {
    const { shape, notes } = prepared(many, { ...FIT, holes, parts: "all" });
    expect(shape).toHaveLength(60);
    expect(notes.join(" ")).toContain("Of 900 loops the 60 largest are taken.");
  }
});
