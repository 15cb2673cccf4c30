/** A lesson's file is read as it is written; every kind of mistake is found with its line. */

import { expect, test } from "vitest";
import { type Mistakes, readLesson } from "./read";

const HEAD = `---
lesson: A title
about: One sentence.
minutes: 10
---
Notes for the *teacher*.
`;

const PLAIN = `---
step: Plain
state: v=2&preset=star
---
Text.
`;

const TASK = `---
step: A task, with $l = 1$
show: full
controls: match,view
sliders: bending
state: v=2&preset=star
check: stretch.deviation < 0.05
check: pins >= 1
solution: v=2&preset=star&bending=0
holds: mismatch.max < 0.5
---
Some *text* with $l^2$.

## Do
Do it.

## For the teacher
A hint.
`;

const PREDICTION = `---
step: A prediction
show: compare
b: bending:0
state: v=2&preset=star&match=later
reveal: v=2&preset=star
---
See [the experiments](./experiments.html).

## Predict
What?

## Answer
That: $$a = b$$
`;

const GOOD = HEAD + TASK + PREDICTION + PLAIN + PLAIN.replace("Plain", "Another") + PLAIN.replace("Plain", "Last");
const PATH = "docs/lessons/03-example.md";
const isKnown = (address: string) => address === "./experiments.html";

test("a lesson is read as it is written", () => {
  const lesson = readLesson(PATH, GOOD, isKnown);
  expect(lesson).toMatchObject({ id: "example", title: "A title", about: "One sentence.", minutes: 10 });
  expect(lesson.notes).toBe("<p>Notes for the <em>teacher</em>.</p>");
  const [task, prediction, plain] = lesson.steps;
  expect(task.title).toContain("<math");
  expect(task.frame).toBe("embed=full&controls=match%2Cview&sliders=bending");
  expect(task.task?.checks).toEqual([
    { kind: "number", name: "stretch.deviation", sign: "<", value: 0.05 },
    { kind: "pins", sign: ">=", value: 1 },
  ]);
  expect(task.notes).toBe("<p>A hint.</p>");
  expect(prediction.predict?.reveal).toBe("v=2&preset=star");
  expect(prediction.predict?.answer).toContain('<math display="block" tabindex="0">');
  expect(plain).toMatchObject({ predict: null, task: null, notes: null, frame: "embed=result", holds: [] });
});

test("powers are letters of the line, and nothing floats above it", () => {
  const lesson = readLesson(PATH, GOOD.replace("Plain", "$D^2 d_1^2 + (D\\varphi)^{\\mathsf T} h^{-3}$"), isKnown);
  const [, , { title }] = lesson.steps;
  for (const power of ["²", "ᵀ", "⁻³"]) expect(title).toContain(`<mtext>${power}</mtext>`);
  expect(title).not.toMatch(/<msup|<msubsup/);
});

test("carriage returns, as some editors write them, make no difference", () => {
  expect(readLesson(PATH, GOOD.replaceAll("\n", "\r\n"), isKnown)).toEqual(readLesson(PATH, GOOD, isKnown));
});

test("a lesson of surfaces is read", () => {
  const solid = GOOD.replace("step: Plain\nstate: v=2&preset=star", "step: Plain\nstate: space=1&reference=torus");
  expect(readLesson(PATH, solid, isKnown).steps[2].state).toBe("space=1&reference=torus");
});

/** The text that is replaced, what it becomes, the line of the mistake, and what is said of it. */
type Case = readonly [was: string, becomes: string, line: number, words: RegExp];

