import { expect, test } from "vitest";
import { decodeRecord, encodeRecord, type MatchRecord } from "./record";
import { PRESETS } from "./shapes/presets";

const [{ reference, template }] = PRESETS;

/** The identity on level 2, slightly off, with its report. */
function record(): MatchRecord {
  const deformation = Float64Array.from({ length: 50 }, (_, i) => Math.sin(i) / 3);
  const moved = reference.map((loop) => loop.map((value) => value + 0.1 / 3));
  return {
    reference,
    template,
    settings: { bending: 0.3, finest: 5, align: "none" },
    match: {
      status: {
        finished: true,
        stop: "Converged.",
        level: 2,
        iteration: 7,
        evaluations: 99,
        energies: { membrane: 0.1, bending: 0.2, mismatch: 1 / 3, volume: 1e-300, total: 0.7 },
        leastDeterminant: 0.25,
        mismatch: { mean: 0.01, max: 0.1 },
        stretch: { mean: 1, deviation: 0 },
      },
      deformation,
      curves: { reference: [...reference], template: [...template], matched: [...moved] },
    },
  };
}

test("what is read is what was written, to the bit", () => {
  const written = record();
  expect(decodeRecord(JSON.parse(encodeRecord(written)))).toEqual(written);
});

test("without a match, shapes and settings remain", () => {
  const written = { ...record(), match: null };
  expect(decodeRecord(JSON.parse(encodeRecord(written)))).toEqual(written);
});

test("settings are written out in full, so that other defaults change nothing", () => {
  const { settings } = JSON.parse(encodeRecord(record()));
  expect(settings).toMatchObject({ membrane: 1, bending: 0.3, finest: 5 });
});

type Json = Record<string, unknown>;

test.each<[string, (file: Json) => void, RegExp]>([
  ["of another version", (file) => Object.assign(file, { version: 2 }), /version 2; this page reads version 1/],
  ["without a template", (file) => delete file.template, /template is missing/],
  ["with an unknown setting", (file) => Object.assign(file.settings as Json, { magic: 1 }), /setting “magic”/],
  ["with a setting out of range", (file) => Object.assign(file.settings as Json, { bending: -1 }), /Bending is “-1”/],
  [
    "with a point that is none",
    (file) =>
      Object.assign(file, {
        reference: {
          loops: [
            [
              [0, 0],
              [1, null],
              [1, 1],
            ],
          ],
        },
      }),
    /reference, loop 1, point 2 is no number/,
  ],
  [
    "cut off",
    (file) => Object.assign(file.match as Json, { deformation: [1, 2, 3] }),
    /has 3 numbers, but level 2 needs 50/,
  ],
  [
    "without energies",
    (file) => delete ((file.match as Json).report as Json).energies,
    /match.report.energies is missing/,
  ],
  [
    "with curves that do not belong together",
    (file) => Object.assign((file.match as Json).curves as Json, { matched: [] }),
    /matched curves have not the points/,
  ],
])("a file %s is refused with a reason", (_, damage, message) => {
  const file = JSON.parse(encodeRecord(record()));
  damage(file);
  expect(() => decodeRecord(file)).toThrow(message);
});
