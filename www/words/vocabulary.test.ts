/** Settings, terms and the page's formula call one thing by one name and one symbol. */

import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { SETTINGS } from "../wasm/settings.js";
import { en } from "./en";

const WEIGHTS = { membrane: "membrane", bending: "bending", mismatch: "penalty", volume: "volume" } as const;

test.each(Object.entries(WEIGHTS))("the term %s is called like its weight, %s", (term, weight) => {
  const label = SETTINGS.find(({ name }) => name === weight)?.label;
  expect(label).toBe(Reflect.get(en.terms.names, term));
});

/** The page's formula as it stands in the solver's documents: letters, indices after a low line, no spaces. */
function formula(): string {
  const found = /<div class="formula">([\s\S]*?)<\/div>/.exec(readFileSync("index.html", "utf8"))?.[1] ?? "";
  return found
    .replace(/<mfrac><mn>(.*?)<\/mn><mi>(.*?)<\/mi><\/mfrac>/g, "$1/$2")
    .replace(/<msub><mi>d<\/mi><mn>(.)<\/mn><\/msub>/g, "d$1")
    .replace(/<msub><mi>(.*?)<\/mi><mtext>(.*?)<\/mtext><\/msub>/g, "$1_$2")
    .replace(/<msub><mi>(.)<\/mi><mrow>(.*?)<\/mrow><\/msub>/g, "$1_{$2}")
    .replace(/<[^>]*>|\s/g, "")
    .replace("&lt;", "<");
}

test("every weight and length of the formula stands in it by the symbol that the settings show", () => {
  for (const setting of [...Object.values(WEIGHTS), "thickness", "bandwidth", "tangency", "interior"]) {
    const symbol = SETTINGS.find(({ name }) => name === setting)?.symbol ?? "";
    expect(symbol).not.toBe("");
    expect(formula()).toContain(symbol);
  }
});

test("the page's formula is the whole energy, as the solver's documents have it", () => {
  const documented = /\/\/! (E\[φ\] = .*)\n\/\/! (.*)\n/.exec(readFileSync("src/lib.rs", "utf8"));
  expect(formula()).toBe(documented?.slice(1).join("").replace(/\s/g, ""));
});

test("no setting says first and second curve: they are the reference and the target", () => {
  for (const { name, label, help, ...more } of SETTINGS) {
    expect(`${label} ${help} ${JSON.stringify(more)}`, name).not.toMatch(/(first|second) (curve|one)/);
  }
});
