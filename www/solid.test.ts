// The package with surfaces: the same names as the page's first one, in both dimensions.

import { readFileSync } from "node:fs";
import { beforeAll, expect, test } from "vitest";
import { initSync, inspect, Registration, type Shape } from "./wasm-solid/thinshell.js";

beforeAll(() => {
  initSync({ module: readFileSync("www/wasm-solid/thinshell_bg.wasm") });
});

const SMALL = { coarsest: 3, finest: 4 };

/** An octahedron whose triangles are cut in four `rounds` times, and drawn out to an ellipsoid. */
function ellipsoid(a: number, b: number, c: number, rounds = 4): Shape & { kind: "mesh" } {
  let triangles = [0, 1, 2, 3].flatMap((k) => {
    const angle = (i: number) => [Math.cos((i * Math.PI) / 2), Math.sin((i * Math.PI) / 2), 0];
    const [from, to] = [angle(k), angle(k + 1)];
    return [
      [from, to, [0, 0, 1]],
      [to, from, [0, 0, -1]],
    ];
  });
  const middle = (p: number[], q: number[]) => {
    const sum = p.map((x, k) => x + (q[k] ?? 0));
    const length = Math.hypot(...sum);
    return sum.map((x) => x / length);
  };
  for (let round = 0; round < rounds; round++)
    triangles = triangles.flatMap(([p = [], q = [], r = []]) => {
      const [pq, qr, rp] = [middle(p, q), middle(q, r), middle(r, p)];
      return [
        [p, pq, rp],
        [pq, q, qr],
        [rp, qr, r],
        [pq, qr, rp],
      ];
    });
  const axes = [a, b, c];
  const positions = Float64Array.from(triangles.flat(2), (x, k) => 0.5 + (axes[k % 3] ?? 0) * x);
  return { kind: "mesh", positions, indices: Uint32Array.from({ length: positions.length / 3 }, (_, k) => k) };
}

function levelSet(value: (x: number, y: number, z: number) => number, cells = 16): Shape {
  const side = cells + 1;
  const values = Float64Array.from({ length: side ** 3 }, (_, k) =>
    value((k % side) / cells, (Math.floor(k / side) % side) / cells, Math.floor(k / side ** 2) / cells),
  );
  return { kind: "levelSet", cells, dim: 3, values, redistance: true };
}

const BALL = ellipsoid(0.22, 0.22, 0.22);
const EGG = ellipsoid(0.28, 0.22, 0.19);
const CURVE: Shape = { kind: "curves", loops: [Float64Array.of(0.3, 0.3, 0.7, 0.3, 0.7, 0.7, 0.3, 0.7)] };

async function finished(registration: Registration) {
  let status = await registration.step(20);
  while (!status.finished) status = await registration.step(20);
  return status;
}

const refusal = (promise: Promise<unknown>) =>
  promise.then(
    () => "no refusal",
    (problem: Error) => problem.message,
  );

test("meshes are matched, mapped and shown", async () => {
  const registration = await Registration.create(BALL, EGG, SMALL);
  const status = await finished(registration);
  expect(status.level).toBe(4);
  expect(status.leastDeterminant).toBeGreaterThan(0.3);
  expect(status.mismatch.max).toBeLessThan(0.3);
  expect(status.cover.max).toBeLessThan(0.5);
  expect(Math.abs(status.measure - 1)).toBeLessThan(0.05);
  expect(status.stretch.mean).toBeGreaterThan(1);
  expect(status.verdict).toMatch(/^Fits: nowhere more than 0\./);

  expect(registration.deformation()).toHaveLength(3 * 17 ** 3);
  const [x = 0, y = 0, z = 0] = registration.map(Float64Array.of(0.72, 0.5, 0.5));
  expect(Math.hypot(x - 0.78, y - 0.5, z - 0.5)).toBeLessThan(0.02);
  const back = registration.inverseMap(Float64Array.of(x, y, z, 3, 3, 3));
  expect(Math.hypot((back[0] ?? 0) - 0.72, (back[1] ?? 0) - 0.5, (back[2] ?? 0) - 0.5)).toBeLessThan(1e-6);
  expect([...back.subarray(3)]).toEqual([Number.NaN, Number.NaN, Number.NaN]);

  const { reference, template, matched } = registration.surfaces();
  expect(matched.indices).toEqual(reference.indices);
  for (const { positions, normals, indices } of [reference, template, matched]) {
    expect(normals).toHaveLength(positions.length);
    expect(indices.length % 3).toBe(0);
    expect(Math.max(...indices)).toBe(positions.length / 3 - 1);
    for (let k = 0; k < positions.length; k += 3) {
      const outward = [0, 1, 2].map((i) => ((positions[k + i] ?? 0) - 0.5) * (normals[k + i] ?? 0));
      expect(outward.reduce((sum, part) => sum + part)).toBeGreaterThan(0);
    }
  }
  expect(() => registration.curves()).toThrow("this registration is of surfaces; ask for surfaces()");
  expect(() => registration.map(Float64Array.of(1, 2))).toThrow("x, y and z of every point");
  registration.free();
}, 120_000);

