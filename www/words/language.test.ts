/** The other languages have the shape of English, and none of its sentences. */

import { afterEach, expect, test } from "vitest";
import "../pins/words";
import { EXPERIMENTS } from "../experiments";
import { SOLID_EXPERIMENTS } from "../experiments/solids";
import { FIELDS } from "../settings";
import { PRESETS } from "../shapes/presets";
import { PAIRS, SURFACES } from "../space/gallery";
import { de } from "./de";
import "./drawing";
import "./embed";
import { en } from "./en";
import { experiments } from "./experiments";
import "./batch";
import "./files";
import { helps } from "./helps";
import "./imports";
import { language, page, pages, preferred, speak } from "./language";
import { captions } from "./later";
import "./lessons";
import "./links";
import "./memory";
import { decimals } from "./numbers";
import "./offline";
import { place } from "./place";
import "./recent";
import "./save";
import { sidesSaid } from "./sides";
import "./space";
import "./strokes";
import "./tools";
import "./way";

type Leaf = readonly [path: string, value: unknown];

function leaves(value: unknown, path = ""): Leaf[] {
  if (typeof value !== "object" || value === null) return [[path, value]];
  return Object.entries(value).flatMap(([key, part]) => leaves(part, `${path}/${key}`));
}

/** What the languages share: signs, formats, and what is no sentence. */
const SAME = [
  "/en/actions/live",
  "/space/actions/live",
  "/later/scales/mismatch",
  "/later/past/name",
  "/later/energies/iteration",
  "/en/numbers/iteration",
  "/en/views/band",
  "/later/readout/partner",
  "/recent/when",
  "/imports/silhouette",
  "/settings/bandwidth/label",
  "/imports/name",
  "/offline/region",
  "/presets/letters/title",
  "/experiments/of",
  "/lessons/value",
  "/experiments/doing",
  "/outline/roundness",
  // Of what they are given.
  "/en/solver/words",
  "/later/card/because",
  "/imports/words",
  "/space/percent",
  "/space/grid",
  "/space/numbers/iteration",
  "/surfaces/ellipsoid/name",
  "/surfaces/unduloid/name",
  "/surfaces/torus/name",
];

/** Those of the page's files are elements, and those of settings, examples and experiments stand elsewhere. */
const ELSEWHERE = [
  ...["indexFile", "experimentsFile", "lessonsFile", "settings", "presets", "experimentTexts"],
  ...["surfaces", "pairsOfSurfaces"],
];

afterEach(() => speak("en"));

test("a page that one language has, the other has, sentence for sentence", () => {
  const english = [...pages].filter(([name]) => !ELSEWHERE.includes(name));
  const german = Object.entries(de).filter(([name]) => !ELSEWHERE.includes(name));
  expect(german.map(([name]) => name).sort()).toEqual(english.map(([name]) => name).sort());
  const shape = (all: readonly (readonly [string, unknown])[]) =>
    all.flatMap(([name, held]) => leaves(held, `/${name}`).map(([path, value]) => `${path}: ${typeof value}`)).sort();
  expect(shape(german)).toEqual(shape(english));
});

test("every setting, example, surface and experiment has its words", () => {
  for (const field of FIELDS) {
    const words = de.settings[field.name];
    expect(words?.label, field.name).toBeTruthy();
    expect(de.helps[field.name], field.name).toMatch(/^[A-ZÄÖÜ].*\.$/);
    if (field.kind === "number") expect(Boolean(words?.unit), field.name).toBe(field.unit !== "");
    else if (field.name !== "finest") expect(words?.options?.length, field.name).toBe(field.options.length);
    // A label ends with its symbol, unless that has an index: then the symbol stands beside the label.
    if (!field.symbol.includes("_")) expect(words?.label.endsWith(field.symbol), field.name).toBe(true);
  }
  expect(Object.keys(de.settings).sort()).toEqual(FIELDS.map(({ name }) => name).sort());
  expect(Object.keys(de.helps).sort()).toEqual(Object.keys(helps).sort());
  expect(Object.keys(de.presets).sort()).toEqual(PRESETS.map(({ id }) => id).sort());
  expect(Object.keys(de.surfaces).sort()).toEqual(SURFACES.map(({ id }) => id).sort());
  const pairs = PAIRS.map(({ reference, template }) => `${reference} ${template}`);
  expect(Object.keys(de.pairsOfSurfaces).sort()).toEqual(pairs.sort());
  expect(Object.keys(de.experimentTexts).sort()).toEqual(
    [...EXPERIMENTS, ...SOLID_EXPERIMENTS].map(({ id }) => id).sort(),
  );
});

test("no sentence of the one is left in the other", () => {
  const english = new Map([...pages].flatMap(([name, held]) => leaves(held, `/${name}`)));
  const left: string[] = [];
  for (const [name, held] of Object.entries(de)) {
    for (const [path, value] of leaves(held, `/${name}`)) {
      if (SAME.some((known) => path.startsWith(known))) continue;
      const text = said(value);
      if (text !== "" && text === said(english.get(path))) left.push(path);
      // The paper's title, and signs.
      expect(text.replace(/<cite.*?<\/cite>|<span lang="en".*?<\/span>|„A Thin Shell.*?“/g, ""), path).not.toMatch(
        ENGLISH,
      );
    }
  }
  expect(left).toEqual([]);
});

