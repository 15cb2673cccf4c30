import { expect, test } from "vitest";
import { type Shape, signedArea } from "../geometry";
import { readCsv } from "./csv";
import type { Choice, Found } from "./found";
import { readJson } from "./json";

function choices(found: Found): readonly Choice[] {
  if (found.kind !== "shapes") throw new Error(`shapes expected, not ${found.kind}`);
  return found.choices;
}

function area(shape: Shape): number {
  return shape.reduce((sum, loop) => sum + signedArea(loop), 0);
}

test.each([
  ["commas", "0,0\n2,0\n2,1\n0,1"],
  ["semicolons and decimal commas", "0;0\n2,0;0\n2;1,0\n0;1"],
  ["tabs", "0\t0\r\n2\t0\r\n2\t1\r\n0\t1\r\n"],
  ["spaces, a remark and a byte order mark", "\uFEFF# outline\n0 0\n2  0\n2 1\n0 1"],
  ["a header", "x,y\n0,0\n2,0\n2,1\n0,1"],
  ["columns by name", 'id,"y","x"\n1,0,0\n2,0,2\n3,1,2\n4,1,0'],
  ["tabs and decimal commas", "x\ty\n0\t0\n2,0\t0\n2\t1,0\n0\t1"],
  ["tabs, commas before them", "0,\t0\n2,\t0\n2,\t1\n0,\t1"],
  ["numbers in quotes, a byte order mark", '\uFEFF"x";"y"\r\n"0";"0"\r\n"2,0";"0"\r\n"2";"1"\r\n"0";"1"\r\n'],
  ["units in its header", "x [mm],y [mm]\n0,0\n2,0\n2,1\n0,1"],
  ["nothing after each last comma", "0,0,\n2,0,\n2,1,\n0,1,"],
  ["the names of rows, as R writes them", '"","x","y"\n"1",0,0\n"2",2,0\n"3",2,1\n"4",0,1'],
  ["the first point again at the end", "0,0\n2,0\n2,1\n0,1\n0,0"],
])("a table with %s", (_, text) => {
  expect(area(choices(readCsv(text))[0].loops)).toBeCloseTo(2, 5);
});

test.each([
  ["one; two", 'shape;x;y\n"one; two";0,5;0\n"one; two";2,5;0\n"one; two";2,5;2'],
  ["one, two", 'shape;x;y\n"one, two";0,5;0\n"one, two";2,5;0\n"one, two";2,5;2'],
  ["a;b", 'shape,x,y\n"a;b",0,0\n"a;b",2,0\n"a;b",2,2'],
  ["one two", '"shape"\t"x"\t"y"\n"one two"\t0\t0\n"one two"\t2\t0\n"one two"\t2\t2'],
  ['say "a, b"', 'shape,x,y\n"say ""a, b""",0,0\n"say ""a, b""",2,0\n"say ""a, b""",2,2'],
])("what stands in quotes is a name, whatever separates: %s", (name, text) => {
  const [choice] = choices(readCsv(text));
  expect(choice.name).toBe(name);
  expect(area(choice.loops)).toBeCloseTo(2, 5);
});

test("a shape that is none does not keep the others of its list out, and says why", () => {
  const table = "shape,x,y\na,0,0\na,1,0\nb,0,0\nb,2,0\nb,2,1";
  expect(choices(readCsv(table)).map(({ name, problem }) => [name, problem])).toEqual([
    ["a", "Loop 1 of a has 2 points; a closed curve needs at least three."],
    ["b", undefined],
  ]);
  const list = [
    { name: "a" },
    [
      [0, 0],
      [1, 0],
      [0, 1],
    ],
  ];
  expect(choices(readJson(JSON.stringify(list))).map(({ problem }) => problem)).toEqual([
    expect.stringContaining("a has no points"),
    undefined,
  ]);
});

test("blank lines and a column called loop tell loops apart; inner ones are holes", () => {
  const outer = "0,0\n9,0\n9,9\n0,9";
  expect(area(choices(readCsv(`${outer}\n\n3,3\n6,3\n6,6\n3,6\n`))[0].loops)).toBeCloseTo(72, 3);
  const named = "loop,x,y\n0,0,0\n0,9,0\n0,9,9\n0,0,9\n1,3,3\n1,6,3\n1,6,6\n1,3,6";
  expect(area(choices(readCsv(named))[0].loops)).toBeCloseTo(72, 3);
});

test.each([
  ["1,2\n3,four\n5,6", /Line 2: “four” is not a number/],
  ["1,2\n3\n5,6", /Line 2 has only one number/],
  ["a,b,c\n1,2,3", /Line 1 names 3 columns/],
  ["1,2,3\n4,5,6", /Line 1 has 3 numbers, and no line before names x and y/],
  ["0,5 0,5\n1,5 0,5", /Line 1 has 3 numbers.* decimal commas need semicolons/],
  ["0,0 1,0 1,1", /Line 1 has 4 numbers/],
  ['x,y\n"1,000",2', /Line 2: “"1,000"” is not a number/],
  ['shape,x,y\n"a\nb",0,0', /Line 2 has only one number/],
  ["1,2\n3,4", /has 2 points; a closed curve needs at least three/],
  ["1,1\n2,2\n3,3", /enclose no area/],
  ["1e200,0\n2e200,0\n2e200,1e200", /too large or too small to be computed with/],
  ["0,0\n1e-200,0\n0,1e-200", /too large or too small to be computed with/],
  ["\n\n", /holds no points/],
])("a table is refused with its line: %j", (text, message) => {
  expect(() => readCsv(text)).toThrow(message);
});

