// The package as others use it: whatever is given or called, there is an answer or a sentence.

import { readFileSync } from "node:fs";
import { beforeAll, expect, test } from "vitest";
import { initSync, Registration, type Shape } from "./wasm/thinshell.js";

beforeAll(() => {
  initSync({ module: readFileSync("www/wasm/thinshell_bg.wasm") });
});

const SMALL = { coarsest: 3, finest: 4 };
const CIRCLE = curve(0.2, 0.2);
const ELLIPSE = curve(0.25, 0.18);

function curve(a: number, b: number): Shape {
  const loop = Float64Array.from({ length: 200 }, (_, k) => {
    const angle = (2 * Math.PI * (k >> 1)) / 100;
    return 0.5 + (k % 2 === 0 ? a * Math.cos(angle) : b * Math.sin(angle));
  });
  return { kind: "curves", loops: [loop] };
}

/** What has no such type, as from JavaScript. */
const untyped = <T>(value: unknown) => value as T;

async function finished(registration: Registration) {
  let status = await registration.step(20);
  while (!status.finished) status = await registration.step(20);
  return status;
}

const radial = (x: number, y: number, a: number, b: number) => 0.2 * (Math.hypot((x - 0.5) / a, (y - 0.5) / b) - 1);

function levelSet(a: number, b: number, scale: number): Shape {
  const values = Float64Array.from(
    { length: 65 * 65 },
    (_, k) => scale * radial((k % 65) / 64, Math.floor(k / 65) / 64, a, b),
  );
  return { kind: "levelSet", cells: 64, dim: 2, values, redistance: true };
}

function mask(a: number, b: number): Shape {
  const data = Uint8Array.from({ length: 400 * 400 }, (_, k) =>
    radial(((k % 400) + 0.5) / 400, (Math.floor(k / 400) + 0.5) / 400, a, b) < 0 ? 255 : 0,
  );
  return { kind: "mask", width: 400, height: 400, data };
}

test("level sets and masks are matched as their curves are", async () => {
  const settings = { finest: 5 };
  const expected = await Registration.create(CIRCLE, ELLIPSE, settings);
  await finished(expected);
  const points = Float64Array.of(0.7, 0.5, 0.5, 0.7, 0.4, 0.4);
  const pairs: [Shape, Shape][] = [
    [levelSet(0.2, 0.2, 1), levelSet(0.25, 0.18, 1)],
    [levelSet(0.2, 0.2, 1e160), levelSet(0.25, 0.18, 1e-200)],
    [mask(0.2, 0.2), mask(0.25, 0.18)],
  ];
  for (const [reference, template] of pairs) {
    const registration = await Registration.create(reference, template, settings);
    expect((await finished(registration)).mismatch.max).toBeLessThan(0.1);
    registration.map(points).forEach((value, k) => {
      expect(Math.abs(value - (expected.map(points)[k] ?? Number.NaN))).toBeLessThan(0.2 / 32);
    });
  }
}, 60_000);

test("a level set that is no distance is refused where it is to be used as it is", async () => {
  for (const scale of [1e160, 1e-160, 30, 0.01]) {
    const shape = { ...levelSet(0.2, 0.2, scale), redistance: false };
    await expect(Registration.create(shape, CIRCLE, SMALL)).rejects.toThrow(
      /^the reference has a level set that is no distance.*redistance/,
    );
  }
});

test("the inverse undoes the map, and is NaN outside of the image", async () => {
  const registration = await Registration.create(CIRCLE, ELLIPSE, SMALL);
  await finished(registration);
  const points = Float64Array.from({ length: 400 }, (_, k) => ((k * 37) % 101) / 101);
  registration.inverseMap(registration.map(points)).forEach((value, k) => {
    expect(value).toBeCloseTo(points[k] ?? Number.NaN, 8);
  });
  expect([...registration.inverseMap(Float64Array.of(5, 5, 0.5, -9))]).toEqual([
    Number.NaN,
    Number.NaN,
    Number.NaN,
    Number.NaN,
  ]);
});

test("while a step is under way a second one waits, and questions are refused by a sentence", async () => {
  const registration = await Registration.create(CIRCLE, ELLIPSE, SMALL);
  const steps = [
    registration.step(1),
    registration.step(1),
    registration.update({ template: CIRCLE }),
    registration.step(1),
  ];
  for (const ask of [
    () => registration.deformation(),
    () => registration.curves(),
    () => registration.map(Float64Array.of(0.5, 0.5)),
    () => registration.inverseMap(Float64Array.of(0.5, 0.5)),
    () => registration.evaluate(new Float64Array(162)),
  ])
    expect(ask).toThrow(/^a step or an update is under way; await its promise/);
  const [first, second, updated] = await Promise.all(steps);
  expect([first?.iteration, second?.iteration, updated?.iteration]).toEqual([1, 2, 0]);
  expect(registration.deformation()).toHaveLength(2 * 81);
});

