/** Circle, polygon, mirror, smoothing, and what two shapes do to each other: by hand and by key. */

import { AxeBuilder } from "@axe-core/playwright";
import { expect, type Page, test } from "@playwright/test";
import { button, clear, drawn, loops as loopsIn, stroke, surface, watch } from "./handles";

const PLAIN = "./#v=1&preset=star&finest=5&match=later";

type Spot = readonly [number, number];

/** Every loop of a shape in the address. */
function loops(page: Page, side: "Reference" | "Template"): [number, number][][] {
  return loopsIn(drawn(page, side));
}

async function press(page: Page, side: "Reference" | "Template", [x, y]: Spot): Promise<void> {
  const box = await surface(page, side).boundingBox();
  if (!box) throw new Error(`the ${side} surface is not on the page`);
  await page.mouse.click(box.x + x * box.width, box.y + (1 - y) * box.height);
}

async function take(page: Page, name: string): Promise<void> {
  await button(page, name).click();
  await expect(button(page, name)).toHaveAttribute("aria-pressed", "true");
}

const told = (page: Page) => page.locator(".sketch-tools [aria-live]");
const guide = (page: Page) => page.locator(".guide");

test("a circle is dragged from its middle, and takes one undo", async ({ page }) => {
  const seen = watch(page);
  await page.goto(PLAIN);
  await clear(page);
  await take(page, "Circle");
  await expect(guide(page)).toContainText("Press where the middle is to be");
  await stroke(page, "Template", [
    [0.4, 0.5],
    [0.5, 0.5],
    [0.6, 0.5],
  ]);
  await expect.poll(() => loops(page, "Template").length).toBe(1);
  for (const [x, y] of loops(page, "Template")[0]) expect(Math.hypot(x - 0.4, y - 0.5)).toBeCloseTo(0.2, 2);
  await expect(told(page)).toHaveText("The target is one closed curve now.");
  await button(page, "Undo").click();
  await expect.poll(() => loops(page, "Template").length).toBe(0);
  expect(seen.errors).toEqual([]);
});

test("a circle too small or over the border is asked about like any other curve", async ({ page }) => {
  await page.goto(PLAIN);
  await clear(page);
  await take(page, "Circle");
  await stroke(page, "Reference", [
    [0.9, 0.5],
    [0.8, 0.5],
    [0.7, 0.5],
  ]);
  await expect(page.getByRole("alert")).toContainText("crosses the border");
  await button(page, "Move it inside").click();
  await expect
    .poll(() =>
      Math.max(
        ...loops(page, "Reference")
          .flat()
          .map(([x]) => x),
      ),
    )
    .toBeLessThan(0.97);
});

const TRIANGLE: readonly Spot[] = [
  [0.3, 0.3],
  [0.7, 0.3],
  [0.5, 0.7],
];

for (const [way, close] of [
  ["the first corner again", (page: Page) => press(page, "Reference", TRIANGLE[0])],
  ["the last corner once more", (page: Page) => press(page, "Reference", TRIANGLE[2])],
  ["Enter", (page: Page) => page.keyboard.press("Enter")],
  ["the button", (page: Page) => button(page, "Close outline").click()],
] as const) {
  test(`a polygon has the corners that are pressed, and is closed by ${way}`, async ({ page }) => {
    await page.goto(PLAIN);
    await clear(page);
    await take(page, "Polygon");
    for (const corner of TRIANGLE) await press(page, "Reference", corner);
    await expect(guide(page)).toContainText("3 points");
    await close(page);
    await expect.poll(() => loops(page, "Reference").length).toBe(1);
    for (const [x, y] of TRIANGLE) {
      const away = loops(page, "Reference")[0].map(([u, v]) => Math.hypot(u - x, v - y));
      expect(Math.min(...away)).toBeLessThan(0.005);
    }
    await expect(surface(page, "Reference")).toBeFocused();
  });
}

test("two corners are no outline; one is taken back by Ctrl Z and by Delete, all are given up by Escape", async ({
  page,
}) => {
  await page.goto(PLAIN);
  await clear(page);
  await take(page, "Polygon");
  for (const corner of TRIANGLE) await press(page, "Reference", corner);
  await page.keyboard.press("Control+z");
  await expect(guide(page)).toContainText("2 points");
  await page.keyboard.press("Enter");
  await expect(told(page)).toHaveText("2 points so far: an outline needs 3.");
  await page.keyboard.press("Delete");
  await expect(guide(page)).toContainText("1 point:");
  await page.keyboard.press("Escape");
  await expect(told(page)).toHaveText("The outline is given up.");
  await expect(button(page, "Close outline")).toHaveCount(0);
  // The history has not been touched.
  await expect(button(page, "Redo")).toBeDisabled();
});

test("the mirrored half makes a shape that is its own mirror image", async ({ page }) => {
  await page.goto(PLAIN);
  await clear(page);
  await take(page, "Mirror");
  const half = Array.from({ length: 30 }, (_, i): Spot => {
    const t = (Math.PI * i) / 29;
    return [0.5 + 0.3 * Math.sin(t) * (1 + 0.3 * Math.cos(3 * t)), 0.5 + 0.3 * Math.cos(t)];
  });
  await stroke(page, "Reference", half);
  await expect.poll(() => loops(page, "Reference").length).toBe(1);
  const points = loops(page, "Reference")[0];
  for (const [x, y] of points) {
    expect(Math.min(...points.map(([u, v]) => Math.hypot(1 - x - u, y - v)))).toBeLessThan(0.012);
  }
  expect(Math.max(...points.map(([x]) => x))).toBeGreaterThan(0.7);
});

