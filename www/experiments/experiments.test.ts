/** What must come out, at sizes that a test can wait for; `npm run reproduce` has the full ones. */

import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { decode } from "../link/text";
import { initSync, Registration } from "../wasm/thinshell.js";
import { crumple, RATIOS } from "./crumpling";
import { type Context, table, text } from "./experiment";
import { EXPERIMENTS } from "./index";
import { cascade, singleLevel } from "./levels";
import { linkTo } from "./link";
import { document, OF_CURVES } from "./markdown";
import { order } from "./measure";
import { descend } from "./metric";
import { matchPolygons, readPolygons } from "./polygons";
import { readDocument } from "./precomputed";
import { rotate, saddleWords } from "./rotation";
import { SHELL, strain, VOLUME, VOLUME_CORNERS } from "./strain";
import { escaped, windowOf } from "./svg";

initSync({ module: readFileSync(new URL("../wasm/thinshell_bg.wasm", import.meta.url)) });

const context: Context = { solver: Registration, millis: () => performance.now(), progress: () => {} };
const MINUTE = 60_000;

describe("numbers and letters", () => {
  it("have a true minus, in what runs write, in figures and in what is kept of them", () => {
    expect(text("Between", "-0.3 and (-2) of 2D-like, 3-4 parts.")).toMatchObject({
      text: "Between −0.3 and (−2) of 2D-like, 3-4 parts.",
    });
    expect(table(["a"], [["-0.1 %", "det -3"]])).toMatchObject({ rows: [["−0.1 %", "det −3"]] });
    expect(escaped("excess -0.1 %")).toBe("excess −0.1 %");
    for (const name of ["paper", "surfaces"]) {
      const kept = [...readDocument(readFileSync(new URL(`../../docs/${name}.md`, import.meta.url), "utf8")).values()];
      expect(JSON.stringify(kept)).not.toMatch(/[\s("]-\d/);
    }
  });

  it("have their indices below the line", () => {
    expect(escaped("α_bend = 0 < 1")).toBe(
      'α<tspan dy="3" font-size="9">bend</tspan><tspan dy="-3"> = 0 &lt; 1</tspan>',
    );
  });
});

describe("what is kept", () => {
  it("is of one run: the figures' numbers are the tables'", () => {
    const kept = (path: string) => readFileSync(new URL(`../../docs/${path}`, import.meta.url), "utf8");
    const paper = kept("paper.md");
    const notes = (figure: string, note: RegExp) => [...kept(`figures/${figure}.svg`).matchAll(note)].map(([, n]) => n);
    const found = [...notes("crumpling", />excess ([^<]+)</g), ...notes("rotation", />found ([^<]+)</g)];
    expect(found.length).toBeGreaterThan(8);
    for (const number of found) expect(paper).toMatch(new RegExp(`\\| ${number.replace(".", "\\.")} [(|]`));
  });
});

describe("Table 1", () => {
  it("the shell's deviation falls by 1.8 to 2.2 per level from 65² on", { timeout: MINUTE }, async () => {
    const rows = await strain(context, SHELL, 8);
    expect(rows.map(({ level }) => level)).toEqual([5, 6, 7, 8]);
    for (let i = 2; i < rows.length; i += 1) {
      const factor = 2 ** order(rows[i - 1].deviation, rows[i].deviation);
      expect(factor).toBeGreaterThan(1.8);
      expect(factor).toBeLessThan(2.2);
    }
    expect(rows.at(-1)?.mismatch).toBeLessThan(0.5);
  });

  it("volume energy alone stays flat within 20 % from 65² on", { timeout: MINUTE }, async () => {
    const deviations = (await strain(context, VOLUME, 8)).slice(1).map(({ deviation }) => deviation);
    const mean = deviations.reduce((sum, value) => sum + value, 0) / deviations.length;
    for (const deviation of deviations) expect(Math.abs(deviation / mean - 1)).toBeLessThan(0.2);
    expect(mean).toBeGreaterThan(0.5);
  });

  it("volume energy with corners reaches the ellipse, as unevenly on every level", { timeout: MINUTE }, async () => {
    for (const { mean, deviation, mismatch } of await strain(context, VOLUME_CORNERS, 7)) {
      expect(Math.abs(mean / 2.38 - 1)).toBeLessThan(0.02);
      expect(mismatch).toBeLessThan(0.5);
      expect(deviation).toBeGreaterThan(0.5);
    }
  });
});

describe("Fig. 5", () => {
  it("a circle matched with one of half its size is more than 30 % too long", { timeout: MINUTE }, async () => {
    expect((await crumple(context, 2, "bare")).excess).toBeGreaterThan(0.3);
    expect((await crumple(context, 2, "bent")).excess).toBeGreaterThan(0.3);
  });

  it("projected compression and the defaults leave it at most 3 % too long", { timeout: MINUTE }, async () => {
    for (const way of ["projected", "defaults"] as const)
      for (const ratio of RATIOS) expect(Math.abs((await crumple(context, ratio, way)).excess)).toBeLessThan(0.03);
  });

  it("a circle matched with one hardly smaller shrinks without waves", { timeout: MINUTE }, async () => {
    expect(Math.abs((await crumple(context, 1.2, "bent")).excess)).toBeLessThan(0.01);
  });
});

describe("Fig. 6", () => {
  for (const minimizer of ["newton", "ncg"] as const)
    it(`bending finds rotations to half a degree (${minimizer})`, { timeout: 3 * MINUTE }, async () => {
      for (const angle of [15, 30, 40]) {
        const { found, end } = await rotate(context, angle, 6, { bending: 1, minimizer });
        expect(Math.abs(found - angle)).toBeLessThan(0.5);
        expect(end.status.mismatch.max).toBeLessThan(0.5);
      }
    });

  it("without bending either minimiser reaches the template, but not the rotation", { timeout: MINUTE }, async () => {
    for (const minimizer of ["newton", "ncg"] as const) {
      const { found, end } = await rotate(context, 30, 6, { bending: 0, minimizer });
      expect(end.status.mismatch.max).toBeLessThan(0.5);
      expect(found).toBeLessThan(27);
    }
  });
});

describe("the cascade", () => {
  it("comes closer level by level, with fewer iterations on the finest than that level takes alone", {
    timeout: MINUTE,
  }, async () => {
    const levels = await cascade(context, 6);
    const means = levels.map(({ status }) => status.mismatch.mean / 2 ** status.level);
    expect(means.length).toBe(3);
    for (let i = 1; i < means.length; i += 1) expect(means[i]).toBeLessThan(means[i - 1]);
    const alone = await singleLevel(context, 6, { thickness: 0.125, penalty: 4e3 });
    // Both find the same match where the hessian sees folding corners; alone it takes three times as many iterations.
    expect(Math.abs(alone.status.energies.total / levels[2].status.energies.total - 1)).toBeLessThan(1e-3);
    expect(alone.status.iteration).toBeGreaterThan(2 * levels[2].status.iteration);
  });
});

describe("the metric", () => {
  it("Newton needs fewer iterations than a Sobolev gradient, and that fewer than L²", { timeout: MINUTE }, async () => {
    const runs = [];
    for (const settings of [{}, { minimizer: "ncg", sobolev: 0.5 }, { minimizer: "ncg", sobolev: 0 }] as const)
      runs.push(await descend(context, 5, settings));
    const least = Math.min(...runs.map(({ end }) => end.status.energies.total));
    const [newton, sobolev, plain] = runs.map(({ moments }) =>
      moments.findIndex(({ energy }) => energy < least * (1 + 1e-3)),
    );
    expect(newton).toBeGreaterThanOrEqual(0);
    expect(newton).toBeLessThan(sobolev);
    // −1: not reached at all.
    expect(plain < 0 || plain > sobolev).toBe(true);
    expect(sobolev).toBeGreaterThanOrEqual(0);
  });
});

describe("polygon files", () => {
  const square = [
    [0.3, 0.3],
    [0.7, 0.3],
    [0.7, 0.7],
    [0.3, 0.7],
  ];

  it("are refused with the place and the reason", () => {
    expect(() => readPolygons("{")).toThrow("not JSON");
    expect(() => readPolygons("[]")).toThrow("at least two");
    expect(() => readPolygons(JSON.stringify([{ points: square }, { points: [[0, 1]] }]))).toThrow("polygon 2");
    expect(() => readPolygons(JSON.stringify([{ points: square }, null]))).toThrow("polygon 2");
  });

  it("become a table with a row a pair", { timeout: MINUTE }, async () => {
    const circle = Array.from({ length: 64 }, (_, i) => [
      0.5 + 0.25 * Math.cos((Math.PI * i) / 32),
      0.5 + 0.25 * Math.sin((Math.PI * i) / 32),
    ]);
    const file = JSON.stringify([{ name: "square", points: square, narrowest_h: 50 }, { points: circle }]);
    const blocks = await matchPolygons(context, readPolygons(file));
    const [row] = blocks.flatMap((block) => (block.kind === "table" ? block.rows : []));
    expect(row.slice(0, 3)).toEqual(["square", "shape 2", "50.0 / –"]);
    expect(row.at(-1)).toBe("yes");
  });
});

describe("the words of Fig. 6", () => {
  const end = (found: number, match: number) => ({ found, energies: { match, rotation: 0.004 } });

  it("name one grid once, and both where there are two", () => {
    const ends = [end(44.5, 0.004), end(10, 0.007)];
    expect(saddleWords(ends, { newton: 6, ncg: 6 }).match(/0\.00400000 on/g)).toHaveLength(1);
    expect(saddleWords(ends, { newton: 7, ncg: 6 })).toContain("0.00400000 on 129² and 0.00400000 on 65²");
  });

  it("say only of ends above the rotation that corners were caught half way", () => {
    const finest = { newton: 6, ncg: 6 };
    expect(saddleWords([end(44.5, 0.004), end(44.5, 0.004)], finest)).toContain("neither end lies above it");
    expect(saddleWords([end(44.5, 0.004), end(10, 0.007)], finest)).toContain(
      "the gradient method's end lies above it",
    );
    expect(saddleWords([end(3, 0.005), end(44, 0.004)], finest)).toContain("Newton's end lies above it");
    expect(saddleWords([end(3, 0.005), end(10, 0.007)], finest)).toContain("both ends lie above it");
  });
});

describe("figures", () => {
  it("show the curves, all panels the same part of the plane", () => {
    const loop = Float64Array.of(0.4, 0.5, 0.6, 0.5, 0.6, 0.55);
    const window = windowOf([
      { title: "", reference: [loop] },
      { title: "", matched: [loop.map((v) => v + 0.1)] },
    ]);
    expect(window.side).toBeCloseTo(0.3 * 1.24, 12);
    expect(window.left + window.side / 2).toBeCloseTo(0.55, 12);
    expect(windowOf([{ title: "" }])).toEqual({ left: 0, bottom: 0, side: 1 });
  });
});

describe("every experiment", () => {
  it.each(EXPERIMENTS.map((experiment) => [experiment.id, experiment] as const))(
    "opens in the page: %s",
    (_, { example }) => {
      const link = linkTo(example());
      const saved = decode(link);
      expect(saved.reference.length + saved.template.length).toBeGreaterThanOrEqual(2);
      expect(saved.settings.align).toBe("none");
      expect(link.length).toBeLessThan(4000);
    },
  );
});

describe("the document", () => {
  it("is read back as the blocks that it was written from", () => {
    const blocks = [
      { kind: "table", head: ["", "b"], rows: [["1", "x|y"]] },
      { kind: "figure", name: "curve", svg: "", caption: "A curve." },
      { kind: "text", text: "A sentence. Another one." },
    ] as const;
    const read = readDocument(
      document(
        OF_CURVES,
        EXPERIMENTS.map((experiment) => ({ ...experiment, blocks })),
      ),
    );
    for (const { title } of EXPERIMENTS) expect(read.get(title)).toEqual(blocks);
  });

  it("has every experiment's table and names every figure's file", () => {
    const figure = { kind: "figure", name: "curve", svg: "<svg/>", caption: "A curve." } as const;
    const rows = { kind: "table", head: ["a", "b"], rows: [["1", "x|y"]] } as const;
    const text = document(
      OF_CURVES,
      EXPERIMENTS.map((experiment) => ({ ...experiment, blocks: [rows, figure] })),
    );
    for (const { title, paper, setup } of EXPERIMENTS)
      for (const part of [`## ${title}\n`, paper, setup]) expect(text).toContain(part);
    expect(text).toContain("| a | b |\n| --- | --- |\n| 1 | x\\|y |");
    expect(text).toContain("![A curve.](figures/curve.svg)");
  });
});
