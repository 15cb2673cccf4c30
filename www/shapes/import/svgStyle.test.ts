import { expect, test } from "vitest";
import { blocks } from "./svgStyle";

test("blocks have their selectors and declarations, whatever stands between", () => {
  const sheet = `/* a { } */ @import url("x{};"); .a, #b > g { fill: none; stroke: red } @media print { .a { fill: red } }
    g[id="}"] { stroke: none /* } */ } rect{fill:blue`;
  expect(blocks(sheet).map(({ selector, body }) => [selector, body.trim()])).toEqual([
    [".a, #b > g", "fill: none; stroke: red"],
    ['g[id="}"]', "stroke: none"],
    ["rect", "fill:blue"],
  ]);
});

test("what is nested is for other states: the block around it keeps its own declarations", () => {
  const [block] = blocks("g { fill: none; &:hover { fill: red; } .x { stroke: none } stroke: blue }");
  expect(block.body.replace(/\s+/g, " ").trim()).toBe("fill: none; stroke: blue");
});

test.each([
  ["nested blocks", "a{".repeat(200_000)],
  ["closed ones", "a{".repeat(200_000) + "}".repeat(200_000)],
  ["blocks in a block", `a{${"b{}".repeat(200_000)}}`],
  ["comments without an end", "/*".repeat(200_000)],
  ["quotes without an end", "a{b:'".repeat(100_001)],
])("200,000 %s are read in one pass", (_, text) => {
  expect(blocks(text).length).toBeLessThanOrEqual(1);
});
