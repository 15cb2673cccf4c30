/** What a disk has in store: each ends in the right files or in a sentence. */

import { existsSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { afterAll, expect, test } from "vitest";
import type { Plan } from "../www/batch/match";
import { Refusal } from "./arguments";
import { filesIn, read } from "./files";
import { Output } from "./output";

const FOLDER = mkdtempSync(join(tmpdir(), "thinshell-command-"));
afterAll(() => rmSync(FOLDER, { recursive: true }));

const at = (...names: string[]) => join(FOLDER, ...names);
mkdirSync(at("shapes", "below.svg"), { recursive: true });
mkdirSync(at("empty"));
for (const name of ["b.csv", "a.tps", "notes.md"]) writeFileSync(at("shapes", name), "0,0\n1,0\n0,1\n");
writeFileSync(at("nothing.svg"), "");
writeFileSync(at("picture.svg"), "\x89PNG\r\n\x1a\n", "latin1");

const SHAPE: Plan["reference"]["shape"] = [Float64Array.of(0.3, 0.3, 0.7, 0.3, 0.5, 0.7)];
const PLAN: Plan = {
  reference: {
    name: "reference",
    shape: SHAPE,
    box: { a: 1, b: 0, x: 0, y: 0 },
    landmarks: new Float64Array(),
    image: null,
    scale: null,
  },
  points: SHAPE[0],
  settings: {},
};

test("a folder stands for the files in it that can be read, in their order, and whatever else for itself", () => {
  const long = "x".repeat(5000);
  expect(filesIn([at("shapes"), at("absent"), at("nothing.svg", "x"), long])).toEqual([
    at("shapes", "a.tps"),
    at("shapes", "b.csv"),
    at("absent"),
    at("nothing.svg", "x"),
    long,
  ]);
});

test("a folder in which nothing can be read is refused", () => {
  expect(() => filesIn([at("empty")])).toThrow(/empty is a folder without any SVG, GeoJSON, JSON, TPS or CSV file\.$/);
  expect(() => filesIn([at("empty")])).toThrow(Refusal);
});

test.each([
  [at("absent"), "There is no such file."],
  [at("nothing.svg", "x"), "There is no such file."],
  ["x".repeat(5000), "There is no such file."],
  [at("empty"), "This is a folder; name a file in it."],
  [at("nothing.svg"), "The file is empty."],
  [at("picture.svg"), "Pictures are read by the page only; save its outline there, as SVG."],
])("what is no file of shapes is refused by a sentence: case %#", async (path, message) => {
  await expect(read(path, false)).rejects.toThrow(message);
});

test("folders are made one in another, and an old table is written over", () => {
  for (let i = 0; i < 2; i += 1) new Output(at("out", "of", "it"), PLAN, false).tables([]);
  expect(existsSync(at("out", "of", "it", "table.csv"))).toBe(true);
});

test("where nothing can be written, a sentence says why", () => {
  const output = (...names: string[]) => new Output(at(...names), PLAN, false);
  expect(() => output("nothing.svg")).toThrow(/nothing\.svg cannot be written: a file has its name\.$/);
  expect(() => output("nothing.svg", "x")).toThrow(/cannot be written: a file has its name\.$/);
  mkdirSync(at("taken", "table.csv"), { recursive: true });
  expect(() => output("taken").tables([])).toThrow(/table\.csv cannot be written: a folder has its name\.$/);
  expect(() => output("nothing.svg")).toThrow(Refusal);
});

// Node's own making of folders goes on for ever there.
test.runIf(existsSync("/proc/self"))("a system's folder that takes no other is refused", () => {
  expect(() => new Output("/proc/thinshell/matches", PLAN, false)).toThrow(/cannot be written: ENOENT\.$/);
});
