import { expect, test } from "vitest";
import { signedArea } from "../www/shapes/geometry";
import { readSvg } from "../www/shapes/import/svg";
import { Refusal, wantedIn } from "./arguments";
import { checkWellFormed, provideParser } from "./drawing";

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
  `<svg:svg xmlns:svg="x"><größe/><svg:g\n/></svg:svg>`,
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

const SVG = 'xmlns="http://www.w3.org/2000/svg"';
const XLINK = 'xmlns:xlink="http://www.w3.org/1999/xlink"';
const SQUARE = "M0 0h10v10h-10z";

test.each([
  ["a path", `<svg ${SVG}><path d="${SQUARE}"/></svg>`, 100],
  ["a shape with a transform", `<svg ${SVG}><g transform="scale(2)"><rect width="5" height="10"/></g></svg>`, 200],
  [
    "uses of either kind",
    `<svg ${SVG} ${XLINK}><defs><path id="a" d="${SQUARE}"/></defs><use xlink:href="#a"/><use href="#a" x="20"/></svg>`,
    200,
  ],
  ["a prefix", `<s:svg xmlns:s="http://www.w3.org/2000/svg"><s:g><s:path d="${SQUARE}"/></s:g></s:svg>`, 100],
  [
    "what a style sheet hides",
    `<svg ${SVG}><style>.no, #b > path { display: none }</style><path class="no" d="${SQUARE}"/><g id="b"><path d="${SQUARE}"/></g><path style="fill:red" d="M20 0h5v5h-5z"/></svg>`,
    25,
  ],
  [
    "what Inkscape writes",
    `<?xml version="1.0" encoding="UTF-8"?>\n<!-- Created with Inkscape -->\n<svg ${SVG} xmlns:sodipodi="http://sodipodi.example" viewBox="0 0 9 9"><sodipodi:namedview id="n"><path d="M0 0h99v99z"/></sodipodi:namedview><metadata><path d="M0 0h99v99z"/></metadata><path d="${SQUARE}"/></svg>`,
    100,
  ],
])("without a browser, of a drawing with %s all that is painted is read", (_, text, area) => {
  provideParser();
  checkWellFormed(text);
  const [all] = readSvg(text).choices;
  expect(all.loops.reduce((sum, loop) => sum + signedArea(loop), 0)).toBeCloseTo(area, 3);
});
