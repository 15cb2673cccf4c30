import { expect, test } from "vitest";
import { readland } from "../../scripts/lib/readland.mjs";
import { readText } from "../shapes/import/read";
import { readTpsShapes } from "../shapes/import/tps";
import { readTps, type Specimen, writeTps } from "./tps";

const NONE = { curves: [], image: null, id: null, scale: null, others: [] };

/** As tpsDig writes it: numbers with five places, an empty scale, a landmark that is missing. */
const DIGITISED = `LM=3
12.00000 7.50000
-1.00000 -1.00000
3.25000 88.00000
CURVES=2
POINTS=3
1.00000 1.00000
9.00000 1.00000
9.00000 9.00000
POINTS=3
9.00000 9.00000
1.00000 9.00000
1.00000 1.00000
IMAGE=leaf 01.jpg
ID=0
COMMENT=left side
SCALE=
LM=1
4 5
ID=1
SCALE=0.125
`.replaceAll("\n", "\r\n");

test("landmarks, curves, a missing point, an empty scale and what else a file of tpsDig holds are read", () => {
  const [first, second] = readTps(DIGITISED);
  expect([...first.landmarks]).toEqual([12, 7.5, Number.NaN, Number.NaN, 3.25, 88]);
  expect(first.curves.map((curve) => [...curve])).toEqual([
    [1, 1, 9, 1, 9, 9],
    [9, 9, 1, 9, 1, 1],
  ]);
  expect(first).toMatchObject({ image: "leaf 01.jpg", id: "0", scale: null, others: ["COMMENT=left side"] });
  expect(second).toEqual({ ...NONE, landmarks: Float64Array.of(4, 5), id: "1", scale: 0.125 });
});

test("what is written reads back to the bit, whatever the numbers are", () => {
  const bits = new Float64Array(new BigUint64Array(600).map((_, k) => hash(k)).buffer).map(Math.abs);
  const numbers = bits.filter(Number.isFinite).slice(0, 400);
  numbers.set([0, -0, 5e-324, Number.MAX_VALUE, 0.1 + 0.2, 1 / 3]);
  const specimens: Specimen[] = [
    { ...NONE, landmarks: numbers, curves: [numbers.slice(0, 60), numbers.slice(60, 80)], id: "a", scale: 0.1 + 0.2 },
    { ...NONE, landmarks: Float64Array.of(1, 2, Number.NaN, Number.NaN), image: "b.png", others: ["VARIABLES=x 1"] },
    { ...NONE, landmarks: new Float64Array() },
  ];
  const text = writeTps(specimens);
  const again = readTps(text);
  const buffers = (all: readonly Specimen[]) =>
    all.map(({ landmarks, curves }) =>
      [landmarks, ...curves].map((own) => [...new BigUint64Array(own.slice().buffer)]),
    );
  expect(buffers(again)).toEqual(buffers(specimens));
  expect(again).toEqual(specimens);
  expect(writeTps(again)).toBe(text);
});

test("an independent reader finds the same points, times the scale", () => {
  const landmarks = Float64Array.of(0.1, 0.7, 5.5, 1e-7, 123456.789, 3);
  const text = writeTps([
    { ...NONE, landmarks, id: "first", scale: 0.5 },
    { ...NONE, landmarks: landmarks.map((x) => x / 3), id: "second", scale: 2, others: ["COMMENT=moved"] },
  ]);
  const found = readland(text);
  expect(found.map(({ id }) => id)).toEqual(["first", "second"]);
  expect(found[0].points.flat()).toEqual([...landmarks].map((x) => 0.5 * x));
  expect(found[1].points.flat()).toEqual([...landmarks].map((x) => 2 * (x / 3)));
});

test("a negative coordinate is not written, for it would read as missing", () => {
  expect(() => writeTps([{ ...NONE, landmarks: Float64Array.of(1, -2) }])).toThrow(/negative.*missing/);
});

