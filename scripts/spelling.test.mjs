// The documents and the lessons are spelt as British English has it; names and the field's own words are in a list.

import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import dictionary from "dictionary-en-gb";
import nspell from "nspell";
import { expect, test } from "vitest";
import { root } from "./lib/process.mjs";

const LIST = "scripts/lib/words.txt";
const OWN = readFileSync(join(root, LIST), "utf8").trim().split("\n");
const PAGES = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", ...markdown("docs"), ...markdown("docs/lessons")];

const spelling = nspell(Buffer.from(dictionary.aff), Buffer.from(dictionary.dic));
const known = new Set(OWN);

/** @param {string} folder */
function markdown(folder) {
  return readdirSync(join(root, folder))
    .filter((name) => name.endsWith(".md"))
    .map((name) => `${folder}/${name}`);
}

/**
 * What is no prose becomes blank: code, formulas, addresses, and what a lesson's block has but its titles.
 *
 * @param {string} text
 */
function prose(text) {
  const blank = (/** @type {string} */ part) => part.replace(/[^\n]/g, " ");
  return text
    .replace(/^\s*(`{3,}).*\n[\s\S]*?^\s*\1$/gm, blank)
    .replace(/`[^`]*`/g, blank)
    .replace(/\$\$[\s\S]*?\$\$|(?<!\\)\$(?:\\\$|[^$])*\$/g, blank)
    .replace(/\]\([^)]*\)/g, blank)
    .replace(/<[^>]*>/g, blank)
    .replace(/\bhttps?:\/\/\S+/g, blank)
    .replace(/^(state|show|controls|sliders|a|b|reveal|check|solution|holds): .*$/gm, blank)
    .replace(/\S*[\w\d]\.(md|ts|tsx|rs|mjs|svg|json|csv|tps|yml|tgz)\b/g, blank);
}

/**
 * @param {string} text
 * @returns {string[]} each with its line
 */
function misspelt(text) {
  return prose(text)
    .split("\n")
    .flatMap((line, i) =>
      [...line.matchAll(/[\p{L}\p{M}]+(?:[’'][\p{L}]+)*/gu)]
        .map(([word]) => word.replace("’", "'"))
        // Letters of other alphabets, above and below the line are formulas.
        .filter((word) => word.length > 2 && /^[\p{Script=Latin}']+$/u.test(word) && !isKnown(word))
        .map((word) => `${i + 1}: ${word}`),
    );
}

/** @param {string} word */
function isKnown(word) {
  const plain = word.replace(/'s$/, "");
  const small = plain.charAt(0).toLowerCase() + plain.slice(1);
  return known.has(plain) || known.has(small) || spelling.correct(word) || spelling.correct(plain);
}

test.each(PAGES)("%s: every word is spelt right", (name) => {
  expect(misspelt(readFileSync(join(root, name), "utf8"))).toEqual([]);
});

test("a wrong word is found with its line, and what is no prose is left alone", () => {
  expect(misspelt("A colour.\nA bevaviour, and a color.")).toEqual(["2: bevaviour", "2: color"]);
  expect(misspelt("`xyzzy` and $\\xyzzy$, [here](./xyzzy.html)\n```sh\nxyzzy\n```\nstate: v=2&xyzzy")).toEqual([]);
});

test("the list is in order, and has no word that the dictionary knows or that nobody uses", () => {
  expect(OWN).toEqual([...new Set(OWN)].sort((a, b) => a.localeCompare(b, "en")));
  expect(OWN.filter((word) => spelling.correct(word))).toEqual([]);
  const all = PAGES.map((name) => prose(readFileSync(join(root, name), "utf8"))).join("\n");
  const used = new Set(
    (all.match(/[\p{L}\p{M}]+/gu) ?? []).flatMap((word) => [word, word.charAt(0).toLowerCase() + word.slice(1)]),
  );
  expect(OWN.filter((word) => !used.has(word))).toEqual([]);
});
