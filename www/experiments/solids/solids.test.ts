/** What must come out with surfaces, at sizes that a test can wait for; `npm run reproduce` has the full ones. */

import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { SURFACES } from "../../space/gallery";
import { decode } from "../../space/link";
import { picture } from "../../space/picture";
import { png } from "../../space/png";
import { initSync, Registration } from "../../wasm-solid/thinshell.js";
import type { Context } from "../experiment";
import { document, OF_SURFACES } from "../markdown";
import { readDocument } from "../precomputed";
import { SOLID_EXPERIMENTS } from "./index";
import { linkToSpace } from "./link";
import { errors, layerRatio, shiftFound, turnFound } from "./measure";
import { bumpy, sphere, turnedOctahedron } from "./shapes";
import { law, RADIUS, RATIO, SHELL, sphereRatios } from "./spheres";
import { fittedTogether, judge, twisted } from "./truth";
import { turn } from "./turn";

initSync({ module: readFileSync(new URL("../../wasm-solid/thinshell_bg.wasm", import.meta.url)) });

const context: Context = { solver: Registration, millis: () => performance.now(), progress: () => {} };
const MINUTES = 240_000;

describe("measures", () => {
  it("find a turn and a shift that are there", () => {
    const [before, after] = [turnedOctahedron(0).positions, turnedOctahedron(20).positions];
    expect(turnFound(before, after)).toBeCloseTo(20, 6);
    const shifted = before.map((at, k) => (k % 3 === 0 ? at + 0.03 : at));
    expect(shiftFound(before, shifted, 0.1)).toBeCloseTo(0.03, 12);
    expect(errors(before, shifted).mean).toBeCloseTo(0.03, 12);
  });

  it("see the area ratio of a map that is known", () => {
    const level = 5;
    const side = 2 ** level + 1;
    const doubled = Float64Array.from({ length: 3 * side ** 3 }, (_, k) => {
      const node = Math.floor(k / 3);
      return (2 * [node % side, Math.floor(node / side) % side, Math.floor(node / side ** 2)][k % 3]) / (side - 1);
    });
    const { mean, deviation } = layerRatio(level, doubled, 0.2);
    expect(mean).toBeCloseTo(4, 9);
    expect(deviation).toBeLessThan(1e-6);
    // Radially stretched as the law supposes: r + s goes to R + s.
    const far = RADIUS * (Math.sqrt(RATIO) - 1);
    const law5 = layerRatio(
      level,
      doubled.map((at, k) => {
        const x = at / 2 - 0.5;
        const first = k - (k % 3);
        const length = Math.hypot(...[0, 1, 2].map((axis) => doubled[first + axis] / 2 - 0.5));
        return 0.5 + x * (1 + far / Math.max(length, 1e-9));
      }),
      RADIUS,
    );
    expect(law5.mean / RATIO).toBeGreaterThan(0.95);
    expect(law5.mean / RATIO).toBeLessThan(1.1);
    expect(law5.deviation / law(level)).toBeGreaterThan(0.8);
    expect(law5.deviation / law(level)).toBeLessThan(1.3);
  });

  it("refuse meshes of unlike numbering, and fit both alike", () => {
    const [one, other] = [sphere(0.2), sphere(0.1)];
    const [large, small] = fittedTogether(one, other);
    expect(Math.max(...large.positions)).toBeCloseTo(0.86, 6);
    expect(Math.max(...small.positions)).toBeCloseTo(0.68, 6);
    expect(() => fittedTogether(one, { ...other, positions: other.positions.slice(3) })).toThrow("vertices");
  });
});

describe("pictures", () => {
  it("are PNGs of what is in front, clear around it", async () => {
    const { positions, indices } = sphere(0.25);
    const address = await picture({ positions, indices, places: positions }, 40);
    const bytes = Buffer.from(address.replace("data:image/png;base64,", ""), "base64");
    expect([...bytes.subarray(1, 4)].map((code) => String.fromCharCode(code)).join("")).toBe("PNG");
    expect([bytes.readUInt32BE(16), bytes.readUInt32BE(20)]).toEqual([40, 40]);
    const clear = await png(40, 40, new Uint8Array(4 * 40 * 40));
    expect(address.length).toBeGreaterThan(3 * clear.length);
  });
});

describe("Fig. 6", () => {
  it("bending finds a turn by 30° to half a degree, nothing finds it without", { timeout: MINUTES }, async () => {
    const { found, end } = await turn(context, 30, 5, { bending: 1 });
    expect(Math.abs(found - 30)).toBeLessThan(0.5);
    expect(end.status.mismatch.max).toBeLessThan(0.5);
    expect(Math.abs((await turn(context, 30, 5, { bending: 0 })).found - 30)).toBeGreaterThan(5);
  });
});

describe("Table 1", () => {
  it("has the law's deviation on spheres", { timeout: MINUTES }, async () => {
    const [row] = await sphereRatios(context, SHELL, 4);
    expect(row.deviation / law(4)).toBeGreaterThan(0.7);
    expect(row.deviation / law(4)).toBeLessThan(1.6);
    expect(row.mismatch).toBeLessThan(0.5);
  });
});

describe("a known correspondence", () => {
  it("is met better than by the identity, even on the coarsest grid", { timeout: MINUTES }, async () => {
    const { before, after } = await judge(context, bumpy(), bumpy(twisted), 4);
    expect(after.mean).toBeLessThan(0.8 * before.mean);
  });
});

describe("every experiment with surfaces", () => {
  it.each(SOLID_EXPERIMENTS.map((experiment) => [experiment.id, experiment] as const))(
    "opens in the page: %s",
    (_, { example }) => {
      const { reference, template, settings } = decode(linkToSpace(example));
      expect([reference, template]).toEqual([example.reference, example.template]);
      for (const id of [reference, template]) expect(SURFACES.map((entry) => entry.id)).toContain(id);
      expect(settings.align).toBe(example.settings.align);
    },
  );

  it("has its chapter in the document", () => {
    const blocks = [{ kind: "text", text: "A sentence." }] as const;
    const read = readDocument(
      document(
        OF_SURFACES,
        SOLID_EXPERIMENTS.map((experiment) => ({ ...experiment, blocks })),
      ),
    );
    for (const { title } of SOLID_EXPERIMENTS) expect(read.get(title)).toEqual(blocks);
  });

  it("is kept in the document that the page opens with", () => {
    const kept = readDocument(readFileSync("docs/surfaces.md", "utf8"));
    for (const { title } of SOLID_EXPERIMENTS) expect(kept.get(title)?.length).toBeGreaterThan(0);
  });
});
