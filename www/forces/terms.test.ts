import { readFileSync } from "node:fs";
import { beforeAll, expect, test } from "vitest";
import type { Shape } from "../protocol";
import { PRESETS } from "../shapes/presets";
import { initSync, Registration } from "../wasm/thinshell.js";
import { FORCES, forcesOf, gathered, onLevel } from "./terms";

beforeAll(() => {
  initSync({ module: readFileSync("www/wasm/thinshell_bg.wasm") });
});

const [, star] = PRESETS;
const curves = (loops: readonly Float64Array[]): Shape => ({ kind: "curves", loops: [...loops] });
const SETTINGS = { finest: 6, align: "none", bending: 0.5 } as const;

async function matched() {
  const registration = await Registration.create(curves(star.reference), curves(star.template), SETTINGS);
  let status = await registration.step(5);
  while (status.level < 6) status = await registration.step(1);
  const deformation = registration.deformation();
  registration.free();
  return { status, deformation };
}

function size(force: Float64Array): number {
  return Math.hypot(...force);
}

test("the terms' forces add up to that of the whole energy", { timeout: 60_000 }, async () => {
  const { status, deformation } = await matched();
  const job = { reference: curves(star.reference), template: curves(star.template), settings: SETTINGS };
  const forces = await forcesOf(Registration, { ...job, level: status.level, deformation });
  const whole = await Registration.create(job.reference, job.template, onLevel(SETTINGS, status.level));
  const total = gathered(whole.evaluate(deformation).gradient, status.level);
  whole.free();
  const sum = total.map((_, k) => FORCES.reduce((all, term) => all + forces[term][k], 0));
  const largest = Math.max(...FORCES.map((term) => size(forces[term])));
  expect(largest).toBeGreaterThan(0);
  expect(size(sum.map((value, k) => value - total[k])) / largest).toBeLessThan(1e-5);
});

test("what is gathered is all that there was, the other way round", () => {
  const gradient = Float64Array.from({ length: 2 * 129 * 129 }, (_, k) => Math.sin(k));
  const force = gathered(gradient, 7);
  expect(force.length).toBe(2 * 33 * 33);
  for (const axis of [0, 1]) {
    const sum = (values: Float64Array) => values.reduce((all, value, k) => all + (k % 2 === axis ? value : 0), 0);
    expect(sum(force)).toBeCloseTo(-sum(gradient), 9);
  }
});

test("δ and ε are as often halved as there are levels to the match's, unless they are kept", () => {
  expect(onLevel({ thickness: 0.5, penalty: 1000 }, 6)).toMatchObject({ thickness: 0.125, penalty: 4000, finest: 6 });
  expect(onLevel({ thickness: 0.5, penalty: 1000, halving: false }, 6)).toMatchObject({
    thickness: 0.5,
    penalty: 1000,
  });
});
