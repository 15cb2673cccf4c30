import { expect, test } from "vitest";
import type { Curves } from "../protocol";
import { about, type Loop, transformed } from "../shapes/geometry";
import { readCsv } from "../shapes/import/csv";
import { flattened, parsePath } from "../shapes/import/path";
import { IDENTITY } from "../shapes/import/transform";
import { PRESETS } from "../shapes/presets";
import { nearest, stretch } from "../view/along";
import { framing, seenOf, WHOLE } from "../view/framing";
import { CYCLES, type Theme } from "../view/palette";
import { csv } from "./csv";
import { fileName, type Saving, sceneAt } from "./scene";
import { svg } from "./svg";

const THEME: Theme = {
  dark: false,
  paper: "#fff",
  ink: "#000",
  muted: "#666",
  grid: "#bbb",
  frame: "#ddd",
  reference: "#00f",
  template: "#f80",
  warning: "#f00",
  cycle: CYCLES.light,
};

const [{ reference, template }] = PRESETS;

/** The reference doubled about the middle, on level 3. */
function saving(): Saving & { match: NonNullable<Saving["match"]> } {
  const doubled = [...transformed(reference, about({ x: 0.5, y: 0.5 }, 2, 0))];
  const deformation = new Float64Array(2 * 9 * 9);
  for (let node = 0; node < 81; node += 1) {
    deformation[2 * node] = 2 * ((node % 9) / 8) - 0.5;
    deformation[2 * node + 1] = 2 * (Math.floor(node / 9) / 8) - 0.5;
  }
  const curves: Curves = { reference: [...reference], template: doubled, matched: doubled };
  const status = {
    finished: true,
    stop: "Converged.",
    level: 3,
    iteration: 1,
    evaluations: 1,
    energies: { membrane: 0, bending: 0, mismatch: 0, volume: 0, pins: 0, total: 0 },
    leastDeterminant: 4,
    mismatch: { mean: 0, max: 0 },
    stretch: { mean: 2, deviation: 0 },
    cover: { mean: 0, max: 0 },
    measure: 1,
    verdict: null,
    facts: new Float64Array(0),
    backend: "cpu",
    approach: "",
  };
  return { reference, template, pins: [], settings: {}, bandwidth: 0.05, match: { status, deformation, curves } };
}

test("the table has a line for every point of the reference, with what a doubling does to it", () => {
  const { curves } = saving().match;
  const [header, ...lines] = csv(curves).trimEnd().split("\n");
  expect(header).toBe("loop,x,y,phi_x,phi_y,arc_length,stretch,distance");
  expect(lines).toHaveLength(reference.reduce((sum, loop) => sum + loop.length / 2, 0));
  for (const line of lines) {
    const [loop, x, y, u, v, part, stretched, off] = line.split(",").map(Number);
    expect(loop).toBe(0);
    expect([u, v]).toEqual([expect.closeTo(2 * x - 0.5, 12), expect.closeTo(2 * y - 0.5, 12)]);
    expect(part).toBeGreaterThanOrEqual(0);
    expect(part).toBeLessThan(1);
    expect(stretched).toBeCloseTo(2, 12);
    expect(off).toBeCloseTo(0, 12);
  }
});

test("the table can be imported as the reference it lists", () => {
  const found = readCsv(csv(saving().match.curves));
  if (found.kind !== "shapes") throw new Error("shapes expected");
  const [imported] = found.choices;
  expect(imported.placed).toBe(true);
  expect(hausdorff(imported.loops[0], reference[0])).toBeLessThan(1e-6);
});

test("distances are to edges, not only to points", () => {
  const square = [Float64Array.of(0, 0, 1, 0, 1, 1, 0, 1)];
  expect(nearest(square, 0.5, -0.25)?.distance).toBeCloseTo(0.25);
  expect(nearest(square, 2, 2)?.distance).toBeCloseTo(Math.SQRT2);
  expect(stretch(square[0], transformed(square, about({ x: 0, y: 0 }, 3, 1))[0], 2)).toBeCloseTo(3);
});