test("pins and updates work as for curves", async () => {
  // Turned by 60°. A right angle presses cells flat, and whether they come up again is chance.
  const [x0, y0] = [0.61, 0.5 + 0.11 * Math.sqrt(3)];
  const pins = Float64Array.of(0.72, 0.5, 0.5, x0, y0, 0.5);
  const registration = await Registration.create(BALL, BALL, { ...SMALL, align: "none", pins, pinWeight: 10 });
  const status = await finished(registration);
  expect(status.energies.pins).toBeGreaterThan(0);
  const [x = 1, y = 0] = registration.map(Float64Array.of(0.72, 0.5, 0.5));
  expect(Math.hypot(x - x0, y - y0)).toBeLessThan(0.01);
  const updated = await registration.update({ template: EGG, settings: { pinWeight: 0 } });
  expect(updated.finished).toBe(false);
  expect((await finished(registration)).mismatch.max).toBeLessThan(0.5);
  expect(await refusal(registration.update({ template: CURVE }))).toBe(
    "the template is a curve, but the other shape is a surface; both must be alike in dimension",
  );
  registration.free();
}, 120_000);

test("level sets and meshes of one shape are one shape", async () => {
  const ball = levelSet((x, y, z) => Math.hypot(x - 0.5, y - 0.5, z - 0.5) - 0.22, 32);
  const registration = await Registration.create(ball, BALL, { ...SMALL, align: "none" });
  const status = await registration.step(1);
  expect(status.mismatch.max).toBeLessThan(0.1);
  registration.free();
}, 60_000);

test("this package registers curves too", async () => {
  const registration = await Registration.create(CURVE, CURVE, { coarsest: 3, finest: 4 });
  expect((await finished(registration)).mismatch.max).toBeLessThan(0.2);
  expect(() => registration.surfaces()).toThrow("this registration is of curves; ask for curves()");
  registration.free();
});

test("what cannot be registered is refused by a sentence", async () => {
  const create = (reference: Shape, template: Shape, settings = {}) =>
    refusal(Registration.create(reference, template, settings));
  expect(await create(BALL, CURVE)).toBe(
    "the template is a curve, but the other shape is a surface; both must be alike in dimension",
  );
  expect(await create(CURVE, BALL)).toBe(
    "the template is a surface, but the other shape is a curve; both must be alike in dimension",
  );
  expect(await create(BALL, BALL, { finest: 10 })).toMatch(
    /^finest is 10, but must be at most 7 for surfaces, 129³ nodes/,
  );
  expect(await create({ ...BALL, indices: BALL.indices.slice(0, -120) }, BALL)).toMatch(/^the reference is open: /);
  expect(await create({ ...BALL, indices: Uint32Array.of(0, 1) }, BALL)).toBe(
    "the reference holds 2 numbers as its indices, but every triangle has three",
  );
  expect(await create({ ...BALL, indices: Uint32Array.of(0, 1, 1e9) }, BALL)).toMatch(/there are only \d+ vertices/);
  expect(await create({ ...BALL, positions: new Float64Array(BALL.positions.length).fill(Number.NaN) }, BALL)).toMatch(
    /coordinate that is not finite/,
  );
  expect(
    await create(
      levelSet(() => 1),
      BALL,
    ),
  ).toMatch(/^the reference has a level set without a sign change/);
  const large = { kind: "levelSet", cells: 4096, dim: 3, values: new Float64Array(8), redistance: true } as const;
  expect(await create(large, BALL)).toMatch(/a power of two from 4 to 256 is needed/);
});

test("what is usual depends on the dimension", async () => {
  const registration = await Registration.create(BALL, BALL, { align: "none" });
  expect(registration.settings().finest).toBe(5);
  registration.free();
  expect(inspect(BALL, EGG, SMALL)).toEqual({ words: null, level: null, facts: new Float64Array(6).fill(-1) });
}, 60_000);