const CASES: readonly Case[] = [
  // The form of the file.
  ["---\nlesson", "lesson", 1, /begins with a line of three dashes/],
  ["minutes: 10\n---\n", "minutes: 10\n", 5, /“Notes for the \*teacher\*.” is not like name: value/],
  ["lesson: A title", "lesson A title", 2, /“lesson A title” is not like name: value/],
  ["lesson: A title", "lesson:", 2, /lesson: is missing here/],
  ["lesson: A title\n", "", 1, /lesson: is missing here/],
  ["about: One sentence.\n", "", 1, /about: is missing/],
  ["minutes: 10", "minutes: ten", 4, /minutes is “ten”, which must be a whole number/],
  ["minutes: 10", "minutes: 10\ncolour: red", 5, /a lesson has no “colour”; it has lesson, about, minutes/],
  ["minutes: 10", "minutes: 10\nminutes: 11", 5, /minutes stands here twice/],
  ["step: Plain\n", "", 39, /step: is missing here/],
  ["step: Plain", "step: Plain\ncolour: red", 41, /a step has no “colour”/],
  // What the frame shows.
  ["state: v=2&preset=star\ncheck", "check", 7, /state: is missing here/],
  ["state: v=2&preset=star\ncheck", "state: v=2&preset=sun\ncheck", 12, /no example called “sun”/],
  ["state: v=2&preset=star\ncheck", "state: http://x.org\ncheck", 12, /it is no link of this page/],
  ["reveal: v=2&preset=star", "reveal: v=9", 30, /version “9” is not known/],
  ["solution: v=2", "solution: v=2&finest=99", 15, /finest|Finest/],
  ["show: full", "show: everything", 9, /embed=everything, which must be one of result, compare, full/],
  ["controls: match,view", "controls: match,erase", 10, /“erase”; there are view/],
  ["sliders: bending", "sliders: colour", 11, /the setting “colour”/],
  ["b: bending:0", "b: bending", 28, /the change “bending”/],
  ["show: compare\n", "", 27, /b is for show: compare/],
  ["state: v=2&preset=star&match=later", "state: space=1", 29, /surfaces cannot be compared side by side/],
  ["step: Plain\nstate: v=2&preset=star", "step: Plain\nstate: space=1&reference=egg", 41, /no surface “egg”/],
  // Conditions.
  ["stretch.deviation <", "stretch.devotion <", 13, /there is no number “stretch.devotion”; there are stretch.mean/],
  ["deviation < 0.05", "deviation ~ 0.05", 13, /“~” compares nothing/],
  ["deviation < 0.05", "deviation < little", 13, /“little” is no number/],
  ["pins >= 1", "the pins are many", 14, /is no condition/],
  ["pins >= 1", "setting colour = red", 14, /there is no setting “colour”/],
  ["pins >= 1", "setting align > none", 14, /can only be compared by =/],
  ["pins >= 1", "point 0.1 0.2 to 0.3 0.4", 14, /must be like point/],
  ["mismatch.max < 0.5", "mismatch.max <", 16, /is no condition/],
  // Texts.
  ["Some *text* with $l^2$.", "", 18, /a step has a text before/],
  ["Some *text* with $l^2$.", "Some *text* with $l^2.", 18, /a \$ is without its partner/],
  ["Some *text* with $l^2$.", "Some text,\nand $\\frac{1}$.", 19, /the formula \\frac\{1\} cannot be read/],
  ["Some *text*", "Some ![picture](a.png)", 18, /lessons have no pictures/],
  ["./experiments.html", "./nowhere.html", 32, /leads to “.\/nowhere.html”, which is not there/],
  ["## Do", "## Doing", 20, /“## Doing” is no heading of a step; there are ## Predict/],
  ["## Do", "# Do", 20, /“# Do” is no heading of a step/],
  ["## Answer", "## Predict", 37, /## Predict stands here twice/],
  ["## Answer\nThat: $$a = b$$\n", "", 34, /## Predict needs an ## Answer after it/],
  ["## Predict\nWhat?\n\n", "", 34, /## Answer needs a ## Predict before it/],
  ["check: stretch.deviation < 0.05\ncheck: pins >= 1\n", "", 18, /## Do needs a check/],
  ["solution: v=2&preset=star&bending=0\n", "", 19, /## Do needs a solution/],
  ["## Do\nDo it.\n\n", "", 13, /check needs a ## Do/],
  // The number of steps.
  [PLAIN.replace("Plain", "Last"), "", 1, /a lesson has 5 to 10 steps; this one has 4/],
];

test.each(CASES)("%j instead of %j is a mistake, at line %i", (was, becomes, line, words) => {
  expect(GOOD).toContain(was);
  const text = GOOD.replace(was, () => becomes);
  let found: Mistakes | null = null;
  try {
    readLesson(PATH, text, isKnown);
  } catch (error) {
    found = error as Mistakes;
  }
  const said = (found?.message ?? "nothing").split("\n");
  expect(said).toContainEqual(expect.stringMatching(new RegExp(`^${PATH}:${line}: `)));
  expect(said.filter((one) => one.startsWith(`${PATH}:${line}: `)).join("\n")).toMatch(words);
});

test("a file that ends within a block is a mistake, where the block begins", () => {
  expect(() => readLesson(PATH, `${GOOD}---\nstep: Cut off\n`, isKnown)).toThrow(
    /:54: what begins with --- here does not end with ---/,
  );
});

test("what would be run is no link, but text", () => {
  const text = GOOD.replace("./experiments.html", "javascript:alert(1)");
  expect(JSON.stringify(readLesson(PATH, text, isKnown))).not.toMatch(/href=[^>]*javascript/);
  expect(readLesson(PATH, GOOD.replace("Text.", "<b onclick=1>"), isKnown).steps[2].html).toBe(
    "<p>&lt;b onclick=1&gt;</p>",
  );
});

test("all mistakes of a file are told at once, in the order of their lines", () => {
  const text = GOOD.replace("minutes: 10", "minutes: ten").replace("pins >= 1", "pins").replace("step: Plain", "step:");
  expect(() => readLesson("docs/lessons/example.md", text, isKnown)).toThrow(
    /^docs\/lessons\/example.md:1: a lesson's file is called like.*\ndocs.*:4: minutes.*\ndocs.*:14: .*\ndocs.*:40: step: is/,
  );
});
