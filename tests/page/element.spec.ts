/** The element and the anywidget: one file, in pages that know nothing else of thinshell. */

import { cpSync } from "node:fs";
import { AxeBuilder } from "@axe-core/playwright";
import { expect, type Page, test } from "@playwright/test";
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
  const painted = () =>
    canvas.evaluate((element: HTMLCanvasElement) => {
      const { data } = element.getContext("2d")?.getImageData(0, 0, element.width, element.height) ?? { data: [] };
      const colours = new Set(new Uint32Array((data as Uint8ClampedArray).buffer));
      const [red, green, blue] = [1, 3, 5].map((at) => {
        const ink = getComputedStyle(element).getPropertyValue("--ink").trim();
        return Number.parseInt(ink.slice(at, at + 2), 16);
      });
      return { count: colours.size, ink: colours.has(((255 << 24) | (blue << 16) | (green << 8) | red) >>> 0) };
    });
  expect((await painted()).count).toBeGreaterThan(100);
  // Its lines have the colour that the element has, in either scheme.
  for (const colorScheme of ["light", "dark"] as const) {
    await page.emulateMedia({ colorScheme });
    await page.evaluate(() => {
      const first = document.querySelector("#first");
      first?.setAttribute("view", "stretch");
      first?.setAttribute("controls", "view");
    });
    await expect.poll(async () => (await painted()).ink, colorScheme).toBe(true);
  }
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
  await page.getByRole("button", { name: "Another target" }).click();
  // A circle may be turned on its way to a circle, but its points go to the circle.
  await expect(model).toHaveText(/^stretch (2\.00|1\.99), /, { timeout: 45_000 });
  const [x, y] = ((await model.textContent()) ?? "").split("mapped ")[1].split(",").map(Number);
  expect(Math.hypot(x - 0.5, y - 0.5)).toBeCloseTo(0.3, 2);
  await page.getByRole("button", { name: "A target that is none" }).click();
  await expect(model).toContainText("each loop of the template must be at least three points");
  expect(seen.errors).toEqual([]);
});

/** A page with nothing but the file, and what the script puts there. */
async function bare(page: Page, html: string): Promise<void> {
  await page.route("**/bare.html", (route) =>
    route.fulfill({ contentType: "text/html", body: `<!doctype html><link rel="icon" href="data:,">${html}` }),
  );
  await page.goto(`${server.address}bare.html`);
}

const EASY = "v=2&preset=ellipse&finest=5";

test("each attribute that is wrong is said, and no more once it is right", async ({ page }) => {
  const seen = watch(page);
  await bare(
    page,
    `<script type="module" src="./thin-shell-match.js"></script>
     <thin-shell-match state="${EASY}" view="upside-down" morph="2" controls="erase"></thin-shell-match>`,
  );
  const element = page.locator("thin-shell-match");
  const said = element.getByRole("status");
  await expect(said).toContainText("There is no view “upside-down”; there are grid,");
  await element.evaluate((node) => node.setAttribute("view", "grid"));
  await expect(said).toHaveText("Morph must be a number from 0 to 1.");
  await element.evaluate((node) => node.removeAttribute("morph"));
  await expect(said).toHaveText("There is no control “erase”; there are view, morph, numbers.");
  await expect(element.getByLabel("View")).toHaveCount(0);
  await element.evaluate((node) => node.setAttribute("controls", "view numbers"));
  await expect(element.getByLabel("View")).toHaveValue("grid");
  await expect(said).toContainText("Fits", { timeout: 45_000 });
  await element.evaluate((node) => node.setAttribute("state", "space=1&reference=sphere"));
  await expect(said).toHaveText("It is no link of this page.");
  expect(seen.errors).toEqual([]);
});

test("what was set before the module came counts, and matches are told of after new controls and a new place", async ({
  page,
}) => {
  await bare(
    page,
    `<main><thin-shell-match></thin-shell-match></main><script>
      const element = document.querySelector("thin-shell-match");
      const circle = (a, b) => [Array.from({ length: 60 }, (_, i) => [0.5 + a * Math.cos(i / 9.55), 0.5 + b * Math.sin(i / 9.55)])];
      Object.assign(element, { reference: circle(0.2, 0.2), template: circle(0.3, 0.15), settings: { finest: 5 }, view: "stretch" });
      window.matches = 0;
      element.addEventListener("match", () => { window.matches += 1; });
    </script><script type="module" src="./thin-shell-match.js"></script>`,
  );
  const element = page.locator("thin-shell-match");
  const matches = () => page.evaluate(() => (window as unknown as { matches: number }).matches);
  await expect.poll(matches, { timeout: 45_000 }).toBe(1);
  await expect(element.getByLabel("View")).toHaveValue("stretch");
  await element.evaluate((node) => {
    node.setAttribute("controls", "numbers");
    Object.assign(node, { settings: { finest: 5, bending: 0 } });
  });
  await expect.poll(matches, { timeout: 45_000 }).toBe(2);
  // Taken out while it is at work, and put in elsewhere.
  await element.evaluate((node) => {
    Object.assign(node, { settings: { finest: 5 } });
    node.remove();
    document.body.append(node);
  });
  await expect.poll(matches, { timeout: 45_000 }).toBe(3);
  await expect(element.getByRole("status")).toContainText("Fits");
  const refused = await element.evaluate((node) => {
    const given = { reference: null, template: "circle", pins: [[1, 2]], settings: 3, morph: Number.NaN, view: "" };
    return Object.entries(given).map(([name, value]) => {
      try {
        Object.assign(node, { [name]: value });
        return `${name} was taken`;
      } catch (error) {
        return (error as Error).message;
      }
    });
  });
  expect(refused).toEqual([
    "the reference must be a list of loops",
    "the template must be a list of loops",
    "pins must be a list of [x, y, u, v]: a point of the reference and one of the template",
    "settings must be an object, like { bending: 0 }",
    "morph must be a number from 0 to 1",
    expect.stringContaining("there is no view “”"),
  ]);
  expect(await matches()).toBe(3);
});
