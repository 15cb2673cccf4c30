import { readFileSync } from "node:fs";
import { describe, expect, test } from "vitest";
import { FIELDS, parseSetting, withSetting } from "../settings";
import { loopFromStroke } from "../shapes/edit";
import { PRESETS } from "../shapes/presets";
import { mutate, seeded } from "../testing/mutate";
import { pack } from "./pack";
import { decode, encode, type Saved } from "./text";

const RING = PRESETS.find((preset) => preset.id === "ring");
if (!RING) throw new Error("the ring is needed here");
const LOOK = { view: "grid", morph: 1 } as const;
const DRAWN: Saved = {
  reference: RING.reference,
  template: RING.template,
  pins: [],
  settings: {},
  preset: null,
  ...LOOK,
};
const PIN = { reference: { x: 0.25, y: 0.5 }, template: { x: 0.75, y: 0.125 } };

/** Longest link that every mail program and messenger takes, shapes and all. */
const LONGEST = 2000;

describe("a link", () => {
  test("brings shapes back to 2 · 10⁻⁵, with every loop", () => {
    const back = decode(encode(DRAWN));
    expect(back.reference).toHaveLength(2);
    back.template.forEach((loop, l) => {
      loop.forEach((value, i) => {
        expect(Math.abs(value - RING.template[l][i])).toBeLessThan(2e-5);
      });
    });
  });

  test("is the same after a second round, so reloading never wears shapes down", () => {
    const once = encode(decode(encode(DRAWN)));
    expect(encode(decode(once))).toBe(once);
  });

  test("names a preset instead of its points", () => {
    const text = encode({ ...DRAWN, preset: "ring" });
    expect(text).toBe("v=2&preset=ring");
    expect(decode(text)).toEqual({ ...DRAWN, preset: "ring" });
  });

  test("carries the settings that were changed, of every kind", () => {
    const settings = { bending: 0, finest: 6, halving: false, align: "none" } as const;
    expect(decode(encode({ ...DRAWN, settings })).settings).toEqual(settings);
  });

  test("carries view, morph and pins, those on the box's border too", () => {
    const pins = [PIN, { reference: { x: 0, y: 1 }, template: { x: 1, y: 0 } }];
    const back = decode(encode({ ...DRAWN, preset: "ring", pins, view: "stretch", morph: 0.25 }));
    expect([back.view, back.morph]).toEqual(["stretch", 0.25]);
    back.pins.forEach((pin, i) => {
      for (const side of ["reference", "template"] as const) {
        expect(Math.abs(pin[side].x - pins[i][side].x)).toBeLessThan(2e-5);
        expect(Math.abs(pin[side].y - pins[i][side].y)).toBeLessThan(2e-5);
      }
    });
  });

  test("carries empty shapes and points outside the box", () => {
    const odd = { ...DRAWN, reference: [], template: [Float64Array.of(-0.1, 0.5, 1.2, 0.5, 0.5, 1.1)] };
    const back = decode(encode(odd));
    expect(back.reference).toEqual([]);
    expect(back.template[0][0]).toBeCloseTo(-0.1, 4);
    expect(back.template[0][5]).toBeCloseTo(1.1, 4);
  });
});

/** A hand's circle: uneven speed, a tremor, and rounded to pixels of the surface. */
function handDrawn(seed: number): Float64Array {
  const random = seeded(seed);
  const [a, b] = [0.15 + 0.15 * random(), 0.15 + 0.15 * random()];
  let tremor = 0;
  const stroke = Array.from({ length: 110 }, (_, i) => {
    const t = (2 * Math.PI * (i + 0.6 * random())) / 111;
    tremor = 0.8 * tremor + 0.004 * (random() - 0.5);
    const lobes = 1 + 0.15 * Math.sin(3 * t + seed) + tremor;
    const onPixel = (value: number) => Math.round(400 * value) / 400;
    return { x: onPixel(0.5 + a * lobes * Math.cos(t)), y: onPixel(0.5 + b * lobes * Math.sin(t)) };
  });
  const loop = loopFromStroke(stroke, 0);
  if (!loop) throw new Error("the stroke was taken for a tap");
  return loop;
}

describe("the size of a link", () => {
  test.each(PRESETS)("$id, drawn upon, is at most 2000 letters with pins, settings and view", (preset) => {
    const settings = { bending: 0.123456789, membrane: 2.5, finest: 8, halving: false, minimizer: "ncg" } as const;
    const pins = [PIN, PIN, PIN];
    const text = encode({ ...preset, pins, settings, preset: null, view: "determinant", morph: 0.375 });
    expect(text.length).toBeLessThanOrEqual(LONGEST);
  });

  test.each([1, 2, 3, 4, 5])("pair %i by an unsteady hand, without smoothing, is at most 2000 letters", (seed) => {
    const text = encode({ ...DRAWN, reference: [handDrawn(seed)], template: [handDrawn(seed + 10)] });
    expect(text.length).toBeLessThanOrEqual(LONGEST);
    const back = decode(text);
    back.reference[0].forEach((value, i) => {
      expect(Math.abs(value - handDrawn(seed)[i])).toBeLessThan(2e-5);
    });
  });
});

