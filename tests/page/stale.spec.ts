/** A result belongs to what it was computed from: no door out of the page pairs it with anything else. */

import { readFileSync } from "node:fs";
import { AxeBuilder } from "@axe-core/playwright";
import { expect, type Page, test } from "@playwright/test";
import { button, choose, finished, picture, result, surface, value } from "./handles";

const EASY = "./#v=1&preset=ellipse&finest=6";

/** A match on 65², and then another grid chosen that nobody has pressed Match for. */
async function stale(page: Page): Promise<void> {
  await page.goto(EASY);
  await finished(page);
  await choose(page, "Finest grid", "33 × 33");
  await expect(page.getByRole("status")).toContainText("The settings have changed: press Match.");
}

async function save(page: Page, label: string): Promise<{ name: string; text: string }> {
  await page.getByText("Save", { exact: true }).click();
  const [download] = await Promise.all([page.waitForEvent("download"), button(page, label).click()]);
  return { name: download.suggestedFilename(), text: readFileSync(await download.path(), "utf8") };
}

test("a setting that differs marks the result, and set back it is the answer again", async ({ page }) => {
  await stale(page);
  await expect(result(page)).toHaveAccessibleName(/with other settings than those chosen now/);
  await expect(page.getByText("Computed with other settings")).toBeVisible();
  await choose(page, "Finest grid", "65 × 65");
  await expect(page.getByRole("status")).toContainText("Fits: nowhere more than");
  await expect(page.getByText("Computed with other settings")).toHaveCount(0);
});

test("a saved file has the settings that its φ was computed with", async ({ page }) => {
  await stale(page);
  const { name, text } = await save(page, "Everything (JSON)");
  const { settings, match } = JSON.parse(text);
  expect([settings.finest, match.report.level]).toEqual([6, 6]);
  expect(name).toBe("thinshell-match-65x65.json");
});

test("a drawing and a table are of the match that is shown, with its own band", async ({ page }) => {
  await page.goto(EASY);
  await finished(page);
  const [drawing, table] = [await save(page, "Drawing (SVG)"), await save(page, "Matched points (CSV)")];
  await page.locator("summary", { hasText: "Settings" }).click();
  await page.getByText("For those who know the paper").click();
  await page.getByLabel("Band σ", { exact: true }).fill("0.2");
  await page.getByLabel("Band σ", { exact: true }).press("Enter");
  await expect(page.getByText("Computed with other settings")).toBeVisible();
  expect(await save(page, "Drawing (SVG)")).toEqual(drawing);
  expect(await save(page, "Matched points (CSV)")).toEqual(table);
});

test("the picture does not change with a setting that it was not computed with", async ({ page }) => {
  await page.goto(EASY);
  await finished(page);
  const before = await picture(result(page));
  await choose(page, "Finest grid", "33 × 33");
  await expect(page.getByText("Computed with other settings")).toBeVisible();
  expect(await picture(result(page))).toBe(before);
});

test("a link has the settings chosen now, and whoever opens it gets the match of those", async ({ page, context }) => {
  await stale(page);
  await expect.poll(() => page.url()).toContain("finest=5");
  const other = await context.newPage();
  await other.goto(page.url());
  await finished(other);
  expect(await value(other, "level")).toBe(5);
});

test("Live switched on over a stale result computes a new one", async ({ page }) => {
  await stale(page);
  await page.getByRole("switch", { name: "Live" }).click();
  await finished(page);
  await expect.poll(() => value(page, "level")).toBe(5);
  await expect(page.getByText("Computed with other settings")).toHaveCount(0);
});

test("with changed shapes there is nothing to save but those, until they are matched", async ({ page }) => {
  await page.goto(EASY);
  await finished(page);
  await surface(page, "Template").press("ArrowLeft");
  await expect(page.getByRole("status")).toContainText("The shapes have changed: press Match.");
  const { name, text } = await save(page, "Everything (JSON)");
  expect([name, JSON.parse(text).match]).toEqual(["thinshell-shapes.json", null]);
});

for (const colorScheme of ["light", "dark"] as const) {
  test(`a stale result can be read like any other (${colorScheme})`, async ({ page }) => {
    await page.emulateMedia({ colorScheme });
    await stale(page);
    await expect(page.getByText("Computed with other settings")).toBeVisible();
    expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  });
}
