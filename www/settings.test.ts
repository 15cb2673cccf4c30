/** The settings as the solver takes them and as the page shows them: one declaration, so they cannot disagree. */

import { readFileSync } from "node:fs";
import { describe, expect, test } from "vitest";
import { settingsDocument } from "../scripts/lib/settings.mjs";
import { bandwidth, coarsestLevel, complete, FIELDS, finestLevel, parseSetting } from "./settings";
import { CLEARANCE } from "./shapes/geometry";
import { SETTINGS, type Setting } from "./wasm/settings.js";
import { describeSettings, initSync, Registration, type Settings, type Shape } from "./wasm/thinshell.js";

initSync({ module: readFileSync(new URL("./wasm/thinshell_bg.wasm", import.meta.url)) });

const SQUARE: Shape = { kind: "curves", loops: [Float64Array.of(0.3, 0.3, 0.7, 0.3, 0.7, 0.7, 0.3, 0.7)] };
const WIDE: Shape = { kind: "curves", loops: [Float64Array.of(0.25, 0.3, 0.75, 0.3, 0.75, 0.7, 0.25, 0.7)] };
const SMALL = { coarsest: 3, finest: 4 } as const;

async function settingsOf(given: object): Promise<Settings> {
  const registration = await Registration.create(SQUARE, SQUARE, given as Partial<Settings>);
  const settings = registration.settings();
  registration.free();
  return settings;
}

async function refusal(given: unknown): Promise<string> {
  try {
    await settingsOf(given as object);
  } catch (problem) {
    if (problem instanceof Error) return problem.message;
  }
  throw new Error("this was not refused by an Error");
}

/** What another package computes on: card/card.test.ts asks both for it. */
const ELSEWHERE = "gpu";

/** Values that a setting can have, its default not among them where there is another. */
function values(setting: Setting): (number | string | boolean)[] {
  switch (setting.kind) {
    case "number":
      return [setting.least, setting.most, ...setting.usual].filter((value) => value !== setting.initial);
    case "level":
      return setting.name === "finest" ? [5, 6] : [3];
    case "choice":
      return setting.options.map(({ value }) => value).filter((value) => value !== ELSEWHERE);
    case "pins":
      return [];
  }
}

describe("the declarations", () => {
  test("are those that the package carries as data", () => {
    expect(describeSettings()).toEqual(SETTINGS);
  });

  test("hold the solver's defaults", async () => {
    const declared = SETTINGS.map((setting) => [
      setting.name,
      setting.kind === "pins" ? expect.anything() : setting.initial,
    ]);
    expect(await settingsOf({})).toEqual(Object.fromEntries(declared));
  });

  test("are what docs/settings.md says; `npm run settings` writes it", () => {
    expect(readFileSync(new URL("../docs/settings.md", import.meta.url), "utf8")).toBe(settingsDocument(SETTINGS));
  });
});

describe("the page", () => {
  test("has the solver's defaults", async () => {
    const solver = await settingsOf({});
    for (const { name, initial } of FIELDS) expect([name, initial]).toEqual([name, solver[name]]);
    expect(finestLevel({})).toBe(solver.finest);
    expect(coarsestLevel({})).toBe(solver.coarsest);
    expect(await settingsOf(complete({}))).toEqual(solver);
  });

  test.each([4, 5, 7])(
    "sees the band as wide as the solver does where none is chosen, finest level %i",
    async (finest) => {
      const energies = async (width: number) => {
        const settings = { ...SMALL, finest, bandwidth: width };
        const registration = await Registration.create(SQUARE, WIDE, settings);
        const { energies } = registration.evaluate(registration.deformation());
        registration.free();
        return energies;
      };
      expect(await energies(0)).toEqual(await energies(bandwidth({ finest })));
      expect(await energies(0)).not.toEqual(await energies(1.01 * bandwidth({ finest })));
    },
  );

  test("keeps shapes as far from the border as the solver does", async () => {
    const create = (cells: number) => {
      const [low, high] = [cells / 16, 0.7];
      const loops = [Float64Array.of(low, 0.3, high, 0.3, high, 0.7, low, 0.7)];
      return Registration.create({ kind: "curves", loops }, SQUARE, SMALL);
    };
    (await create(CLEARANCE)).free();
    await expect(create(CLEARANCE - 0.01)).rejects.toThrow("border");
  });

  test.each(FIELDS)("offers of $name only what the solver takes", async (field) => {
    const offered = field.kind === "number" ? [field.least, field.most] : field.options.map(({ value }) => value);
    // Fine grids take their time; what a level can be is asked of the declaration.
    const declared = SETTINGS.find(({ name }) => name === field.name);
    for (const value of offered.filter((value) => value !== ELSEWHERE)) {
      if (declared?.kind === "level") {
        expect(value).toBeGreaterThanOrEqual(declared.least);
        expect(value).toBeLessThanOrEqual(declared.most);
      } else expect((await settingsOf({ ...SMALL, [field.name]: value }))[field.name]).toBe(value);
    }
  });

  test("repeats no more of a long input than a line holds", () => {
    for (const field of FIELDS) expect(() => parseSetting(field, "9x".repeat(1e5))).toThrow(/^.{0,300}$/);
  });
});

