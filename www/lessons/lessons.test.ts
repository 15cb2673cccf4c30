/** The project's own lessons: they can be read, and what they say of their pictures is true. */

import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { build } from "vite";
import { beforeAll, expect, test } from "vitest";
import { filesOf, lessons } from "../../scripts/lib/lessons.mjs";
import { decode } from "../link/text";
import { flat } from "../shapes/pins";
import { initSync, Registration } from "../wasm/thinshell.js";
import { type Check, evaluate } from "./checks";
import { allLessons } from "./files";
import { knownFrom } from "./frame";

const LESSONS = allLessons(filesOf("docs/lessons"));
const STEPS = LESSONS.flatMap((lesson) =>
  lesson.steps.map((step, index) => ({ place: `${lesson.id}/${index + 1}`, step })),
);

beforeAll(() => {
  initSync({ module: readFileSync("www/wasm/thinshell_bg.wasm") });
});

/** Which of the checks do not hold for the match of a state. */
async function failing(state: string, checks: readonly Check[], given: string): Promise<readonly unknown[]> {
  const { reference, template, pins, settings } = decode(state);
  const [first, second] = [reference, template].map((loops) => ({ kind: "curves" as const, loops: [...loops] }));
  const registration = await Registration.create(first, second, { ...settings, pins: flat(pins) });
  try {
    let status = await registration.step(20);
    while (!status.finished) status = await registration.step(20);
    const known = knownFrom(state, given, status, (point) => {
      const [x, y] = registration.map(Float64Array.from(point));
      return [x, y];
    });
    return checks.map((check) => ({ ...check, ...evaluate(check, known) })).filter(({ holds }) => !holds);
  } finally {
    registration.free();
  }
}

test("there are at least eight lessons, of the subjects that a course needs", () => {
  expect(LESSONS.map(({ id }) => id)).toEqual([
    "registration",
    "distance",
    "stretch",
    "bending",
    "plane",
    "crumpling",
    "descent",
    "coarse",
    "surfaces",
  ]);
});

test("every step asks for a prediction or sets a task, and every lesson has notes for the teacher", () => {
  expect(STEPS.filter(({ step }) => !step.predict && !step.task).map(({ place }) => place)).toEqual([]);
  expect(LESSONS.filter(({ notes }) => !notes).map(({ id }) => id)).toEqual([]);
  expect(LESSONS.filter(({ steps }) => !steps.some(({ task }) => task)).map(({ id }) => id)).toEqual(["surfaces"]);
});

test("a link to a lesson or a state that is not there is a mistake, with its file and line", () => {
  const folder = mkdtempSync(join(tmpdir(), "thinshell-lessons-"));
  const file = join(folder, "03-stretch.md");
  const text = readFileSync("docs/lessons/03-stretch.md", "utf8");
  const to = (address: string) => {
    writeFileSync(file, text.replace("./experiments.html", address));
    return () => allLessons([file]);
  };
  try {
    const line = text.slice(0, text.indexOf("./experiments.html")).split("\n").length;
    for (const address of [
      "./lessons.html#alchemy",
      "./index.html#v=2&preset=sun",
      "./index.html#space=1&reference=egg",
    ])
      expect(to(address)).toThrow(`03-stretch.md:${line}: the link leads to “${address}”`);
    for (const address of ["./lessons.html#stretch/6", "./index.html#v=2&preset=star", "./index.html"])
      expect(to(address)).not.toThrow();
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test("a mistake in a lesson fails the build, which names its file and line", async () => {
  const folder = mkdtempSync(join(tmpdir(), "thinshell-lessons-"));
  const text = readFileSync("docs/lessons/03-stretch.md", "utf8");
  writeFileSync(join(folder, "03-stretch.md"), text.replace(/^minutes: .*$/m, "minutes: many"));
  const line = text.slice(0, text.indexOf("\nminutes: ")).split("\n").length + 1;
  const options = { write: false, rolldownOptions: { input: "virtual:lessons" } };
  const built = build({ configFile: false, logLevel: "silent", plugins: [lessons(folder)], build: options });
  try {
    await expect(built).rejects.toThrow(`03-stretch.md:${line}: minutes is “many”, which must be a whole number`);
  } finally {
    rmSync(folder, { recursive: true });
  }
}, 30_000);

test("formulas are MathML, and bring no style of their own", () => {
  const texts = STEPS.flatMap(({ step }) => [step.title, step.html, step.predict?.question, step.predict?.answer]);
  expect(texts.join("").match(/<math/g)?.length).toBeGreaterThan(100);
  for (const text of texts) expect(text ?? "").not.toMatch(/\sstyle=|katex|<annotation|<script|\$|\uE000/);
});

test.each(STEPS.filter(({ step }) => step.holds.length > 0))(
  "what the lesson says of its picture is true: $place",
  async ({ step }) => {
    expect(await failing(step.predict?.reveal ?? step.state, step.holds, step.state)).toEqual([]);
  },
  30_000,
);

for (const { place, step } of STEPS) {
  const { task } = step;
  if (!task) continue;
  test(`the task accepts its solution, and not what the step begins with: ${place}`, async () => {
    expect(await failing(task.solution, task.checks, step.state)).toEqual([]);
    expect(await failing(step.state, task.checks, step.state)).not.toEqual([]);
  }, 30_000);
}