test("smoothing is seen while the slider moves, is one step to undo, and goes both ways", async ({ page }) => {
  await page.goto(PLAIN);
  await press(page, "Reference", [0.5, 0.76]);
  const slider = page.getByRole("slider", { name: "Smooth" });
  await expect(slider).toHaveValue("0");
  const top = () =>
    Math.max(
      ...loops(page, "Reference")
        .flat()
        .map(([, y]) => y),
    );
  await slider.fill("90");
  await expect.poll(() => loops(page, "Reference").length).toBe(1);
  expect(top()).toBeLessThan(0.74);
  await slider.fill("0");
  await expect.poll(top).toBeGreaterThan(0.75);
  await slider.fill("60");
  await expect(slider).toHaveAttribute("aria-valuetext", "60 %");
  await button(page, "Undo").click();
  await expect(slider).toHaveValue("0");
  await button(page, "Undo").click();
  await expect(slider).toHaveValue("90");
  await button(page, "Undo").click();
  await expect(button(page, "Undo")).toBeDisabled();
});

test("however many keys it takes, smoothing by key is one step to undo", async ({ page }) => {
  await page.goto(PLAIN);
  await press(page, "Template", [0.5, 0.74]);
  const slider = page.getByRole("slider", { name: "Smooth" });
  await slider.focus();
  for (let k = 0; k < 6; k += 1) await page.keyboard.press("PageUp");
  await expect(told(page)).toContainText("The curve of the target is smoothed by 60 %.");
  await page.keyboard.press("Control+z");
  await expect(slider).toHaveValue("0");
  await expect(button(page, "Undo")).toBeDisabled();
});

test("a hole is deleted alone, and the focus stays with the shape", async ({ page }) => {
  await page.goto(PLAIN);
  await clear(page);
  await take(page, "Circle");
  for (const radius of [0.3, 0.1]) {
    await stroke(page, "Reference", [
      [0.5, 0.5],
      [0.5, 0.5 + radius / 2],
      [0.5, 0.5 + radius],
    ]);
  }
  await expect.poll(() => loops(page, "Reference").length).toBe(2);
  await button(page, "Delete curve").click();
  await expect.poll(() => loops(page, "Reference").length).toBe(1);
  await expect(told(page)).toHaveText("Curve deleted from the reference.");
  await expect(surface(page, "Reference")).toBeFocused();
});

async function exchange(page: Page, what: string): Promise<void> {
  await page.locator("summary[aria-label='Swap or copy the shapes']").click();
  await button(page, what).click();
}

test("shapes are swapped with their pins, and swapped back by undo", async ({ page }) => {
  await page.goto(PLAIN);
  await take(page, "Pin");
  await press(page, "Reference", [0.5, 0.5]);
  await press(page, "Template", [0.2, 0.8]);
  const pins = () => new URLSearchParams(new URL(page.url()).hash.slice(1)).get("pins");
  await expect.poll(pins).toBeTruthy();
  const before = pins();
  await exchange(page, "Swap the shapes");
  await expect(told(page)).toHaveText("Swapped: the reference is what the target was, and the pins lead back.");
  await expect.poll(pins).not.toBe(before);
  expect(loopsIn(pins())[0][0][0]).toBeCloseTo(0.2, 2);
  const [reference, template] = [drawn(page, "Reference"), drawn(page, "Template")];
  expect(reference).not.toBe(template);
  await button(page, "Undo").click();
  await expect.poll(pins).toBe(before);
});

test("a copied shape is the other one; the pins that led to what is gone go with a sentence, and come back", async ({
  page,
}) => {
  await page.goto(PLAIN);
  await take(page, "Pin");
  await press(page, "Reference", [0.5, 0.5]);
  await press(page, "Template", [0.2, 0.8]);
  await exchange(page, "Copy the reference to the target");
  await expect(page.getByRole("alert")).toContainText("The pin is deleted, for the target that it led to is gone.");
  await expect.poll(() => drawn(page, "Template")).toBeTruthy();
  expect(drawn(page, "Template")).toBe(drawn(page, "Reference"));
  await button(page, "Undo").click();
  await expect(page.getByRole("alert")).toBeEmpty();
  await expect(button(page, "Delete all pins")).toBeVisible();
});

for (const [scheme, width] of [
  ["light", 1280],
  ["dark", 390],
] as const) {
  test(`an open outline has no accessibility violation (${scheme}, ${width})`, async ({ page }) => {
    await page.emulateMedia({ colorScheme: scheme });
    await page.setViewportSize({ width, height: 844 });
    await page.goto(PLAIN);
    await take(page, "Polygon");
    for (const corner of TRIANGLE) await press(page, "Reference", corner);
    await expect(button(page, "Close outline")).toBeVisible();
    expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
    await press(page, "Reference", TRIANGLE[0]);
    await expect(page.getByRole("slider", { name: "Smooth" })).toBeVisible();
    expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
  });
}
