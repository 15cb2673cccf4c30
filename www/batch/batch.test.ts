import { readFileSync } from "node:fs";
import { beforeAll, expect, test } from "vitest";
import { readland } from "../../scripts/lib/readland.mjs";
import { centroidSize } from "../morphometrics/configuration";
import { evenPoints } from "../morphometrics/semilandmarks";
import { readTps } from "../morphometrics/tps";
import { decodeRecord, encodeRecord } from "../record";
import type { Chosen } from "../settings";
import type { Loop } from "../shapes/geometry";
import { Content } from "../shapes/import/content";
import { readCsv } from "../shapes/import/csv";
import { prepared } from "../shapes/import/fit";
import type { Found } from "../shapes/import/found";
import { readText } from "../shapes/import/read";
import { nearest } from "../view/along";
import { initSync, Registration } from "../wasm/thinshell.js";
import { type Matched, matched, type Plan } from "./match";
import { own, type Subject, subjectOf, tied } from "./subject";
import { distinct, subjectsIn } from "./subjects";
import { counts, type Row, referenceSize, semilandmarksCsv, semilandmarksTps, strainsCsv, tableCsv } from "./tables";

beforeAll(() => {
  initSync({ module: readFileSync("www/wasm/thinshell_bg.wasm") });
});

const WISHES = { parts: "all", holes: "keep", placement: "fit", smoothing: 0 } as const;
const NOWHERE = new Float64Array();

function subject(name: string, loop: Loop, landmarks = NOWHERE, scale: number | null = null): Subject {
  return subjectOf(name, { marks: { landmarks, image: null, scale } }, prepared([loop], WISHES));
}

function planOf(reference: Subject, settings: Chosen): Plan {
  return { reference, points: evenPoints(reference.shape, 100), settings };
}

const once = (plan: Plan, target: Subject): Promise<Matched> => matched({ Registration }, plan, target, () => {});

type Map = (x: number, y: number) => readonly [number, number];

/** No two places of it are alike. */
function blob(map: Map = (x, y) => [x, y]): Loop {
  return Float64Array.from(
    Array.from({ length: 400 }, (_, k) => {
      const t = (2 * Math.PI * k) / 400;
      const r = 1 + 0.3 * Math.cos(2 * t + 0.4) + 0.15 * Math.sin(3 * t) + 0.1 * Math.cos(5 * t + 1);
      return map(r * Math.cos(t), r * Math.sin(t));
    }).flat(),
  );
}

/**
 * A closed curve of length 6 by its tangent's angle, t + Σ a sin (j t + f) for even j: from one such curve to another
 * equal arc lengths correspond, and nothing along the curve is stretched.
 */
function bent(modes: readonly (readonly [number, number, number])[]): Loop {
  const fine = 8000;
  const points = [0, 0];
  let [x, y] = [0, 0];
  for (let k = 0; k + 1 < fine; k += 1) {
    const t = (2 * Math.PI * (k + 0.5)) / fine;
    const angle = modes.reduce((sum, [j, a, f]) => sum + a * Math.sin(j * t + f), t);
    x += (6 * Math.cos(angle)) / fine;
    y += (6 * Math.sin(angle)) / fine;
    if ((k + 1) % 20 === 0) points.push(x, y);
  }
  return Float64Array.from(points);
}

/** The largest distance of the semilandmarks to where they should be, in cells of the finest grid. */
function worst({ points }: Matched, truth: Float64Array, target: Subject, finest: number): number {
  let most = 0;
  for (let i = 0; i < points.length; i += 2) {
    most = Math.max(most, Math.hypot(points[i] - truth[i], points[i + 1] - truth[i + 1]));
  }
  return most * Math.hypot(target.box.a, target.box.b) * 2 ** finest;
}

function carried(points: Float64Array, map: Map): Float64Array {
  return Float64Array.from({ length: points.length }, (_, k) => map(points[k & ~1], points[k | 1])[k % 2]);
}

test("semilandmarks of a shape that is turned, enlarged and moved are where it takes them, to 0.1 cells", async () => {
  const map: Map = (x, y) => [3 * (0.8 * x - 0.6 * y) + 5, 3 * (0.6 * x + 0.8 * y) + 7];
  const plan = planOf(subject("reference", blob()), { finest: 7 });
  const target = subject("target", blob(map));
  const match = await once(plan, target);
  expect(worst(match, carried(own(plan.points, plan.reference.box), map), target, 7)).toBeLessThan(0.1);
  expect(match.centroidSize / referenceSize(plan)).toBeCloseTo(3, 3);
  expect(match.procrustesDistance).toBeLessThan(2e-3);
});

