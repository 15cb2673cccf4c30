import { readFileSync } from "node:fs";
import { beforeAll, expect, test } from "vitest";
import { PRESETS } from "../shapes/presets";
import { initSync, Registration } from "../wasm/thinshell.js";
import { atNodes, bendingAt, stretchingAt, VOLUME_AT_REST, volumeDensities } from "./density";
import { identity } from "./identity";

beforeAll(() => {
  initSync({ module: readFileSync("www/wasm/thinshell_bg.wasm") });
});

test("nothing deformed costs nothing, and every stretch something", () => {
  expect(stretchingAt(1)).toBeCloseTo(0, 14);
  for (const stretch of [0.3, 0.9, 1.1, 3]) expect(stretchingAt(stretch)).toBeGreaterThan(0);
  for (const density of volumeDensities({ cells: 8, deformation: identity(8) })) expect(density).toBeCloseTo(0, 12);
});

test("stretching costs without bound on the way to a point", () => {
  expect(stretchingAt(1e-4)).toBeGreaterThan(1e6);
});

test("a circle doubled onto a circle of half the curvature is bent by what the pulled back curvature tells", () => {
  expect(bendingAt(2, 5, 2.5)).toBe(25);
  expect(bendingAt(1, 5, 5)).toBe(0);
});

test("the density over the plane adds up to the solver's volume energy", async () => {
  const [, { reference, template }] = PRESETS;
  const volume = 0.02;
  const registration = await Registration.create(
    { kind: "curves", loops: [...reference] },
    { kind: "curves", loops: [...template] },
    { finest: 6, volume, vertexShare: 0 },
  );
  let status = await registration.step(50);
  while (!status.finished) status = await registration.step(50);
  const map = { cells: 2 ** status.level, deformation: registration.deformation() };
  registration.free();
  const mean = volumeDensities(map).reduce((sum, density) => sum + density, 0) / map.cells ** 2;
  // The middle of a cell for the solver's quadrature of it.
  expect(volume * (mean + VOLUME_AT_REST)).toBeCloseTo(status.energies.volume, 4);
});

test("a constant stays a constant at the nodes", () => {
  expect([...atNodes(new Float64Array(16).fill(3), 4)]).toEqual(new Array(25).fill(3));
});
