import { expect, test } from "vitest";
import { pageOf, parts } from "./lib/licences.mjs";
import { output } from "./lib/process.mjs";

const all = parts();
const names = all.map(({ name }) => name);

test("every package that the page carries is in it, with what it needs in turn, and the gallery's data", () => {
  expect(names).toEqual(expect.arrayContaining(["preact", "@preact/signals", "@phosphor-icons/core", "world-atlas"]));
  expect(names).toContain("@preact/signals-core");
  expect(names).not.toContain("vite");
});

test("every crate that cargo links into the wasm is in it", () => {
  const tree = ["tree", "--locked", "--target", "wasm32-unknown-unknown", "--edges", "normal,no-proc-macro"];
  const lines = output("cargo", [...tree, "--prefix", "none", "--format", "{p}"]) ?? "";
  const crates = new Set(lines.split("\n").map((line) => line.split(" ")[0]));
  expect(crates.size).toBeGreaterThan(10);
  expect(names).toEqual(expect.arrayContaining([...crates]));
  expect(names).not.toContain("thiserror-impl");
});

test("each part has its terms, readable as a page", () => {
  for (const { name, text } of all) expect(text.length, name).toBeGreaterThan(400);
  const page = pageOf([{ name: "a<b", version: "1", licence: "MIT", text: "© <me@example.org> & others" }]);
  expect(page).toContain("<h2>a&lt;b 1</h2><p>MIT</p><pre>© &lt;me@example.org&gt; &amp; others</pre>");
});