test("semilandmarks of a shape that is bent without being stretched keep their arc length, to 0.1 cells", async () => {
  const [first, second] = [
    bent([
      [2, 0.3, 0],
      [4, 0.2, 1],
    ]),
    bent([
      [2, 0.35, 0],
      [4, 0.25, 1],
    ]),
  ];
  // They are alike after half a turn, which is as good: nothing is to be turned first.
  const plan = planOf(subject("reference", first), { finest: 6, align: "none" });
  const target = subject("target", second);
  const match = await once(plan, target);
  const truth = carried(own(plan.points, plan.reference.box), (x, y) => {
    const { edge, part } = nearest([first], x, y) ?? { edge: 0, part: 0 };
    const [from, to] = [2 * edge, (2 * edge + 2) % second.length];
    return [
      second[from] + part * (second[to] - second[from]),
      second[from + 1] + part * (second[to + 1] - second[from + 1]),
    ];
  });
  expect(worst(match, truth, target, 6)).toBeLessThan(0.1);
  expect(match.procrustesDistance).toBeGreaterThan(0.02);
});

test("with landmarks on both shapes semilandmarks of a known smooth deformation are right to 0.1 cells", async () => {
  const map: Map = (x, y) => [x + 0.01 * y * y, y - 0.01 * x * x];
  const marks = (loop: Loop) => loop.filter((_, i) => (i >> 1) % 25 === 0);
  const plan = planOf(subject("reference", blob(), marks(blob())), { finest: 6 });
  const target = subject("target", blob(map), marks(blob(map)));
  const match = await once(plan, target);
  expect(match.pins).toHaveLength(16);
  expect(worst(match, carried(own(plan.points, plan.reference.box), map), target, 6)).toBeLessThan(0.1);
});

test("landmarks that are missing on one side are not tied, and unlike numbers tie nothing and say so", () => {
  const [p, q] = [blob().slice(0, 6), blob().slice(0, 6)];
  q.set([Number.NaN, Number.NaN], 2);
  const [a, b] = [subject("a", blob(), p), subject("b", blob(), q)];
  expect(tied(a, b).pins.map(({ reference }) => reference.x)).toEqual([a.landmarks[0], a.landmarks[4]]);
  expect(tied(a, subject("c", blob(), q.slice(2)))).toEqual({
    pins: [],
    note: "Landmarks are not tied: the reference has 3, this shape 2.",
  });
  expect(tied(a, subject("d", blob()))).toEqual({ pins: [], note: null });
});

test("what is thrown on the way ends a match", async () => {
  const plan = planOf(subject("reference", blob()), { finest: 6 });
  const stop = () => {
    throw new Error("enough");
  };
  const target = subject(
    "target",
    blob((x, y) => [x + 0.2 * y, y]),
  );
  await expect(matched({ Registration }, plan, target, stop)).rejects.toThrow("enough");
});

async function someRows(): Promise<{ plan: Plan; rows: Row[] }> {
  // Pixels below the origin, and a scale: 0.5 mm each.
  const plan = planOf(
    subject(
      "reference",
      blob((x, y) => [x, y - 4]),
      NOWHERE,
      0.5,
    ),
    { finest: 5 },
  );
  const target = subject(
    "one, two",
    blob((x, y) => [2 * x + 9, 2 * y + 9]),
    NOWHERE,
    0.25,
  );
  const match = await once(plan, target);
  const base = { file: "some.tps", outcome: match.status.verdict ?? "" };
  return {
    plan,
    rows: [
      { ...base, name: "one, two", target, match },
      { name: "bad", file: "bad.svg", outcome: "“M0” is no shape.", target: null, match: null },
    ],
  };
}

test("the tables hold the points of all matched shapes in one order, as an independent reader finds them", async () => {
  const { plan, rows } = await someRows();
  const specimens = readland(semilandmarksTps(plan, rows));
  expect(specimens.map(({ id, points }) => [id, points.length])).toEqual([
    ["reference", 100],
    ["one, two", 100],
  ]);
  const lines = semilandmarksCsv(plan, rows).trimEnd().split("\n");
  expect(lines[0]).toBe("shape,point,x,y");
  expect(lines).toHaveLength(201);
  expect(lines[101]).toMatch(/^"one, two",1,[\d.]+,[\d.]+$/);
  // Scaled by either reader both shapes are alike in size, and as the table says.
  const [first, second] = specimens.map(({ points }) => centroidSize(Float64Array.from(points.flat())));
  expect(first).toBeCloseTo(referenceSize(plan), 10);
  expect(second).toBeCloseTo(rows[0].match?.centroidSize ?? 0, 10);
  expect(second / first).toBeCloseTo(1, 2);
});

test("where coordinates would be negative, the whole configuration is moved, and its comment says by how much", async () => {
  const { plan, rows } = await someRows();
  const [first, second] = readTps(semilandmarksTps(plan, rows));
  expect(second.others).toEqual([]);
  const [, x, y] = /^COMMENT=moved by (\S+) (\S+),/.exec(first.others[0]) ?? [];
  const back = first.landmarks.map((value, i) => value - Number(i % 2 === 0 ? x : y));
  const there = own(plan.points, plan.reference.box);
  for (let i = 0; i < back.length; i += 1) expect(back[i]).toBeCloseTo(there[i], 12);
});

