import { afterEach, expect, test, vi } from "vitest";
import { moduleAt } from "./engine";

/** The smallest module: its magic number and its version. */
const EMPTY = Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0);

afterEach(() => {
  vi.unstubAllGlobals();
});

function answers(...all: (() => Response)[]) {
  const fetched = vi.fn(async () => {
    const answer = all.shift();
    if (!answer) throw new TypeError("Failed to fetch");
    return answer();
  });
  vi.stubGlobal("fetch", fetched);
  return fetched;
}

test("the module is fetched once, however often it is asked for", async () => {
  const fetched = answers(() => new Response(EMPTY));
  const module = moduleAt("solver.wasm");
  expect(await module()).toBe(await module());
  expect(fetched).toHaveBeenCalledOnce();
});

test("after a failure it is fetched again", async () => {
  answers(
    () => new Response("", { status: 503 }),
    () => new Response(EMPTY),
  );
  const module = moduleAt("solver.wasm");
  await expect(module()).rejects.toThrow("the solver could not be loaded (503); reload the page");
  await expect(module()).resolves.toBeInstanceOf(WebAssembly.Module);
});

test("without a network or without WebAssembly the sentence says what to do", async () => {
  answers();
  await expect(moduleAt("solver.wasm")()).rejects.toThrow("check the connection");
  answers(() => new Response("<html>"));
  await expect(moduleAt("solver.wasm")()).rejects.toThrow(/does not take its WebAssembly \(.*use a current Firefox/);
});
