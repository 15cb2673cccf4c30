/** A finished curve is opened again by its points: moved, added, deleted, by hand and by key. */

import { AxeBuilder } from "@axe-core/playwright";
import { expect, type Page, test } from "@playwright/test";
import { PRESETS } from "../../www/shapes/presets";
import { knotsOf } from "../../www/tools/knots";
import { button, drawn, loops, surface, watch } from "./handles";

/** An example. */
const PLAIN = "./#v=1&preset=star&finest=5&match=later";

type Spot = readonly [number, number];

const SQUARE: readonly Spot[] = [
  [0.3, 0.3],
  [0.7, 0.3],
  [0.7, 0.7],
  [0.3, 0.7],
];

const [STAR] = (PRESETS.find(({ id }) => id === "star") ?? PRESETS[0]).reference;

const told = (page: Page) => page.locator(".sketch-tools [aria-live]");

async function place(page: Page, [x, y]: Spot): Promise<[number, number]> {
  const box = await surface(page, "Reference").boundingBox();
  if (!box) throw new Error("the reference is not on the page");
  return [box.x + x * box.width, box.y + (1 - y) * box.height];
}

async function press(page: Page, spot: Spot): Promise<void> {
  await page.mouse.click(...(await place(page, spot)));
}

async function drag(page: Page, from: Spot, to: Spot): Promise<void> {
  await page.mouse.move(...(await place(page, from)));
  await page.mouse.down();
  await page.mouse.move(...(await place(page, [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2])));
  await page.mouse.move(...(await place(page, to)));
  await page.mouse.up();
}

/** The area that the reference in the address encloses. */
function area(page: Page): number {
  let sum = 0;
  for (const loop of loops(drawn(page, "Reference")))
    loop.forEach(([x, y], i) => {
      const [u, v] = loop[(i + 1) % loop.length];
      sum += (x * v - u * y) / 2;
    });
  return Math.abs(sum);
}

/** Whether the reference comes this close to the spot. */
function reaches(page: Page, [x, y]: Spot): boolean {
  return loops(drawn(page, "Reference"))
    .flat()
    .some((point) => Math.hypot(point[0] - x, point[1] - y) < 0.01);
}

async function square(page: Page): Promise<void> {
  await page.goto(PLAIN);
  await button(page, "Clear reference").click();
  await button(page, "Polygon").click();
  for (const corner of SQUARE) await press(page, corner);
  await button(page, "Close outline").click();
  await expect.poll(() => area(page)).toBeCloseTo(0.16, 2);
  // As another day: nothing is left of how it was drawn.
  await page.reload();
  await button(page, "Points").click();
  await expect(button(page, "Points")).toHaveAttribute("aria-pressed", "true");
}

test("a polygon's corner is dragged, a point is added and dragged, both are undone", async ({ page }) => {
  const seen = watch(page);
  await square(page);
  await drag(page, [0.7, 0.7], [0.85, 0.8]);
  await expect.poll(() => reaches(page, [0.85, 0.8])).toBe(true);
  expect(reaches(page, [0.3, 0.3])).toBe(true);
  await drag(page, [0.5, 0.3], [0.5, 0.1]);
  await expect.poll(() => reaches(page, [0.5, 0.1])).toBe(true);
  // Straight from corner to corner.
  expect(reaches(page, [0.4, 0.2])).toBe(true);
  await button(page, "Undo").click();
  await button(page, "Undo").click();
  await expect.poll(() => area(page)).toBeCloseTo(0.16, 2);
  expect(seen.errors).toEqual([]);
});

test("a press marks a point, which the button deletes; a curve keeps three", async ({ page }) => {
  await square(page);
  await expect(button(page, "Delete point")).toHaveCount(0);
  await press(page, [0.7, 0.3]);
  await button(page, "Delete point").click();
  await expect(told(page)).toHaveText(/^Point \d deleted; 3 points left\.$/);
  await expect.poll(() => area(page)).toBeCloseTo(0.08, 2);
  await expect(surface(page, "Reference")).toBeFocused();
  await press(page, [0.7, 0.7]);
  await button(page, "Delete point").click();
  await expect(told(page)).toHaveText("A closed curve keeps three points.");
  expect(area(page)).toBeCloseTo(0.08, 2);
});

test("by keyboard a point is found, carried, put back, carried again and deleted", async ({ page }) => {
  await square(page);
  await surface(page, "Reference").focus();
  await page.keyboard.press("PageDown");
  await expect(told(page)).toHaveText(/^Point 1 of 4: .*Space takes it up, Delete deletes it\.$/);
  await page.keyboard.press("Space");
  for (let k = 0; k < 5; k += 1) await page.keyboard.press("ArrowUp");
  await page.keyboard.press("Escape");
  await expect(told(page)).toHaveText("Put back.");
  await expect.poll(() => area(page)).toBeCloseTo(0.16, 2);
  await page.keyboard.press("Space");
  for (let k = 0; k < 5; k += 1) await page.keyboard.press("ArrowUp");
  await page.keyboard.press("Space");
  await expect(told(page)).toHaveText(/^Point 1 moved: /);
  await expect.poll(() => Math.abs(area(page) - 0.16)).toBeGreaterThan(0.01);
  await page.keyboard.press("Control+z");
  await expect.poll(() => area(page)).toBeCloseTo(0.16, 2);
  await page.keyboard.press("Delete");
  await expect(told(page)).toHaveText("Point 1 deleted; 3 points left.");
  // The cursor has stayed where the corner was.
  await page.keyboard.press("Enter");
  await expect(told(page)).toHaveText("There is no curve here: Page Down goes to the next point.");
});

test("by keyboard a point is added where the cursor meets the curve", async ({ page }) => {
  await square(page);
  await surface(page, "Reference").focus();
  // From the middle of the surface to the lower edge.
  for (let k = 0; k < 10; k += 1) await page.keyboard.press("ArrowDown");
  await page.keyboard.press("Enter");
  await expect(told(page)).toHaveText(/^Point \d added: arrow keys move it, Space sets it down\.$/);
  for (let k = 0; k < 5; k += 1) await page.keyboard.press("ArrowDown");
  await page.keyboard.press("Enter");
  await expect.poll(() => area(page)).toBeCloseTo(0.18, 2);
});

test.describe("on a phone", () => {
  test.use({ viewport: { width: 320, height: 640 }, hasTouch: true });

  test("a finger marks a point and deletes it, and everything has room", async ({ page }) => {
    await page.goto(PLAIN);
    await button(page, "Points").click();
    const canvas = surface(page, "Reference");
    await canvas.scrollIntoViewIfNeeded();
    const before = drawn(page, "Reference");
    const { x, y } = knotsOf(STAR)[0].point;
    await page.touchscreen.tap(...(await place(page, [x, y])));
    await expect(button(page, "Delete point")).toBeVisible();
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(320);
    expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
    await button(page, "Delete point").click();
    await expect.poll(() => drawn(page, "Reference")).not.toBe(before);
  });
});