test("points written as CSV can be taken for shapes again, each by its name", async () => {
  const { plan, rows } = await someRows();
  const found = readCsv(semilandmarksCsv(plan, rows));
  if (found.kind !== "shapes") throw new Error("shapes expected");
  expect(found.choices.map(({ name }) => name)).toEqual(["reference", "one, two"]);
  for (const { loops } of found.choices) expect(loops).toHaveLength(1);
});

test("the table has a line for every target, also for one that could not be read", async () => {
  const { rows } = await someRows();
  const [header, one, bad] = tableCsv(rows).trimEnd().split("\n");
  expect(header).toMatch(/^shape,file,matched,centroid_size,procrustes_distance,fits,/);
  expect(one).toMatch(/^"one, two",some.tps,yes,[\d.]+,[\d.e-]+,yes,/);
  expect(bad).toBe(`bad,bad.svg,no,${",".repeat(12)}“M0” is no shape.`);
});

test("a match that misses the target's hole is counted as matched, and not as one that fits", async () => {
  const { plan, rows } = await someRows();
  const ringed = subjectOf(
    "ringed",
    { marks: { landmarks: NOWHERE, image: null, scale: null } },
    prepared([blob(), blob((x, y) => [0.2 * x, 0.2 * y])], WISHES),
  );
  const match = await once(plan, ringed);
  const missed: Row = { name: "ringed", file: "r.svg", outcome: match.status.verdict ?? "", target: ringed, match };
  expect(counts([...rows, missed])).toEqual({ matched: 2, fitting: 1 });
  expect(tableCsv([missed])).toMatch(/\nringed,r.svg,yes,[\d.]+,[\d.]+,no,[^\n]*hole/);
});

test("strains come a line a cell, with the reference's inside marked", async () => {
  const { plan, rows } = await someRows();
  const [header, ...lines] = strainsCsv(plan, rows).trimEnd().split("\n");
  expect(header).toBe("shape,x,y,inside,strain_1,strain_2,direction_1,expansion");
  expect(lines).toHaveLength(1024);
  const cells = lines.map((line) => line.replace('"one, two",', "").split(",").map(Number));
  const inside = cells.filter(([, , is]) => is === 1);
  expect(inside.length).toBeGreaterThan(120);
  expect(inside.length).toBeLessThan(480);
  // Shapes that are similar: nothing is strained once both are of one size.
  for (const [, , , first, second, , expansion] of inside) {
    expect(Math.max(Math.abs(first), Math.abs(second), Math.abs(expansion - 1))).toBeLessThan(0.05);
  }
});

test("a match is a file that the page opens", async () => {
  const { plan, rows } = await someRows();
  const [{ match, target }] = rows;
  if (!match || !target) throw new Error("a match is expected");
  const { status, deformation, curves, pins } = match;
  const shapes = { reference: plan.reference.shape, template: target.shape, pins };
  const text = encodeRecord({ ...shapes, settings: plan.settings, match: { status, deformation, curves } });
  const again = decodeRecord(JSON.parse(text));
  expect(again.match?.deformation).toEqual(deformation);
  expect(again.settings).toEqual({ finest: 5 });
});

async function taken(found: Found, file: string, outline = false) {
  if (found.kind === "saved") throw new Error("shapes expected");
  const content = new Content(found);
  return subjectsIn(content.offer, file, outline, (wishes) => content.outcome(wishes));
}

test("of a list every shape is a target, and one that is none does not keep the others out", async () => {
  const list = [
    {
      name: "a",
      points: [
        [0, 0],
        [9, 0],
        [0, 9],
      ],
    },
    {
      name: "b",
      points: [
        [0, 0],
        [9, 0],
        [9, 0.001],
      ],
    },
    {
      name: "c",
      points: [
        [0, 0],
        [9, 0],
        [9, 9],
      ],
    },
  ];
  const found = await taken(readText(JSON.stringify(list)), "list.json");
  expect(found.map((each) => [each.name, "subject" in each])).toEqual([
    ["a", true],
    ["b", false],
    ["c", true],
  ]);
});

test("only the outline: the largest part, its hole filled", async () => {
  const table = "loop,x,y\n0,0,0\n0,9,0\n0,9,9\n0,0,9\n1,3,3\n1,6,3\n1,6,6\n1,3,6\n2,20,0\n2,22,0\n2,22,2";
  const loops = async (outline: boolean) => {
    const [one] = await taken(readText(table), "table.csv", outline);
    return "subject" in one ? one.subject.shape.length : 0;
  };
  expect(await loops(false)).toBe(3);
  expect(await loops(true)).toBe(1);
});

test("names are given once", () => {
  const name = distinct();
  expect(["a", "b", "a", "A", "a (2)"].map(name)).toEqual(["a", "b", "a (2)", "A (3)", "a (2) (2)"]);
});