test("shapes in the drawing are those of the page to a thousandth of a cell", () => {
  const drawing = svg(sceneAt(saving(), 1), WHOLE, THEME);
  for (const [side, shape] of Object.entries({ reference, template, matched: saving().match.curves.matched })) {
    const data = new RegExp(`<path data-side="${side}" d="([^"]*)"`).exec(drawing)?.[1] ?? "";
    const loops = flattened(parsePath(data), IDENTITY, 1e-3).map(({ points }) => points);
    expect(loops).toHaveLength(shape.length);
    loops.forEach((loop, l) => {
      const back = loop.map((value, i) => (i % 2 === 0 ? value / 1000 : 1 - value / 1000));
      expect(hausdorff(back, shape[l])).toBeLessThan(1 / 128_000);
    });
  }
});

test("the drawing has the deformed grid, partners and the colours of the arc length", () => {
  const drawing = svg(sceneAt(saving(), 1), WHOLE, THEME);
  const grid = /id="grid" d="([^"]*)"/.exec(drawing)?.[1] ?? "";
  // Nine lines either way; the first begins where the lower left corner goes: (−½, −½), y down.
  expect(grid.match(/M/g)).toHaveLength(18);
  expect(grid.startsWith("M-500 1500L")).toBe(true);
  expect(new Set(drawing.match(/stroke="rgb[^"]*"/g)).size).toBeGreaterThan(100);
  expect(drawing).toContain('<g id="partners"');
  expect(drawing).not.toMatch(/NaN|undefined|Infinity/);
});

test("halfway through the morph a doubling has grown by the root of two", () => {
  const drawing = svg(sceneAt(saving(), 0.5), WHOLE, THEME);
  const corner = Math.round(1e6 * (0.5 - Math.SQRT1_2)) / 1000;
  expect(/id="grid" d="([^"]*)"/.exec(drawing)?.[1].startsWith(`M${corner} ${1000 - corner}L`)).toBe(true);
});

test("without a match there is still a drawing of both shapes on the plane grid", () => {
  const drawing = svg(sceneAt({ ...saving(), match: null }, 1), WHOLE, THEME);
  expect(drawing).toContain('data-side="reference"');
  expect(drawing).toContain('data-side="template"');
  expect(drawing).not.toContain("matched");
});

test("names say what is in a file", () => {
  expect(fileName(saving(), "svg")).toBe("thinshell-match-9x9.svg");
  expect(fileName({ ...saving(), match: null }, "json")).toBe("thinshell-shapes.json");
});

function hausdorff(a: Loop, b: Loop): number {
  const oneWay = (from: Loop, to: Loop) => {
    let worst = 0;
    for (let i = 0; i < from.length; i += 2)
      worst = Math.max(worst, nearest([to], from[i], from[i + 1])?.distance ?? Number.POSITIVE_INFINITY);
    return worst;
  };
  return Math.max(oneWay(a, b), oneWay(b, a));
}

test("a drawing shows the square around the shapes, its lines as wide on paper as those of the whole box", () => {
  const square = framing(seenOf(saving()));
  expect(square.size).toBeLessThan(0.9);
  const [near, whole] = [square, WHOLE].map((seen) => svg(sceneAt(saving(), 1), seen, THEME));
  const numbers = (drawing: string) => (/viewBox="([^"]*)"/.exec(drawing)?.[1] ?? "").split(" ").map(Number);
  const [x, y, side] = numbers(near);
  expect(side).toBeCloseTo(1000 * square.size, 3);
  for (const loop of [...reference, ...template])
    for (let i = 0; i < loop.length; i += 2) {
      expect(1000 * loop[i]).toBeGreaterThan(x);
      expect(1000 * loop[i]).toBeLessThan(x + side);
      expect(1000 * (1 - loop[i + 1])).toBeGreaterThan(y);
      expect(1000 * (1 - loop[i + 1])).toBeLessThan(y + side);
    }
  const thin = (drawing: string) => Number(/id="grid" [^>]*stroke-width="([^"]*)"/.exec(drawing)?.[1]);
  expect(thin(near) / numbers(near)[2]).toBeCloseTo(thin(whole) / numbers(whole)[2], 5);
  const data = (drawing: string) => /data-side="matched" d="([^"]*)"/.exec(drawing)?.[1];
  expect(data(near)).toBe(data(whole));
});
