/** The element and the anywidget: one file, in pages that know nothing else of thinshell. */

import { cpSync } from "node:fs";
import { AxeBuilder } from "@axe-core/playwright";
import { expect, test } from "@playwright/test";
import { bundleElement } from "../../scripts/element.mjs";
import { watch } from "./handles";
import { type Server, serving } from "./server";

const FOLDER = "target/element";
let server: Server;

test.beforeAll(async () => {
  test.setTimeout(120_000);
  await bundleElement(FOLDER);
  cpSync("public/demos", FOLDER, { recursive: true });
  server = await serving(FOLDER);
});
test.afterAll(() => server.close());

test("elements match what their attributes and properties say, each for itself", async ({ page }) => {
  test.slow();
  const seen = watch(page);
  await page.goto(`${server.address}element.html`);
  await expect(page.locator("#said")).toHaveText(/^Fits: .* The middle goes to 0\.\d{3}, 0\.\d{3}\.$/, {
    timeout: 45_000,
  });
  await expect(page.locator("#stretch")).toHaveText("1.02", { timeout: 45_000 });
  const [first, second] = [page.locator("#first"), page.locator("#second")];
  await expect(first.getByLabel("View")).toHaveValue("grid");
  await expect(second.getByLabel("View")).toHaveValue("stretch");
  await first.getByLabel("View").selectOption("determinant");
  await expect(second.getByLabel("View")).toHaveValue("stretch");
  await expect(second.getByLabel("Morph")).toHaveCount(0);
  await page.getByRole("button", { name: "Make the ellipse longer" }).click();
  await expect(page.locator("#stretch")).toHaveText("1.45", { timeout: 45_000 });
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  const asked = seen.requests.filter((address) => !/^(data|blob):/.test(address));
  expect(asked.map((address) => new URL(address).pathname).sort()).toEqual([
    "/demo.css",
    "/element.html",
    "/element.js",
    "/thin-shell-match.js",
  ]);
  expect(seen.errors).toEqual([]);
});

test("an element draws something, and follows its place in the page", async ({ page }) => {
  await page.goto(`${server.address}element.html`);
  const canvas = page.locator("#first canvas");
  await expect(canvas).toHaveAttribute("aria-label", /^matched/, { timeout: 45_000 });
  const painted = await canvas.evaluate((element: HTMLCanvasElement) => {
    const { data } = element.getContext("2d")?.getImageData(0, 0, element.width, element.height) ?? { data: [] };
    return new Set(new Uint32Array((data as Uint8ClampedArray).buffer)).size;
  });
  expect(painted).toBeGreaterThan(100);
  await page.evaluate(() => {
    const first = document.querySelector("#first");
    if (first) document.querySelector("main")?.append(first);
  });
  await expect(canvas).toHaveAttribute("aria-label", /^matched/, { timeout: 45_000 });
});

test("what cannot be read is said in the element, and told to whoever listens", async ({ page }) => {
  await page.goto(`${server.address}element.html`);
  const told = await page.evaluate(
    () =>
      new Promise((resolve) => {
        const element = document.createElement("thin-shell-match");
        element.addEventListener("problem", (event) => resolve((event as CustomEvent).detail));
        element.id = "third";
        document.querySelector("main")?.append(element);
        element.setAttribute("state", "v=2&preset=unknown");
      }),
  );
  expect(told).toBe("There is no example called “unknown”.");
  await expect(page.locator("#third").getByRole("status")).toHaveText("There is no example called “unknown”.");
  const refused = await page.evaluate(() => {
    try {
      Object.assign(document.querySelector("#third") ?? {}, { reference: [[0, 1]] });
      return "taken";
    } catch (error) {
      return String(error);
    }
  });
  expect(refused).toContain("each loop of the reference must be at least three points");
});

test("as an anywidget it takes shapes in, and gives the report and φ at points out", async ({ page }) => {
  test.slow();
  const seen = watch(page);
  await page.goto(`${server.address}widget.html`);
  const model = page.locator("#model");
  await expect(model).toHaveText(/^stretch 1\.63, mapped 0\.8\d\d,0\.(49|50)\d$/, { timeout: 45_000 });
  await page.getByRole("button", { name: "Another template" }).click();
  // A circle may be turned on its way to a circle, but its points go to the circle.
  await expect(model).toHaveText(/^stretch (2\.00|1\.99), /, { timeout: 45_000 });
  const [x, y] = ((await model.textContent()) ?? "").split("mapped ")[1].split(",").map(Number);
  expect(Math.hypot(x - 0.5, y - 0.5)).toBeCloseTo(0.3, 2);
  await page.getByRole("button", { name: "A template that is none" }).click();
  await expect(model).toContainText("each loop of the template must be at least three points");
  expect(seen.errors).toEqual([]);
});