test.each([
  ["", /no specimen/],
  ["ID=3\nLM=1\n1 1", /Line 1: a specimen begins with LM=/],
  ["LM=2\n1 1", /Line 1 \(LM=2\) announces 2 points, and 1 follow/],
  ["LM=2\n1 1\nID=3", /Line 1 \(LM=2\) announces 2 points, and 1 follow/],
  ["LM=1\n1 1\n2 2", /Line 3: “2 2” is neither/],
  ["LM=1\n1 one", /Line 2: “1 one” is not the two numbers/],
  ["LM=1\n1 2 3", /Line 2: “1 2 3” is not the two numbers/],
  ["LM=many\n1 1", /Line 1: “LM=many” gives no count/],
  ["LM=0\nSCALE=0", /Line 2: “SCALE=0” is no scale/],
  ["LM=0\nCURVES=2\nPOINTS=1\n1 1", /Line 2 \(CURVES=2\) does not fit the number of its lines POINTS=: 1\./],
  [
    "LM=0\nCURVES=1\nPOINTS=1\n1 1\nPOINTS=1\n1 1",
    /Line 2 \(CURVES=1\) does not fit the number of its lines POINTS=: 2\./,
  ],
  ["LM=9999999\n1 1", /announces 9999999 points, and 1 follow/],
  ["LM=1\n0,5 1", /Line 2: “0,5 1” is not the two numbers/],
  ["LM=0\nSCALE=-2", /Line 2: “SCALE=-2” is no scale/],
  ["LM3=1\n1 1 1", /Line 1: landmarks in space/],
])("a file is refused with its line: %j", (text, message) => {
  expect(() => readTps(text)).toThrow(message);
});

test("remarks are passed over, and lines keep their numbers", () => {
  expect([...readTps("# by hand\nLM=1\n// the tip\n1 2\nID=a")[0].landmarks]).toEqual([1, 2]);
  expect(() => readTps("# by hand\nLM=1\n1 two")).toThrow(/Line 3/);
});

test.each([
  ["# by hand\r\nLM=3\r\n0 0\r\n1 0\r\n0 1\r\n", null],
  ["lm = 3\n0 0\n1 0\n0 1\n", null],
  ["ID=a\nLM=3\n0 0\n1 0\n0 1\n", /Line 1: a specimen begins with LM=, not with ID=/],
  ["\n# by hand\nCURVES=1\nPOINTS=1\n0 0\n", /Line 3: a specimen begins with LM=, not with CURVES=/],
])("a text is known for TPS by its first word, even where that is the wrong one: case %#", (text, problem) => {
  if (problem) expect(() => readText(text)).toThrow(problem);
  else expect(readText(text)).toMatchObject({ kind: "shapes", choices: [{ loops: [expect.anything()] }] });
});

test("a specimen without an outline does not keep the others out, and says why", () => {
  const { choices } = readTpsShapes("LM=0\nID=a\nLM=3\n0 0\n1 0\n0 1\nID=b\nLM=3\n0 0\n-1 -1\n0 1\nID=c");
  expect(choices.map(({ name, loops, problem }) => [name, loops.length, problem?.slice(0, 16)])).toEqual([
    ["a", 0, "a has no outline"],
    ["b", 1, undefined],
    ["c", 0, "c has no outline"],
  ]);
  expect(() => readTpsShapes("LM=0\nID=a")).toThrow(/a has no outline/);
});

test("curves that go on in one another are one outline, and landmarks lie beside it", () => {
  const [choice, without] = readTpsShapes(
    `${DIGITISED.replace("LM=1\r\n4 5", "LM=4\r\n0 0\r\n4 0\r\n-1 3\r\n4 5")}`,
  ).choices;
  expect(choice.name).toBe("0");
  expect(choice.loops).toHaveLength(1);
  expect(choice.loops[0]).toHaveLength(8);
  expect(choice.marks).toMatchObject({ image: "leaf 01.jpg", scale: null });
  expect(choice.marks?.landmarks).toHaveLength(6);
  // Without curves the landmarks that are there are the outline.
  expect(without.loops[0]).toHaveLength(6);
  expect(without.marks).toMatchObject({ landmarks: new Float64Array(), scale: 0.125 });
});

/** Some bits, other ones for each k. */
function hash(k: number): bigint {
  let x = (BigInt(k) + 1n) * 0x9e3779b97f4a7c15n;
  for (const multiplier of [0xbf58476d1ce4e5b9n, 0x94d049bb133111ebn]) {
    x = BigInt.asUintN(64, x);
    x = (x ^ (x >> 30n)) * multiplier;
  }
  return BigInt.asUintN(64, x);
}
