/** A graphics card that computes, played by SwiftShader: through the page, and through the package. */

import { readFileSync } from "node:fs";
import { expect, type Page, test } from "@playwright/test";
import type { Registration as Made } from "../../www/wasm-gpu/thinshell.js";
import { button, choose, finished, ours, settings, value, watch } from "./handles";

test("who wants the graphics card gets it, and is told so", async ({ page }) => {
  // The same processor draws the page, too.
  test.setTimeout(150_000);
  const seen = watch(page);
  await page.goto("./#v=2&preset=ellipse&finest=5&align=none&backend=gpu&match=later");
  await button(page, "Match").click();
  await finished(page);
  const status = page.getByRole("status");
  await expect(status.locator('data[data-name="backend"]')).toHaveAttribute("value", /^gpu: .*swiftshader/i);
  await expect(status).toContainText("Computed by");
  await expect(status).toContainText(/the graphics card \(.*swiftshader.*\)/i);
  expect(await value(page, "mismatch-max")).toBeLessThan(0.5);
  // A card that the processor plays is none where the faster one is to compute.
  await settings(page).click();
  await page.getByText("For those who know the paper").click();
  await choose(page, "Computed by", "the fastest there is");
  await button(page, "Match").click();
  await finished(page);
  await expect(status.locator('data[data-name="backend"]')).toHaveCount(0);
  await expect(page.getByText("Last: the processor.")).toBeVisible();
  expect(ours(seen.errors)).toEqual([]);
});

/** A page with the package and nothing else. */
async function bare(page: Page): Promise<void> {
  const types: Record<string, string> = { html: "text/html", js: "text/javascript", wasm: "application/wasm" };
  await page.route("**/bare/*", async (route) => {
    const name = new URL(route.request().url()).pathname.split("/").pop() ?? "";
    const body = name.endsWith(".html") ? "<!doctype html><title>bare</title>" : readFileSync(`www/wasm-gpu/${name}`);
    await route.fulfill({ body, contentType: types[name.split(".").pop() ?? ""] });
  });
  await page.goto("./bare/index.html");
}

test("a match by the card is the processor's, also beside another, and when the device is lost", async ({ page }) => {
  // The processor plays the card: more than a minute.
  test.setTimeout(300_000);
  const problems: string[] = [];
  page.on("pageerror", (error) => problems.push(error.message));
  page.on("console", (message) => message.type() === "error" && problems.push(message.text()));
  await bare(page);
  const ends = await page.evaluate(async () => {
    const devices: GPUDevice[] = [];
    const request = GPUAdapter.prototype.requestDevice;
    GPUAdapter.prototype.requestDevice = async function (descriptor) {
      const device = await request.call(this, descriptor);
      devices.push(device);
      return device;
    };
    const address = new URL("thinshell.js", location.href).href;
    const { default: init, Registration } = (await import(address)) as typeof import("../../www/wasm-gpu/thinshell.js");
    await init();
    const star = (x: number, radius: number, depth: number, turn: number) => ({
      kind: "curves" as const,
      loops: [
        Float64Array.from({ length: 400 }, (_, k) => {
          const angle = (2 * Math.PI * Math.floor(k / 2)) / 200;
          const r = radius * (1 + depth * Math.cos(5 * angle - turn));
          return k % 2 === 0 ? x + r * Math.cos(angle) : 0.5 + r * Math.sin(angle);
        }),
      ],
    });
    const make = (backend: "cpu" | "gpu", finest: number): Promise<Made> =>
      Registration.create(star(0.5, 0.2, 0.1, 0), star(0.52, 0.24, 0.15, 0.1), { backend, finest });
    // An octahedron, turned about its axis.
    const octahedron = (turn: number) => ({
      kind: "mesh" as const,
      positions: Float64Array.from(
        [0, 1, 2, 3]
          .flatMap((k) => [Math.cos(turn + (k * Math.PI) / 2), Math.sin(turn + (k * Math.PI) / 2), 0])
          .concat([0, 0, 1, 0, 0, -1]),
        (x) => 0.5 + 0.3 * x,
      ),
      indices: Uint32Array.from([0, 1, 2, 3].flatMap((k) => [k, (k + 1) % 4, 4, (k + 1) % 4, k, 5])),
    });
    // Its starts in space, several dozen iterations of a few hundred dispatches, are tested natively.
    const solid = (backend: "cpu" | "gpu"): Promise<Made> =>
      Registration.create(octahedron(0), octahedron(0.2), { backend, finest: 4, align: "none" });
    const end = async (made: Made, meanwhile = () => {}) => {
      let status = await made.step(1);
      meanwhile();
      while (!status.finished) status = await made.step(2);
      const { verdict, mismatch, backend } = status;
      const deformation = [...made.deformation()];
      made.free();
      return { verdict, mismatch: mismatch.max, backend, deformation };
    };
    const expected = await end(await make("cpu", 6));
    const coarser = await end(await make("cpu", 5));
    const [one, other] = await Promise.all([make("gpu", 6), make("gpu", 5)]).then(([a, b]) =>
      Promise.all([end(a), end(b)]),
    );
    const lost = await end(await make("gpu", 5), () => {
      for (const device of devices) device.destroy();
    });
    const after = await end(await make("gpu", 5));
    const [solidExpected, solidFound] = [await end(await solid("cpu")), await end(await solid("gpu"))];
    return { expected, coarser, one, other, lost, after, solidExpected, solidFound };
  });
  type End = typeof ends.expected;
  const alike = (found: End, expected: End, cells: number) => {
    // But for the numbers in it.
    const words = ({ verdict }: End) => verdict?.replace(/[\d.]+/g, "#");
    expect(words(found)).toBe(words(expected));
    expect(Math.abs(found.mismatch - expected.mismatch)).toBeLessThan(0.02);
    const apart = found.deformation.map((x, k) => cells * Math.abs(x - expected.deformation[k]));
    expect(apart.reduce((most, x) => Math.max(most, x), 0)).toBeLessThan(0.05);
  };
  alike(ends.one, ends.expected, 64);
  for (const found of [ends.other, ends.lost, ends.after]) alike(found, ends.coarser, 32);
  alike(ends.solidFound, ends.solidExpected, 16);
  for (const { backend } of [ends.one, ends.other, ends.after, ends.solidFound])
    expect(backend).toMatch(/^gpu: .*swiftshader/i);
  expect(ends.lost.backend).toMatch(/^cpu: the graphics device was lost/);
  expect(problems).toEqual([]);
});
