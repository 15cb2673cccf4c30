import { AxeBuilder } from "@axe-core/playwright";
import { expect, test } from "@playwright/test";
import { button, finished, result, settings, surface, watch } from "./handles";

for (const colorScheme of ["light", "dark"] as const) {
  for (const [width, height] of [
    [1280, 800],
    [390, 844],
  ]) {
    test.describe(`${colorScheme}, ${width} pixels`, () => {
      test.use({ colorScheme, viewport: { width, height } });

      test("has no accessibility violation, before, after and with everything open", async ({ page }) => {
        const seen = watch(page);
        await page.goto("./#v=1&preset=ellipse&finest=5&match=later");
        expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
        await button(page, "Match").click();
        await finished(page);
        await settings(page).click();
        await button(page, "Clear template").click();
        await button(page, "Match").click();
        await expect(page.getByRole("alert")).not.toBeEmpty();
        expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
        expect(seen.errors).toEqual([]);
      });

      test("has nothing to scroll sideways", async ({ page }) => {
        await page.goto("./#v=1&preset=ellipse&finest=5&match=later");
        await button(page, "Match").click();
        await finished(page);
        await settings(page).click();
        expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
      });
    });
  }
}

test("at 1280 × 800 everything to draw and match with is in sight", async ({ page }) => {
  await page.goto("./#v=1&preset=ellipse&finest=5&match=later");
  await button(page, "Match").click();
  await finished(page);
  for (const part of [
    surface(page, "Reference"),
    surface(page, "Template"),
    button(page, "Match"),
    result(page),
    page.getByRole("slider", { name: "Morph" }),
    page.getByRole("status"),
    button(page, "Bean → crescent"),
    settings(page),
  ]) {
    await expect(part).toBeInViewport({ ratio: 1 });
  }
});

test.describe("on a phone", () => {
  test.use({ viewport: { width: 390, height: 844 }, deviceScaleFactor: 3, hasTouch: true, isMobile: true });

  test("both sketches, Match and the result's upper half are in sight", async ({ page }) => {
    await page.goto("./");
    await expect(surface(page, "Reference")).toBeInViewport({ ratio: 1 });
    await expect(surface(page, "Template")).toBeInViewport({ ratio: 1 });
    await expect(button(page, "Match")).toBeInViewport({ ratio: 1 });
    await expect(result(page)).toBeInViewport({ ratio: 0.5 });
  });

  test("canvases have one pixel for each of the screen's", async ({ page }) => {
    await page.goto("./");
    for (const canvas of [surface(page, "Reference"), result(page)]) {
      const box = await canvas.boundingBox();
      await expect
        .poll(() => canvas.evaluate((element) => (element as HTMLCanvasElement).width))
        .toBe(Math.round((box?.width ?? 0) * 3));
    }
  });
});

test("nothing scrolls sideways at any width: the other pages, and the presentation", async ({ page }) => {
  const widths = [195, 320, 390, 768, 1024, 1100, 1280, 3840];
  for (const address of ["./experiments.html", "./licences.html", "./lessons.html", "./#v=1&preset=ellipse&finest=5"]) {
    await page.goto(address);
    await expect(page.getByRole("heading", { level: 1 })).toBeVisible();
    if (address.includes("preset")) {
      await finished(page);
      await button(page, "Present").click();
      await expect(button(page, "Leave")).toBeVisible();
    }
    for (const width of widths) {
      await page.setViewportSize({ width, height: 800 });
      await expect
        .poll(() => page.evaluate(() => document.documentElement.scrollWidth), `${address} ${width}`)
        .toBeLessThanOrEqual(width);
    }
  }
});

test("nothing scrolls sideways at any width, with everything open", async ({ page }) => {
  await page.goto("./#v=1&preset=ellipse&finest=5");
  await finished(page);
  for (const title of [
    "Settings",
    "Energies over iterations",
    "Runs so far",
    "Compare side by side",
    "Recent sessions",
  ]) {
    await page.locator("summary", { hasText: title }).click();
  }
  await page.getByText("For those who know the paper").click();
  await page.getByLabel("View", { exact: true }).selectOption("Image pulled back");
  await expect(page.locator(".legend")).toBeVisible();
  // 640 and 320 are what 1280 pixels are at 200 % and 400 %, 195 what a phone's 390 are at 200 %.
  for (const width of [195, 320, 390, 640, 768, 901, 1024, 1100, 1280, 3840]) {
    await page.setViewportSize({ width, height: 800 });
    await expect
      .poll(() => page.evaluate(() => document.documentElement.scrollWidth), `${width}`)
      .toBeLessThanOrEqual(width);
    // The picker shows the whole name of its longest view.
    const picker = page.getByLabel("View", { exact: true });
    expect(await picker.evaluate((select) => select.clientWidth), `${width}`).toBeGreaterThanOrEqual(135);
  }
});

test("on a phone magnified to 200 % no word is wider than what is pressed for it, in German as well", async ({
  page,
}) => {
  await page.setViewportSize({ width: 195, height: 422 });
  await page.goto("./?lang=de#v=1&preset=ellipse&finest=5");
  await finished(page);
  const cut = await page
    .locator("button, summary, select, .term")
    .evaluateAll((all) =>
      all.filter((one) => one.checkVisibility() && one.scrollWidth > one.clientWidth).map((one) => one.textContent),
    );
  expect(cut).toEqual([]);
});
