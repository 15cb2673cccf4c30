// The package that can compute on a graphics card, where there is none; with one, tests/page/card.spec.ts.

import { readFileSync } from "node:fs";
import { beforeAll, expect, test, vi } from "vitest";
import { computedBy } from "../controls/Computed";
import { PRESETS } from "../shapes/presets";
import { puppetEngine } from "../testing/puppet";
import * as first from "../wasm/thinshell.js";
import * as card from "../wasm-gpu/thinshell.js";
import { engineFor } from "./choice";

beforeAll(() => {
  first.initSync({ module: readFileSync("www/wasm/thinshell_bg.wasm") });
  card.initSync({ module: readFileSync("www/wasm-gpu/thinshell_bg.wasm") });
});

const [{ reference, template }] = PRESETS;
const SHAPES = [reference, template].map((loops): first.Shape => ({ kind: "curves", loops: [...loops] }));
const NONE = "there is no WebGPU here, which browsers reach graphics cards by";

async function matched({ Registration }: Pick<typeof first, "Registration">, settings: Partial<first.Settings>) {
  const registration = await Registration.create(SHAPES[0], SHAPES[1], { finest: 5, ...settings });
  let status = await registration.step(20);
  while (!status.finished) status = await registration.step(20);
  return { status, deformation: registration.deformation() };
}

test("who insists on a graphics card is told that there is none, and what to do", async () => {
  const create = ({ Registration }: Pick<typeof first, "Registration">) =>
    Registration.create(SHAPES[0], SHAPES[1], { backend: "gpu" });
  await expect(create(card)).rejects.toThrow(`backend is "gpu", but ${NONE}; choose "auto" or "cpu"`);
  await expect(create(first)).rejects.toThrow(/^backend is "gpu", but this build .* load the package wasm-gpu; choose/);
});

test("a refused change of the backend changes nothing", async () => {
  const registration = await card.Registration.create(SHAPES[0], SHAPES[1], { finest: 5 });
  const before = registration.deformation();
  await expect(registration.update({ settings: { backend: "gpu" } })).rejects.toThrow(NONE);
  expect(registration.settings().backend).toBe("auto");
  expect(registration.deformation()).toEqual(before);
  expect((await registration.update({ settings: { backend: "cpu" } })).backend).toBe("cpu");
});

test("without a card all packages compute the same, to the bit, and say by what", async () => {
  const [plain, auto, cpu] = [
    await matched(first, {}),
    await matched(card, {}),
    await matched(card, { backend: "cpu" }),
  ];
  expect(plain.status.backend).toBe("cpu");
  expect(auto.status.backend).toBe(`cpu: ${NONE}`);
  expect(cpu.status.backend).toBe("cpu");
  expect(auto.deformation).toEqual(plain.deformation);
  expect(cpu.deformation).toEqual(plain.deformation);
});

test.each([
  ["has no WebGPU", {}],
  ["finds no card", { gpu: { requestAdapter: async () => null } }],
  ["fails", { gpu: { requestAdapter: () => Promise.reject(new Error("lost")) } }],
  ["plays one", { gpu: { requestAdapter: async () => ({ info: { architecture: "swiftshader" } }) } }],
])("where a browser %s, the faster one is the first package's", async (_, navigator) => {
  vi.stubGlobal("navigator", navigator);
  const first = puppetEngine().engine;
  expect(await engineFor({ backend: "auto", finest: 9 }, "plane", first)).toBe(first);
  vi.unstubAllGlobals();
});

test("what computes is said in words", () => {
  expect(computedBy({ backend: "cpu" })).toBe("the processor");
  expect(computedBy({})).toBe("the processor");
  expect(computedBy({ backend: "gpu: NVIDIA H100" })).toBe("the graphics card (NVIDIA H100)");
  expect(computedBy({ backend: `cpu: ${NONE}` })).toBe(`the processor: ${NONE}`);
});
