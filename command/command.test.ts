import { expect, test } from "vitest";
import { Refusal, wantedIn } from "./arguments";
import { checkWellFormed } from "./drawing";

test("a reference, targets and options are understood", () => {
  expect(wantedIn(["match", "a.svg", "b.svg", "c", "--out", "d", "--set", "finest=5", "--set", "bending=0"])).toEqual({
    reference: "a.svg",
    targets: ["b.svg", "c"],
    out: "d",
    points: 100,
    outline: false,
    strains: false,
    settings: { finest: 5, bending: 0 },
  });
});

test("nothing, or a wish for help, is answered by help", () => {
  expect(wantedIn([])).toBe("help");
  expect(wantedIn(["match", "--help"])).toBe("help");
  expect(wantedIn(["--version"])).toBe("version");
});

test.each([
  [["draw"], /no command “draw”/],
  [["match"], /Name a reference/],
  [["match", "a.svg"], /Name the targets to match a.svg with/],
  [["match", "a", "b", "--points", "2"], /--points is “2”/],
  [["match", "a", "b", "--set", "finesse=1"], /no setting “finesse”; they are membrane,/],
  [["match", "a", "b", "--set", "finest=99"], /“99”, but must be one of/],
  [["match", "a", "b", "--colour"], /--colour/],
])("%j is refused by a sentence", (args, message) => {
  expect(() => wantedIn(args)).toThrow(message);
  expect(() => wantedIn(args)).toThrow(Refusal);
});

test.each([
  `<?xml version="1.0"?><!DOCTYPE svg PUBLIC "a" "b" [<!ENTITY c "d">]><svg xmlns="x"><!-- <g> --><g><path d="M0 0"/></g></svg>`,
  `<svg><style><![CDATA[ a > b { fill: red } ]]></style><text>a &gt; b</text><path d='M0 0' title="1 > 0"/></svg>\n`,
])("well-formed: %s", (text) => {
  expect(() => checkWellFormed(text)).not.toThrow();
});

test.each([
  ["<svg>\n<g></svg>", /line 2: <\/svg> ends what has not begun/],
  ["<svg><g>", /<g> does not end/],
  ['<svg>\n\n<path d="M0 0', /line 3: a tag does not end/],
  ["<svg/><svg/>", /more than one root/],
])("broken: %j", (text, message) => {
  expect(() => checkWellFormed(text)).toThrow(message);
});

test("what never ends is found out at once", () => {
  for (const part of ['<a b="', "<!--", "<![CDATA[", "<a ", "<!DOCTYPE [", "< "]) {
    expect(() => checkWellFormed(part.repeat(20_000))).toThrow(/broken/);
  }
});
