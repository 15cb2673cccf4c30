import { expect, test } from "@playwright/test";
import { PRESETS } from "../../www/shapes/presets";
import {
  button,
  choose,
  clear,
  ellipse,
  finished,
  loaded,
  paint,
  picture,
  result,
  stroke,
  surface,
  value,
  watch,
} from "./handles";

test("two curves drawn with the mouse are matched within half a cell and without a fold", async ({ page }) => {
  const seen = watch(page);
  const whole = loaded(page);
  await page.goto("./");
  await whole;
  await page.waitForLoadState("networkidle");
  seen.requests.length = 0;

  await clear(page);
  await stroke(page, "Reference", ellipse(0.2, 0.2));
  await stroke(page, "Template", ellipse(0.28, 0.18, 0.52, 0.48));
  await button(page, "Match").click();
  await finished(page);

  expect(await value(page, "mismatch-max")).toBeLessThan(0.5);
  expect(await value(page, "mismatch-mean")).toBeLessThanOrEqual(await value(page, "mismatch-max"));
  expect(await value(page, "least-determinant")).toBeGreaterThan(0);
  expect(await value(page, "level")).toBe(7);
  expect(await value(page, "iteration")).toBeGreaterThan(0);
  expect(await value(page, "total")).toBeGreaterThan(0);
  await expect(page.getByRole("status")).toContainText("Converged");
  await expect(result(page)).toHaveAttribute("aria-label", /matched, at most .* cells off/);

  const picture = await paint(result(page));
  expect(picture.painted).toBeGreaterThan(0.05);
  expect(picture.colours).toBeGreaterThan(200);
  expect(seen.errors).toEqual([]);
  expect(seen.requests).toEqual([]);
});

test("the status shows the run as it goes, and the end only at the end", async ({ page }) => {
  await page.goto("./#v=1&preset=star&finest=6&minimizer=ncg&match=later");
  const status = page.getByRole("status");
  await expect(status.locator("data")).toHaveCount(0);
  await expect(page.getByRole("progressbar")).toHaveCount(0);
  await button(page, "Match").click();
  await expect(status.locator('data[data-name="level"]')).toBeVisible();
  await expect(page.getByRole("progressbar")).toHaveAttribute("aria-valuenow", /\d+/);
  await finished(page);
  await expect(page.getByRole("progressbar")).toHaveCount(0);
});

test("the slider morphs between the identity and the match", async ({ page }) => {
  await page.goto("./#v=1&preset=ellipse&finest=5&match=later");
  await expect(page.getByRole("slider", { name: "Morph" })).toBeDisabled();
  const shown = () => picture(result(page));
  await button(page, "Match").click();
  await finished(page);
  const matched = await shown();
  await page.getByRole("slider", { name: "Morph" }).fill("0");
  await expect.poll(shown).not.toBe(matched);
  await page.getByRole("slider", { name: "Morph" }).fill("100");
  await expect.poll(shown).toBe(matched);
});

test("the morph plays, and only steps where motion is unwelcome", async ({ page }) => {
  await page.goto("./#v=1&preset=ellipse&finest=5&match=later");
  await button(page, "Match").click();
  await finished(page);
  const slider = page.getByRole("slider", { name: "Morph" });
  await button(page, "Play the morph").click();
  await expect(button(page, "Stop the morph")).toBeVisible();
  await expect(slider).toHaveValue("100", { timeout: 10_000 });
  await expect(button(page, "Play the morph")).toBeVisible();
  await page.emulateMedia({ reducedMotion: "reduce" });
  await button(page, "Play the morph").click();
  await expect(slider).toHaveValue("0");
});

test("the template takes the colours of its partners when the match is done", async ({ page }) => {
  await page.goto("./#v=1&preset=leaf&finest=5&match=later");
  await expect.poll(async () => (await paint(surface(page, "Template"))).painted).toBeGreaterThan(0);
  const before = await paint(surface(page, "Template"));
  await button(page, "Match").click();
  await finished(page);
  await expect.poll(async () => (await paint(surface(page, "Template"))).colours).toBeGreaterThan(2 * before.colours);
});

for (const preset of PRESETS) {
  test(`the example “${preset.title}” starts with one click and matches`, async ({ page }) => {
    await page.goto("./");
    await choose(page, "Finest grid", "65 × 65");
    await button(page, preset.title).click();
    await finished(page);
    expect(await value(page, "level")).toBe(6);
    expect(await value(page, "mismatch-max")).toBeLessThan(0.5);
    expect(await value(page, "least-determinant")).toBeGreaterThan(0);
    await expect(button(page, preset.title)).toHaveAttribute("aria-pressed", "true");
  });
}