test("after free every method says so, and a step that has begun still answers", async () => {
  const registration = await Registration.create(CIRCLE, ELLIPSE, SMALL);
  const [under, queued] = [registration.step(1), registration.step(1)];
  // What is called begins with the next turn.
  await Promise.resolve();
  registration.free();
  registration.free();
  await expect(under).resolves.toMatchObject({ iteration: 1 });
  const freed = /^this registration has been freed; create a new one$/;
  await expect(queued).rejects.toThrow(freed);
  await expect(registration.step(1)).rejects.toThrow(freed);
  await expect(registration.update({})).rejects.toThrow(freed);
  for (const ask of [
    () => registration.deformation(),
    () => registration.curves(),
    () => registration.map(new Float64Array(2)),
  ])
    expect(ask).toThrow(freed);
});

test("nonsense to step and map is refused by a sentence, and the registration goes on", async () => {
  const registration = await Registration.create(CIRCLE, ELLIPSE, SMALL);
  for (const iterations of [0, -1, 1.5, Number.NaN, Infinity, untyped<number>("5"), untyped<number>(undefined)])
    await expect(registration.step(iterations)).rejects.toThrow(
      /^the number of steps is .*, but must be a whole number from 1 up/,
    );
  for (const ask of [registration.map, registration.inverseMap].map((method) => method.bind(registration))) {
    expect(() => ask(Float64Array.of(1, 2, 3))).toThrow(/^points holds 3 numbers, but 4 are needed/);
    expect(() => ask(Float64Array.of(1, Number.NaN))).toThrow(/^points has a value that is not finite at position 1/);
    expect(() => ask(untyped<Float64Array>([1, 2]))).toThrow(/^points is an array, but must be a Float64Array$/);
  }
  expect((await registration.step(1)).iteration).toBe(1);
});

test("getters that throw, proxies and transferred arrays reject, and the registration goes on", async () => {
  const trap = () => {
    throw new TypeError("a trap");
  };
  const getter = {
    kind: "curves",
    get loops(): Float64Array[] {
      return trap();
    },
  };
  const { proxy: revoked, revoke } = Proxy.revocable([], {});
  revoke();
  const transferred = Float64Array.of(0.4, 0.4, 0.6, 0.4, 0.5, 0.6);
  structuredClone(transferred.buffer, { transfer: [transferred.buffer] });
  const curves = (loops: unknown) => ({ kind: "curves", loops });
  const poison: [unknown, RegExp][] = [
    [getter, /^the template's loops cannot be read/],
    [new Proxy({}, { get: trap }), /^the template's kind cannot be read/],
    [curves(revoked), /^the template's loops cannot be read: it throws/],
    [curves(new Proxy([], { get: trap })), /^the template's loops cannot be read: it throws "a trap"/],
    [
      curves([new Proxy(new Float64Array(6), {})]),
      /^the template's loops\[0\] is an object, but must be a Float64Array/,
    ],
    [curves([transferred]), /^the template's loops\[0\] cannot be read: it throws .*detached/],
    [{ kind: "x".repeat(1e6) }, /^the template has the unknown kind "x{60}…"/],
    [null, /^the template is null, but must be an object/],
  ];
  const registration = await Registration.create(CIRCLE, ELLIPSE, SMALL);
  for (const [shape, message] of poison) {
    await expect(Registration.create(CIRCLE, untyped<Shape>(shape), SMALL)).rejects.toThrow(message);
    await expect(registration.update({ template: untyped<Shape>(shape) })).rejects.toThrow(message);
  }
  const settings = new Proxy({}, { ownKeys: trap });
  await expect(Registration.create(CIRCLE, ELLIPSE, settings)).rejects.toThrow(/^settings cannot be read/);
  await expect(registration.update(untyped(null))).rejects.toThrow(/^the change is null, but must be an object/);
  expect((await finished(registration)).finished).toBe(true);
});

test("what will not fit into the memory is refused before it dies", async () => {
  const most = { coarsest: 10, finest: 10, bandwidth: 1 };
  await expect(Registration.create(CIRCLE, ELLIPSE, most)).rejects.toThrow(
    /^finest = 10 .* needs up to 2.9 GB of memory/,
  );
  expect((await Registration.create(CIRCLE, ELLIPSE, SMALL)).deformation()).toHaveLength(162);
});
