/** What solver and import can say has a pattern each, so that a new sentence there is not forgotten here. */

import { readdirSync, readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { again } from "./again";

const IMPORT = new URL("../../shapes/import/", import.meta.url);

/** Of Rust's `#[error("…")]`, with something in each hole. */
function refusals(): string[] {
  const source = readFileSync(new URL("../../../src/error.rs", import.meta.url), "utf8");
  const found = [...source.matchAll(/#\[error\(\s*"((?:[^"\\]|\\.)*)"/g)].map(([, text]) =>
    text.replaceAll('\\"', '"'),
  );
  return found.map(filled).filter((text) => /[a-z]{4}/.test(text));
}

/** Of the readers: whatever is written there as a sentence. */
function sentences(): string[] {
  const names = [...readdirSync(IMPORT), "../../morphometrics/tps.ts"];
  const files = names.filter((name) => name.endsWith(".ts") && !name.endsWith(".test.ts"));
  return files.flatMap((name) => {
    const source = readFileSync(new URL(name, IMPORT), "utf8").replace(/\/\*[\s\S]*?\*\/|^\s*\/\/.*$/gm, "");
    const texts = source.matchAll(/"([^"\n]*)"|`((?:[^`\\]|\\.)*)`/g);
    return [...texts]
      .map(([, plain, made]) => plain ?? made)
      .filter((text) => /^[A-Z$].* .*\.$/s.test(text))
      .map(filled);
  });
}

/** The inner choices of a text are its first ones. */
function filled(text: string): string {
  return text
    .replace(/\$\{[^{}]*\? "([^"]*)" : "[^"]*"\}/g, "$1")
    .replace(/\$\{counted\([^{}]*"(\w+)"\)\}/g, "1 $1")
    .replace(/\$?\{(?![":])[^{}]*\}/g, "7");
}

test("the solver has sentences, and the readers have", () => {
  expect(refusals().length).toBeGreaterThan(25);
  expect(sentences().length).toBeGreaterThan(45);
});

test.each([...refusals(), ...sentences()].map((text) => [text]))("“%s” has its German", (english) => {
  const german = again(english);
  expect(german).not.toBe(english);
  expect(german).not.toMatch(/\b(the|and|of|is|are|to|with|has|grid|shape)\b/);
  expect(german).not.toMatch(/\{\w+\}/);
});

test.each([
  [
    'the template leaves the box on the right (x = 1.04); make it smaller or move it inwards ("Fit" does both)',
    "das Ziel ragt rechts über den Rand hinaus (x = 1,04); machen Sie die Form kleiner, oder schieben Sie sie nach innen („Einpassen“ tut beides)",
  ],
  [
    "the reference is too thin for the grid of 128 cells a side, which sees 12 % of its surface and least of it at (0.25, 0.50, 0.75); make it thicker or choose a finer grid",
    "die Referenz ist zu dünn für das Gitter von 128 Zellen je Seite, das 12 % der Fläche sieht, am wenigsten bei (0,25; 0,50; 0,75); machen Sie die Form dicker, oder wählen Sie ein feineres Gitter",
  ],
  [
    "Two parts against one part: no deformation takes the one shape to the other. The largest distance is 3.40 cells, at (0.25, 0.50, 0.75).",
    "Zwei Teile gegen ein Teil: Keine Verformung führt die eine Form in die andere über. Der größte Abstand ist 3,40 Zellen, bei (0,25; 0,50; 0,75).",
  ],
  [
    "No handles against one handle: no deformation takes the one shape to the other.",
    "Kein Henkel gegen ein Henkel: Keine Verformung führt die eine Form in die andere über.",
  ],
  ["2 specks smaller than a cell are left out.", "2 Flecken, kleiner als eine Zelle, sind weggelassen."],
  [
    "Line 3: “1.5.2” is not a number; each line needs an x and a y.",
    "Zeile 3: „1.5.2“ ist keine Zahl; jede Zeile braucht ein x und ein y.",
  ],
] as const)("“%s” is said again", (english, german) => {
  expect(again(english)).toBe(german);
});

test("what no pattern knows stays as it is, as a whole", () => {
  const half = "Does not fit. Nobody knows this.";
  expect(again(half)).toBe(half);
});
