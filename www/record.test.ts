import { expect, test } from "vitest";
import { decodeRecord, encodeRecord, type MatchRecord, type SavedMatch } from "./record";
import { PRESETS } from "./shapes/presets";

const [{ reference, template }] = PRESETS;

/** The identity on level 2, moved and slightly off, with its report. */
function record(): MatchRecord {
  const deformation = Float64Array.from(
    { length: 50 },
    (_, i) => (i % 2 === 0 ? (i >> 1) % 5 : Math.floor(i / 10)) / 4 + Math.sin(i) / 30,
  );
  const moved = reference.map((loop) => loop.map((value) => value + 0.1 / 3));
  return {
    reference,
    template,
    pins: [{ reference: { x: 0.3, y: 1 / 3 }, template: { x: 0, y: 1 } }],
    settings: { bending: 0.3, finest: 5, align: "none" },
    match: {
      status: {
        finished: true,
        stop: "Converged.",
        level: 2,
        iteration: 7,
        evaluations: 99,
        energies: { membrane: 0.1, bending: 0.2, mismatch: 1 / 3, volume: 1e-300, pins: 0, total: 0.7 },
        leastDeterminant: 0.25,
        mismatch: { mean: 0.01, max: 0.1 },
        stretch: { mean: 1, deviation: 0 },
        cover: { mean: 0.01, max: 0.1 },
        measure: 1,
        backend: "cpu",
        facts: Float64Array.of(0, 0, 4, 1, 1, 3, 0.5, 0.5),
        verdict: "Fits: nowhere more than 0.10 cells off.",
        approach: "matching directly",
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

test("a file from before the template's parts were measured opens, and so does what is saved of it", () => {
  const file = JSON.parse(encodeRecord(record()));
  for (const name of ["cover", "measure", "verdict"]) delete file.match.report[name];
  const opened = decodeRecord(file);
  expect(opened.match?.status).toMatchObject({ measure: Number.NaN, verdict: null, mismatch: { max: 0.1 } });
  expect(decodeRecord(JSON.parse(encodeRecord(opened)))).toEqual(opened);
});

test("settings are written out in full, so that other defaults change nothing", () => {
  const { settings } = JSON.parse(encodeRecord(record()));
  expect(settings).toMatchObject({ membrane: 1, bending: 0.3, finest: 5 });
});

type Json = Record<string, unknown>;

function reportOf(file: Json): Json {
  return (file.match as Json).report as Json;
}

test("a match whose curve the grid does not see is read again, its distances still undefined", () => {
  const written = record();
  const match = written.match as SavedMatch;
  const undefinedThere = {
    ...match,
    status: {
      ...match.status,
      mismatch: { mean: Number.NaN, max: Number.NaN },
      stretch: { mean: Number.NaN, deviation: Number.NaN },
    },
    curves: { reference: [], template: [], matched: [] },
  };
  expect(decodeRecord(JSON.parse(encodeRecord({ ...written, match: undefinedThere }))).match).toEqual(undefinedThere);
});

test.each<[string, (match: SavedMatch) => void]>([
  ["an energy without end", ({ status }) => Object.assign(status.energies, { total: Number.POSITIVE_INFINITY })],
  ["a node that is nowhere", ({ deformation }) => deformation.set([Number.NaN], 3)],
  ["a fold", ({ deformation }) => deformation.set([3, 3], 24)],
  ["no area at all", ({ status }) => Object.assign(status, { leastDeterminant: 0 })],
])("a match with %s is written as its shapes and settings, which are read again", (_, spoil) => {
  const written = record();
  spoil(written.match as SavedMatch);
  expect(decodeRecord(JSON.parse(encodeRecord(written)))).toEqual({ ...written, match: null });
});

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
  [
    "of a level that is none",
    (file) => Object.assign(reportOf(file), { level: -2000 }),
    /match.report.level is -2000, which no match has/,
  ],
  ["of half a level", (file) => Object.assign(reportOf(file), { level: 2.5 }), /level is 2.5, which no match has/],
  ["of a level without end", (file) => Object.assign(reportOf(file), { level: 1e9 }), /which no match has/],
  ["of a folded plane", (file) => Object.assign(reportOf(file), { leastDeterminant: -0.1 }), /folds the plane/],
  [
    "of a plane folded without saying so",
    (file) => {
      const { deformation } = file.match as { deformation: number[] };
      [deformation[24], deformation[25]] = [3, 3];
    },
    /folds the plane/,
  ],
  [
    "with a node that is nowhere",
    (file) => {
      (file.match as { deformation: (number | null)[] }).deformation[7] = null;
    },
    /match.deformation\[7\] is no number/,
  ],
  [
    "with an energy that is none",
    (file) => Object.assign(reportOf(file).energies as Json, { total: null }),
    /match.report.energies.total is no number/,
  ],
  [
    "with a distance in words",
    (file) => Object.assign(reportOf(file).mismatch as Json, { max: "NaN" }),
    /match.report.mismatch.max is no number/,
  ],
  [
    "with points in space",
    (file) => (file.reference as { loops: number[][][] }).loops[0][0].push(0),
    /reference, loop 1, point 1 has more than two numbers/,
  ],
])("a file %s is refused with a reason", (_, damage, message) => {
  const file = JSON.parse(encodeRecord(record()));
  damage(file);
  expect(() => decodeRecord(file)).toThrow(message);
});
