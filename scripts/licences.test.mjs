import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { pageOf, parts } from "./lib/licences.mjs";

const all = parts();
const names = all.map(({ name }) => name);

test("every package that the page carries is in it, with what it needs in turn, and the gallery's data", () => {
  expect(names).toEqual(expect.arrayContaining(["preact", "@preact/signals", "@phosphor-icons/core", "world-atlas"]));
  expect(names).toContain("@preact/signals-core");
  expect(names).not.toContain("vite");
});

test.each(["wasm", "wasm-solid", "wasm-gpu"])(
  "every crate that www/%s/ names in what it panics with is in it",
  (folder) => {
    const module = readFileSync(`www/${folder}/thinshell_bg.wasm`, "latin1");
    const crates = new Set([...module.matchAll(/([a-z0-9_-]+)-\d+\.\d+\.\d+\/src\//g)].map(([, name]) => name));
    // Rust's own library has it.
    crates.delete("dlmalloc");
    expect(crates).toContain("js-sys");
    expect(crates.has("wgpu")).toBe(folder === "wasm-gpu");
    expect(names).toEqual(expect.arrayContaining([...crates]));
  },
);

test("what only builds the modules, or is for other platforms, is not in it", () => {
  expect(names).toContain("wide");
  for (const other of ["thiserror-impl", "wasm-bindgen-macro", "ash", "proptest"]) expect(names).not.toContain(other);
});

test("each part has its terms, readable as a page", () => {
  for (const { name, text } of all) expect(text.length, name).toBeGreaterThan(400);
  const page = pageOf([{ name: "a<b", version: "1", licence: "MIT", text: "© <me@example.org> & others" }]);
  expect(page).toContain("<h2>a&lt;b 1</h2><p>MIT</p><pre>© &lt;me@example.org&gt; &amp; others</pre>");
});