type Old = {
  name: string;
  link: string;
  preset: string | null;
  settings: unknown;
  pins: unknown;
  reference: number[][] | null;
  template: number[][] | null;
};

/** Made by the page when it wrote version 1. */
const OLD: Old[] = JSON.parse(readFileSync("tests/fixtures/links-1.json", "utf8"));

test.each(OLD)("a link of version 1 still opens: $name", ({ link, preset, settings, pins, reference, template }) => {
  const back = decode(link);
  expect(back).toMatchObject({ preset, settings, pins, ...LOOK });
  for (const [loops, then] of [
    [back.reference, reference],
    [back.template, template],
  ] as const) {
    if (!then) continue;
    expect(loops.map((loop) => [...loop].map((value) => Number(value.toFixed(5))))).toEqual(then);
  }
});

describe("what damage and other hands make of a link", () => {
  test.each([
    ["v=7&preset=star", "version “7” is not known"],
    ["v=__proto__&preset=star", "version “__proto__” is not known"],
    ["preset=star", "it is no link of this page"],
    ["v=2&preset=dragon", "there is no example called “dragon”"],
    ["v=1&reference=AAAA", "loop 0 of the reference is cut off"],
    ["v=1&reference=*", "loop 0 of the reference is damaged"],
    ["v=1&reference=AAAAAAAAAAA&template=", "loop 0 of the reference has fewer than three points"],
    ["v=2&reference=AAAA", "loop 0 of the reference is cut off"],
    ["v=2&reference=*", "loop 0 of the reference is damaged"],
    ["v=2&reference=AAD__AAA", "loop 0 of the reference is too long"],
    ["v=1&reference=", "the target is missing"],
    ["v=2&preset=star&bending=much", "Bending is “much”, but must be a number from 0 to 100"],
    ["v=2&preset=star&align=sideways", "Start from is “sideways”, but must be one of similarity, none"],
    ["v=2&preset=star&view=toString", "there is no view called “toString”"],
    ["v=2&preset=star&morph=2", "the morph is “2”, but must be a number from 0 to 1"],
    ["v=2&preset=star&pins=AAAA", "the list of pins is cut off"],
  ])("%s says what is wrong", (text, why) => {
    expect(() => decode(text)).toThrow(why);
  });

  test("whatever a letter is changed to, it is said or means nothing: no shape is silently another", () => {
    const random = seeded(11);
    const text = encode({ ...DRAWN, pins: [PIN], settings: { bending: 0, finest: 6 }, view: "stretch", morph: 0.5 });
    const known = new Set([...DRAWN.reference, ...DRAWN.template].map(pack));
    const outcomes = { refused: 0, read: 0 };
    for (let i = 0; i < 5000; i += 1) {
      const mutated = mutate(text, random);
      let back: Saved;
      try {
        back = decode(mutated);
      } catch (error) {
        outcomes.refused += 1;
        // Meant, not stumbled upon.
        expect((error as Error).constructor).toBe(Error);
        expect((error as Error).message.length).toBeLessThan(300);
        continue;
      }
      outcomes.read += 1;
      // A loop less, where a dot went with it, is what the text says.
      for (const loop of [...back.reference, ...back.template]) expect(known.has(pack(loop))).toBe(true);
      expect(back.morph).toBeGreaterThanOrEqual(0);
      expect(back.morph).toBeLessThanOrEqual(1);
      // What is read can be written, and means the same.
      expect(encode(decode(encode(back)))).toBe(encode(back));
    }
    expect(outcomes.refused).toBeGreaterThan(3000);
    expect(outcomes.read).toBeGreaterThan(50);
  }, 60_000);
});

describe("settings", () => {
  test.each(FIELDS)("$name takes its default and leaves it out", (field) => {
    const value = parseSetting(field, String(field.initial));
    expect(value).toBe(field.initial);
    expect(withSetting({}, field, value)).toEqual({});
  });

  test.each(["", "NaN", "-1", "1e9", "two"])("a number is not “%s”", (text) => {
    const field = FIELDS.find((candidate) => candidate.name === "membrane");
    expect(field && (() => parseSetting(field, text))).toThrow("Stretching is");
  });
});