/** Names by which the page is driven stay; the sides of a grid and of a comparison are other sides. */
const OTHERWISE = [
  ...["/en/sketch/surface", "/en/sketch/clearSide", "/space/surface"],
  ...["/en/result/on", "/later/compare/"],
];

test("no English sentence says template: the shape aimed at is the target", () => {
  const wrong = [...pages]
    .flatMap(([name, held]) => leaves(held, `/${name}`))
    .filter(([path]) => !OTHERWISE.some((known) => path.startsWith(known)))
    .map(([path, value]) => `${path}: ${typeof value === "function" ? ofTemplate(value as Make) : value}`)
    .filter((line) => /\btemplate/i.test(line.slice(line.indexOf(":"))));
  expect(wrong).toEqual([]);
  expect(ofTemplate(en.imports.of as Make)).toBe("Import target");
});

type Make = (...given: never[]) => unknown;

/** A function's sentence where it is told of the template; of others whatever they say of made-up values. */
function ofTemplate(make: Make): string {
  const names = /^\(?([^)=]*)/.exec(String(make))?.[1].split(",") ?? [];
  const given = names.map((name) => (["side", "from"].includes(name.trim()) ? "template" : 2));
  try {
    return String(make(...(given as never[])));
  } catch {
    return "";
  }
}

test("what the solver refuses names the target, and is otherwise as it is", () => {
  const fits = 'the template leaves the box on the right; press "Fit"';
  expect(sidesSaid(fits)).toBe('the target leaves the box on the right; press "Fit"');
  expect(sidesSaid("the reference has no points")).toBe("the reference has no points");
});

/** Words that no German sentence has. */
const ENGLISH = /\b(the|and|of|is|are|to|with|press|curves?|grid|target|shapes?|match|settings?|draw|your|this)\b/i;

/** A function's sentence for made-up values; its text where they do not fit. */
function said(value: unknown): string {
  if (typeof value !== "function") return String(value);
  try {
    return String(value(...Array.from({ length: value.length }, (_, i) => (i === 0 ? "reference" : 2))));
  } catch {
    return "";
  }
}

test("what is held says the language in force, and English again after that", async () => {
  const before = leaves(en);
  const { actions } = en;
  expect([en.actions.match, actions.match, decimals(0.25)]).toEqual(["Match", "Match", "0.25"]);
  await speak("de");
  expect([language.value, en.actions.match, actions.match]).toEqual(["de", "Abgleichen", "Abgleichen"]);
  expect([decimals(-0.25), decimals(1.5e-7), place({ x: 0.5, y: 0.25 })]).toEqual([
    "−0,25",
    "1,5·10⁻⁷",
    "0,5 von links, 0,25 von unten",
  ]);
  expect(FIELDS.find(({ name }) => name === "thickness")).toMatchObject({ label: "Dicke δ", unit: "Seitenlängen" });
  expect(PRESETS.find(({ id }) => id === "fish")?.title).toBe("Fisch → schwimmender Fisch");
  await speak("de");
  expect(en.actions.match).toBe("Abgleichen");
  await speak("en");
  expect(leaves(en)).toEqual(before);
});

test("a page that comes after the language speaks it", async () => {
  await speak("de");
  const late = page(
    "experimentTexts",
    Object.fromEntries([...EXPERIMENTS, ...SOLID_EXPERIMENTS].map((experiment) => [experiment.id, experiment])),
  );
  expect(late.cascade.title).toBe("Algorithmus 1: von grob zu fein");
});

test.each([
  ["", null, ["fr-FR", "de-AT", "en"], "de"],
  ["", null, ["en-GB", "de"], "en"],
  ["", null, ["fr"], "en"],
  ["", null, [], "en"],
  ["", "en", ["de"], "en"],
  ["?lang=de", "en", ["en"], "de"],
  ["?lang=en", "de", ["de"], "en"],
  ["?lang=tlh", "de", ["en"], "de"],
  ["?lang=toString", null, ["constructor"], "en"],
] as const)("the address “%s”, the choice %s and the browser's %j make %s", (search, chosen, languages, wanted) => {
  expect(preferred(search, chosen, languages)).toBe(wanted);
});

test("every caption is German in whole sentences", async () => {
  const english = { ...captions };
  await speak("de");
  for (const [view, caption] of Object.entries(captions)) {
    expect(caption, view).not.toBe(english[view as keyof typeof english]);
    expect(caption, view).toMatch(/^[A-ZÄÖÜ].*\.$/);
    expect(caption.length, view).toBeGreaterThan(80);
  }
  expect(experiments.lists.curves).toBe("Experimente mit Kurven");
});
