import { describe, expect, test } from "vitest";
import { FIELDS, parseSetting, withSetting } from "./settings";
import { PRESETS } from "./shapes/presets";
import { decode, encode, fallback, open, type Saved } from "./state";

const RING = PRESETS.find((preset) => preset.id === "ring");
if (!RING) throw new Error("the ring is needed here");
const DRAWN: Saved = { reference: RING.reference, template: RING.template, pins: [], settings: {}, preset: null };

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
    expect(text).toBe("v=1&preset=ring");
    expect(decode(text)).toEqual({ ...DRAWN, preset: "ring" });
  });

  test("carries the settings that were changed, of every kind", () => {
    const settings = { bending: 0, finest: 6, halving: false, align: "none" } as const;
    expect(decode(encode({ ...DRAWN, settings })).settings).toEqual(settings);
  });

  test("carries empty shapes and points outside the box", () => {
    const odd = { ...DRAWN, reference: [], template: [Float64Array.of(-0.1, 0.5, 1.2, 0.5, 0.5, 1.1)] };
    const back = decode(encode(odd));
    expect(back.reference).toEqual([]);
    expect(back.template[0][0]).toBeCloseTo(-0.1, 4);
    expect(back.template[0][5]).toBeCloseTo(1.1, 4);
  });
});

describe("a broken link", () => {
  test.each([
    ["v=7&preset=star", "version “7” is not known"],
    ["v=1&preset=dragon", "there is no example called “dragon”"],
    ["v=1&reference=AAAA", "loop 0 of the reference is cut off"],
    ["v=1&reference=*", "loop 0 of the reference is damaged"],
    ["v=1&reference=", "the template is missing"],
    ["v=1&preset=star&bending=much", "Bending is “much”, but must be a number from 0 to 100"],
    ["v=1&preset=star&align=sideways", "Start from is “sideways”, but must be one of similarity, none"],
  ])("%s says what is wrong and keeps the stored shapes", (hash, why) => {
    const stored = encode({ ...DRAWN, preset: "ring" });
    const opened = open(`#${hash}`, stored);
    expect(opened.problem).toContain(why);
    expect(opened.saved.preset).toBe("ring");
  });

  test("an anchor of the page is no link", () => {
    expect(open("#method", null)).toEqual({ saved: fallback(), problem: null, remembered: false, later: false });
  });

  test("damaged storage gives the first example", () => {
    expect(open("", "v=0&nonsense").saved).toEqual(fallback());
  });
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
