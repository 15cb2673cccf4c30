/** Addresses of frames: what is asked is read, what cannot be asked is refused by a sentence. */

import { expect, test } from "vitest";
import { FIELDS } from "../settings";
import { addressFor, asked, CONTROLS, changedBy, KINDS, snippet, USUAL } from "./asked";

const PAGE = "https://example.org/thinshell/?lang=de#v=2&preset=star";

test("a page that asks for nothing is not embedded", () => {
  expect(asked("")).toBeNull();
  expect(asked("?bending=0&view=stretch")).toBeNull();
});

test.each(KINDS)("%s has what is usual, where the address names no controls", (kind) => {
  expect(asked(`?embed=${kind}`)).toEqual({
    kind,
    controls: new Set(USUAL[kind]),
    sliders: [],
    sides: [null, null],
    origin: null,
  });
});

test("an address that is made is read as what it was made of", () => {
  const bending = FIELDS.find(({ name }) => name === "bending");
  if (!bending) throw new Error("there is bending");
  for (const kind of KINDS) {
    for (const controls of [[], ["morph"], USUAL[kind], CONTROLS] as const) {
      const sides = [null, { field: bending, value: 0 }] as const;
      const link = "v=2&preset=letters&bending=1";
      const url = new URL(addressFor(PAGE, { kind, controls, sliders: [bending], sides, later: true, link }));
      expect(url.hash).toBe(`#${link}`);
      expect(url.pathname).toBe("/thinshell/");
      expect(url.searchParams.get("match")).toBe("later");
      expect(asked(url.search)).toEqual({
        kind,
        controls: new Set(controls),
        sliders: [bending],
        sides,
        origin: null,
      });
    }
  }
});

test("the second side of a comparison has the change, and nothing else", () => {
  const found = asked("?embed=compare&b=bending:1");
  expect(found?.sides.map((side) => changedBy({ membrane: 2 }, side))).toEqual([
    { membrane: 2 },
    { membrane: 2, bending: 1 },
  ]);
});

test.each([
  ["?embed=", /embed=.* one of result, compare, full/],
  ["?embed=Result", /embed=Result/],
  ["?embed=result&controls=view,erase", /“erase”; there are view, morph/],
  ["?embed=full&sliders=bending,colour", /“colour”/],
  ["?embed=full&sliders=pins", /“pins”/],
  ["?embed=compare&b=bending", /“bending”, which must be like/],
  ["?embed=compare&b=bending:0:1", /which must be like/],
  ["?embed=compare&b=bending:much", /“much”, but must be a number/],
  ["?embed=result&origin=example.org", /“example.org” as an origin/],
  ["?embed=result&origin=https://example.org/", /“https:\/\/example.org\/” as an origin/],
  ["?embed=result&origin=*", /“\*” as an origin/],
])("%s is refused by a sentence", (search, words) => {
  expect(() => asked(search)).toThrow(words);
});

test("an origin is taken as browsers write it", () => {
  expect(asked("?embed=result&origin=http://localhost:8000")?.origin).toBe("http://localhost:8000");
});

test("a snippet is one element, whatever the address holds", () => {
  const text = snippet('https://example.org/?a="><script>&b=1', 700, 500);
  expect(text).toContain('src="https://example.org/?a=&quot;><script>&amp;b=1" width="700" height="500"');
  expect(text.match(/"/g)?.length).toBe(14);
});
