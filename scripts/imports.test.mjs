import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { withShortImports } from "./lib/imports.mjs";

test.each(["wasm", "wasm-solid", "wasm-gpu"])("no name that www/%s/ imports carries a hash", (folder) => {
  const module = new WebAssembly.Module(readFileSync(`www/${folder}/thinshell_bg.wasm`));
  const glue = readFileSync(`www/${folder}/thinshell.js`, "utf8");
  const names = WebAssembly.Module.imports(module).map(({ name }) => name);
  expect(names.length).toBeGreaterThan(10);
  for (const name of names) {
    expect(name).toMatch(/^i[0-9a-z]{1,2}$/);
    expect(glue).toContain(`        ${name}: function(`);
  }
});

/** Types: one function without anything. Imports: "m" "long" of it. Exports: it as "f". */
const MODULE = Uint8Array.from([
  ...[0, 97, 115, 109, 1, 0, 0, 0],
  ...[1, 4, 1, 0x60, 0, 0],
  ...[2, 10, 1, 1, 109, 4, 108, 111, 110, 103, 0, 0],
  ...[7, 5, 1, 1, 102, 0, 0],
]);

test("a module asks by the short name for what it asked for by the long one", () => {
  const { module, glue } = withShortImports(MODULE, "{\n        long: function() {},\n}");
  expect(glue).toBe("{\n        i0: function() {},\n}");
  let calls = 0;
  const imports = { m: { i0: () => (calls += 1) } };
  const { exports } = new WebAssembly.Instance(new WebAssembly.Module(Buffer.from(module)), imports);
  /** @type {() => void} */ (exports.f)();
  expect(calls).toBe(1);
});

test("what the JavaScript does not provide is refused when the module is made", () => {
  expect(() => withShortImports(MODULE, "{}")).toThrow("long is not provided once");
});

test("a module without imports stays as it is", () => {
  const empty = MODULE.slice(0, 14);
  expect(withShortImports(empty, "").module).toEqual(empty);
});