describe("the solver", () => {
  test.each(SETTINGS.filter(({ kind }) => kind !== "pins"))("gives back $name as it was given", async (setting) => {
    const given = setting.name === "mu" ? { lambda: 1e6 } : setting.name === "lambda" ? { mu: 1e-6 } : {};
    for (const value of values(setting)) {
      // The smallest Lamé coefficient that goes with the other's smallest.
      const allowed =
        setting.name === "lambda" && value === 0 ? 2e-6 : setting.name === "mu" && value === 1e6 ? 5e5 : value;
      const settings: Settings = await settingsOf({ ...SMALL, ...given, [setting.name]: allowed });
      expect(settings[setting.name]).toBe(allowed);
    }
  });

  test("keeps what an update does not name, and everything when it refuses", async () => {
    const registration = await Registration.create(SQUARE, SQUARE, { ...SMALL, bending: 0.5 });
    await registration.update({ settings: { penalty: 500, membrane: undefined } });
    const before = registration.settings();
    expect(before).toMatchObject({ ...SMALL, bending: 0.5, penalty: 500, membrane: 1 });
    await expect(registration.update({ settings: { penalty: 600, volume: -1 } })).rejects.toThrow("volume is -1");
    expect(registration.settings()).toEqual(before);
    registration.free();
  });

  test.each(SETTINGS)("refuses what $name cannot be, by a sentence that names it", async (setting) => {
    const wrong = [null, {}, [], 1n, Symbol("x"), () => {}, Number.NaN, "no such thing", new Date()];
    if (setting.kind === "number" || setting.kind === "level")
      wrong.push(setting.most * 1.1 + 1, setting.least - 1, "1", true);
    for (const value of wrong) {
      const message = await refusal({ [setting.name]: value });
      expect(message).toMatch(new RegExp(`^${setting.name} is .+, but must be `));
      expect(message).not.toMatch(/invalid type|expected|variant|JsValue|undefined/);
    }
  });
});

describe("a message", () => {
  test.each([
    ['cutoff is "round", but must be one of "quartic", "cosine", "bump"', { cutoff: "round" }],
    ['settings has no field "bendign"; did you mean "bending"?', { bendign: 1 }],
    [`bending is "${"x".repeat(60)}…", but must be a number from 0 to 1e6`, { bending: "x".repeat(1e6) }],
    ["finest is 3, but must be at least 4, the value of coarsest", { finest: 3 }],
    ["lambda is 0.1, but must be at least 2 mu = 0.5, or the energy falls without bound", { lambda: 0.1 }],
    ["bandwidth is 0.003, but must be 0 (automatic) or at least 0.00390625, half a cell", { bandwidth: 0.003 }],
    ["thickness is 1e200, but must be a number from 1e-6 to 10", { thickness: 1e200 }],
    ["pins is an array, but must be a Float64Array", { pins: [0.1, 0.2, 0.3, 0.4] }],
    ["pins is 3 numbers long, but must be a multiple of 4", { pins: new Float64Array(3) }],
    ["pins is 2 at position 3 (pin 0, y on the template's side)", { pins: Float64Array.of(0.5, 0.5, 0.5, 2) }],
    ["settings is 7, but must be an object", 7],
    ['settings is "small", but must be an object', "small"],
    ["settings is an array, but must be an object", []],
  ])("%s", async (message, given) => {
    expect(await refusal(given)).toContain(message);
  });

  test("is what comes of exceptions in getters and proxies, and the next call works", async () => {
    const throwing = () => {
      throw new Error("not today");
    };
    const revoked = Proxy.revocable({}, {});
    revoked.revoke();
    const detached = new Float64Array(4);
    structuredClone(detached.buffer, { transfer: [detached.buffer] });
    for (const [given, part] of [
      [
        Object.defineProperty({}, "bending", { get: throwing, enumerable: true }),
        'bending cannot be read: it throws "not today"',
      ],
      [new Proxy({}, { ownKeys: throwing }), 'settings cannot be read: it throws "not today"'],
      [new Proxy({ bending: 1 }, { get: throwing }), "bending cannot be read"],
      [revoked.proxy, "settings cannot be read"],
      [{ bending: revoked.proxy }, "bending is an object"],
      [{ pins: new Proxy(new Float64Array(4), {}) }, "pins is an object, but must be a Float64Array"],
      [{ pins: detached }, "pins cannot be read: it throws"],
    ] as const)
      expect(await refusal(given)).toContain(part);
    expect((await settingsOf({ ...SMALL, pins: Float64Array.of(0.1, 0.2, 0.3, 0.4) })).pins).toEqual(
      Float64Array.of(0.1, 0.2, 0.3, 0.4),
    );
  });
});

test("the largest and the least numbers together end without a NaN", { timeout: 60_000 }, async () => {
  const moved: Shape = { kind: "curves", loops: [Float64Array.of(0.35, 0.3, 0.75, 0.35, 0.7, 0.7, 0.3, 0.75)] };
  for (const end of ["most", "least"] as const) {
    const numbers = SETTINGS.flatMap((setting) => (setting.kind === "number" ? [[setting.name, setting[end]]] : []));
    const given = {
      ...Object.fromEntries(numbers),
      coarsest: 3,
      finest: 5,
      tolerance: 1e-4,
      bandwidth: end === "most" ? 1 : 0,
    };
    // As far as the two Lamé coefficients go together.
    if (end === "most") given.mu = 5e5;
    else given.lambda = 2e-6;
    for (const change of [{}, { minimizer: "ncg" }, { bendingModel: "mean-curvature", membraneModel: "projected" }]) {
      const registration = await Registration.create(SQUARE, moved, { ...given, ...change } as Partial<Settings>);
      let status = await registration.step(1);
      for (let k = 0; k < 60 && !status.finished; k += 1) status = await registration.step(5);
      const { energies, mismatch, stretch, leastDeterminant } = status;
      for (const value of [
        ...Object.values(energies),
        ...Object.values(mismatch),
        ...Object.values(stretch),
        leastDeterminant,
      ])
        expect(Number.isFinite(value)).toBe(true);
      expect(registration.deformation().every(Number.isFinite)).toBe(true);
      registration.free();
    }
  }
});