test("a list of named polygons gives a choice of each, placed where it says", () => {
  const leaf = {
    name: "leaf",
    class: "oak",
    points: [
      [0.2, 0.2],
      [0.8, 0.2],
      [0.5, 0.8],
    ],
  };
  const far = {
    name: "far",
    points: [
      [10, 10],
      [20, 10],
      [20, 30],
    ],
  };
  const found = choices(readJson(JSON.stringify([leaf, far])));
  expect(found.map(({ name, placed }) => [name, placed])).toEqual([
    ["leaf", true],
    ["far", false],
  ]);
  expect(area(found[0].loops)).toBeCloseTo(0.18, 5);
  expect(area(found[1].loops)).toBeCloseTo(100, 3);
});

test.each([
  ["bare points", "[[0,0],[2,0],[2,1],[0,1]]"],
  ["bare loops", "[[[0,0],[2,0],[2,1],[0,1]]]"],
  ["one polygon", '{"name":"p","points":[[0,0],[2,0],[2,1],[0,1]]}'],
])("JSON of %s", (_, text) => {
  expect(area(choices(readJson(text))[0].loops)).toBeCloseTo(2, 5);
});

test.each([
  ['{"name": "x"', /The JSON is broken/],
  ["[]", /list in the JSON is empty/],
  ['[{"name":"a","points":[[0,0],[1,"2"],[3,4]]}]', /Point 2 of a is not \[x, y\]/],
  ['[{"name":"a"}]', /a has no points; the JSON should be/],
  ['{"type":"Topology","objects":{}}', /TopoJSON/],
])("JSON is refused with a reason: %s", (text, message) => {
  expect(() => readJson(text)).toThrow(message);
});

const square = (left: number, low: number, size: number) => [
  [
    [left, low],
    [left + size, low],
    [left + size, low + size],
    [left, low + size],
    [left, low],
  ],
];

test("GeoJSON areas are those on the sphere, wherever they lie", () => {
  for (const [left, low] of [
    [10, 0],
    [10, 60],
    [177, -20],
    [-120, -80],
  ]) {
    // Edges along a parallel need points between their ends: they are no great circles.
    const steps = Array.from({ length: 60 }, (_, k) => (k / 60) * 6);
    const ring = [
      ...steps.map((s) => [left + s, low]),
      ...steps.map((s) => [left + 6, low + s]),
      ...steps.map((s) => [left + 6 - s, low + 6]),
      ...steps.map((s) => [left, low + 6 - s]),
    ].map(([longitude, latitude]) => [longitude > 180 ? longitude - 360 : longitude, latitude]);
    const [{ loops }] = choices(readJson(JSON.stringify({ type: "Polygon", coordinates: [ring] })));
    const degree = Math.PI / 180;
    const exact = 6 * degree * (Math.sin((low + 6) * degree) - Math.sin(low * degree));
    expect(area(loops) / exact).toBeCloseTo(1, 4);
  }
});

test("features have their names, multipolygons all their parts and holes", () => {
  const hole = [square(0, 0, 9)[0], square(3, 3, 3)[0]];
  const collection = {
    type: "FeatureCollection",
    features: [
      {
        type: "Feature",
        properties: { name: "Ring" },
        geometry: { type: "MultiPolygon", coordinates: [hole, square(20, 0, 2)] },
      },
      { type: "Feature", properties: {}, geometry: { type: "Point", coordinates: [0, 0] } },
      { type: "Feature", properties: null, geometry: null },
    ],
  };
  const found = readJson(JSON.stringify(collection));
  const [ring, ...others] = choices(found);
  expect(others).toEqual([]);
  expect(ring.name).toBe("Ring");
  expect(ring.loops).toHaveLength(3);
  expect(found.kind === "shapes" && found.notes).toEqual(["Features without an area are left out: 2."]);
});

test.each([
  [
    {
      type: "LineString",
      coordinates: [
        [0, 0],
        [1, 1],
      ],
    },
    /no polygons, only points or lines/,
  ],
  [{ type: "Polygon", coordinates: square(500000, 0, 1000) }, /which are no degrees/],
  [
    {
      type: "Polygon",
      coordinates: [
        [
          ["a", 0],
          [1, 1],
          [2, 0],
        ],
      ],
    },
    /Position 1 of Feature 1 is not/,
  ],
  [{ type: "FeatureCollection" }, /features is not a list/],
])("GeoJSON is refused with a reason: %j", (content, message) => {
  expect(() => readJson(JSON.stringify(content))).toThrow(message);
});
