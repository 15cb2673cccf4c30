/** A complete session by the keyboard alone, and the focus is never lost on the way. */

import { readFileSync } from "node:fs";
import { expect, type Locator, type Page, test } from "@playwright/test";
import { button, drawn, finished, settings, surface, value, watch } from "./handles";

/** Tab by Tab, as somebody without a pointer goes there. */
async function go(page: Page, to: Locator, key: "Tab" | "Shift+Tab" = "Tab"): Promise<void> {
  await expect(to).toBeVisible();
  for (let step = 0; step < 120; step += 1) {
    if (await to.evaluate((element) => element === document.activeElement)) return;
    await page.keyboard.press(key);
  }
  throw new Error(`the focus does not come to ${to}`);
}

async function keys(page: Page, key: string, times: number): Promise<void> {
  for (let k = 0; k < times; k += 1) await page.keyboard.press(key);
}

/** Something has the focus, and it is seen. */
async function focused(page: Page): Promise<void> {
  expect(await page.evaluate(() => document.activeElement !== document.body && document.hasFocus())).toBe(true);
}

test("a shape is drawn, matched under another setting, looked at in another view and saved", async ({ page }) => {
  test.slow();
  const seen = watch(page);
  await page.goto("./#v=1&preset=ellipse&finest=5&match=later");
  const told = page.locator(".sketch-tools [aria-live]");

  await go(page, button(page, "Polygon"));
  await page.keyboard.press("Enter");
  await expect(button(page, "Polygon")).toHaveAttribute("aria-pressed", "true");
  const reference = surface(page, "Reference");
  await go(page, reference);
  await expect(reference).toHaveAccessibleDescription(/arrow keys move a cursor/);
  // A square about the middle, with a corner too many that is deleted, and one that is moved.
  await keys(page, "ArrowLeft", 10);
  await keys(page, "ArrowDown", 10);
  await expect(told).toHaveText("0.3 across, 0.3 up.");
  await page.keyboard.press("Enter");
  await expect(told).toHaveText("Point 1 set: 0.3 across, 0.3 up.");
  await keys(page, "ArrowRight", 20);
  await page.keyboard.press("Space");
  await keys(page, "ArrowUp", 10);
  await page.keyboard.press("Space");
  await page.keyboard.press("Delete");
  await expect(told).toHaveText("Point 3 deleted; 2 points left.");
  await keys(page, "ArrowUp", 5);
  await page.keyboard.press("Space");
  await keys(page, "ArrowLeft", 20);
  await keys(page, "ArrowDown", 3);
  await page.keyboard.press("Space");
  await page.keyboard.press("PageDown");
  await keys(page, "PageDown", 2);
  await expect(told).toHaveText("Point 3 of 4: 0.7 across, 0.6 up. Space takes it up, Delete deletes it.");
  await page.keyboard.press("Space");
  await keys(page, "ArrowUp", 5);
  await page.keyboard.press("Space");
  await expect(told).toHaveText("Point 3 moved: 0.7 across, 0.7 up.");
  await page.keyboard.press("PageDown");
  await page.keyboard.press("PageDown");
  await expect(told).toHaveText(/^Point 1 of 4: 0.3 across, 0.3 up. .* Enter closes the outline.$/);
  await page.keyboard.press("Enter");
  await expect(told).toHaveText("The reference has changed.");
  await expect(reference).toBeFocused();
  await expect.poll(() => drawn(page, "Reference")).toBeTruthy();

  await go(page, button(page, "Match"));
  await page.keyboard.press("Enter");
  await finished(page);
  await focused(page);
  const before = await value(page, "total");

  await go(page, settings(page));
  await page.keyboard.press("Enter");
  const bending = page.getByLabel("Bending", { exact: true });
  await go(page, bending);
  await page.keyboard.press("Control+a");
  await page.keyboard.type("0");
  await page.keyboard.press("Enter");
  await expect(page.getByRole("status")).toContainText("The settings have changed: press Match.");
  await go(page, button(page, "Match"), "Shift+Tab");
  await page.keyboard.press("Enter");
  await expect(page.getByText("Computed with other settings")).toHaveCount(0);
  await finished(page);
  expect(await value(page, "total")).toBeLessThan(before);

  const view = page.getByRole("combobox", { name: "View" });
  await go(page, view);
  await page.keyboard.press("ArrowDown");
  await expect(view).toHaveValue("image");
  await expect(page.locator(".legend")).toBeVisible();
  await focused(page);

  await go(page, page.locator(".save summary"));
  await page.keyboard.press("Enter");
  await go(page, button(page, "Everything (JSON)"));
  const [download] = await Promise.all([page.waitForEvent("download"), page.keyboard.press("Enter")]);
  const saved = JSON.parse(readFileSync(await download.path(), "utf8"));
  expect(saved.settings.bending).toBe(0);
  expect(saved.match.report.level).toBe(5);
  await focused(page);
  expect(seen.errors).toEqual([]);
});

test("a circle and a mirrored half are drawn by keys as well", async ({ page }) => {
  await page.goto("./#v=1&preset=star&finest=5&match=later");
  const told = page.locator(".sketch-tools [aria-live]");
  await go(page, button(page, "Circle"));
  await page.keyboard.press("Enter");
  await go(page, surface(page, "Template"));
  await page.keyboard.press("Enter");
  await expect(told).toContainText("Middle set: 0.5 across, 0.5 up.");
  await keys(page, "ArrowRight", 10);
  await expect(told).toHaveText("0.7 across, 0.5 up: radius 0.2.");
  await page.keyboard.press("Enter");
  await expect.poll(() => drawn(page, "Template")).toBeTruthy();
  await go(page, button(page, "Mirror"), "Shift+Tab");
  await page.keyboard.press("Enter");
  await go(page, surface(page, "Reference"));
  await keys(page, "ArrowUp", 10);
  await page.keyboard.press("Enter");
  await keys(page, "ArrowRight", 10);
  await page.keyboard.press("Enter");
  await keys(page, "ArrowDown", 15);
  await page.keyboard.press("Enter");
  await page.keyboard.press("Enter");
  await expect(told).toHaveText("The reference has changed.");
  await expect(surface(page, "Reference")).toBeFocused();
  await expect.poll(() => drawn(page, "Reference")).toBeTruthy();
  await page.keyboard.press("Control+z");
  await expect.poll(() => new URL(page.url()).hash).toContain("reference=");
});
