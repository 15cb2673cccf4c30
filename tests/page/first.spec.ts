import { expect, type Page, test } from "@playwright/test";
import { button, finished, paint, result, settings, value, watch } from "./handles";

test("a first visit shows a finished match without a press", async ({ page }) => {
  const seen = watch(page);
  await page.goto("./");
  await finished(page);
  await expect(result(page)).toHaveAccessibleName(/matched, at most .* cells off/);
  expect(await value(page, "level")).toBe(7);
  expect(seen.errors).toEqual([]);
});

test("so does a shared link in a fresh profile, and a second one opened over it", async ({ page }) => {
  await page.goto("./#v=1&preset=ellipse&finest=5&bending=0.5");
  await finished(page);
  expect(await value(page, "level")).toBe(5);
  await page.evaluate(() => {
    location.hash = "#v=1&preset=leaf&finest=6";
  });
  await expect.poll(() => value(page, "level")).toBe(6);
});

test("a link to a fine grid shows a match on a quick one first and goes on from it", async ({ page }) => {
  const levels = await levelsShown(page, "./#v=1&preset=ellipse&finest=8");
  await finished(page);
  await expect.poll(() => value(page, "level")).toBe(8);
  expect(await levels()).toContain(7);
  await expect(result(page)).toHaveAccessibleName(/matched, at most/);
});

/** Every level whose finished match the result has been named by. */
async function levelsShown(page: Page, address: string): Promise<() => Promise<number[]>> {
  await page.addInitScript(() => {
    const levels: number[] = [];
    Object.assign(window, { levels });
    const look = () => {
      const level = document.querySelector('[role="status"] data[data-name="level"]')?.getAttribute("value");
      if (level && levels[levels.length - 1] !== Number(level)) levels.push(Number(level));
      requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
  });
  await page.goto(address);
  return () => page.evaluate(() => Reflect.get(window, "levels"));
}

test("a link can leave the match to a press, for those who are to guess it first", async ({ page }) => {
  await page.goto("./#v=1&preset=ellipse&finest=5&match=later");
  await page.waitForLoadState("networkidle");
  await expect(page.getByRole("status")).toContainText("Ready: press Match.");
  await button(page, "Match").click();
  await finished(page);
});

test.describe("on a phone", () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test("while settings are moved a small result stays in view, and a tap leads back to the large one", async ({
    page,
  }) => {
    await page.goto("./#v=1&preset=ellipse&finest=5");
    await finished(page);
    const large = (await result(page).boundingBox())?.width ?? 0;
    await settings(page).click();
    await page.getByLabel("Volume ξ", { exact: true }).scrollIntoViewIfNeeded();
    await page.mouse.wheel(0, 600);
    await expect(button(page, "Back to the result")).toBeVisible();
    await expect(result(page)).toBeInViewport({ ratio: 1 });
    expect((await result(page).boundingBox())?.width).toBeLessThan(large / 2);
    // No line of the page is covered in part: it is seen beside nothing, or not at all.
    const strip = (await page.locator(".surface.pinned").boundingBox()) ?? { x: 1, y: 1, width: 0, height: 0 };
    expect([strip.x, strip.y, strip.width]).toEqual([0, 0, 390]);
    expect(strip.height).toBeLessThan(844 / 5);
    await expect(page.locator(".pinned .told")).toContainText("Fits");
    await page.getByLabel("Volume ξ", { exact: true }).fill("0.1");
    await page.getByLabel("Volume ξ", { exact: true }).press("Enter");
    await expect(page.locator(".pinned .told")).toContainText("The settings have changed");
    // Nor is what the keyboard goes to.
    for (let k = 0; k < 3; k += 1) await page.keyboard.press("Shift+Tab");
    await expect(button(page, "Back to the result")).toBeVisible();
    const top = await page.evaluate(() => document.activeElement?.getBoundingClientRect().top);
    expect(top).toBeGreaterThanOrEqual(strip.height);
    await button(page, "Back to the result").click();
    await expect(button(page, "Back to the result")).toHaveCount(0);
    await expect(result(page)).toBeInViewport({ ratio: 0.9 });
  });

  test("surfaces too have a small result while what lies below is looked at", async ({ page }) => {
    await page.goto("./#space=1&finest=4");
    await finished(page);
    const large = (await result(page).boundingBox())?.width ?? 0;
    await page.evaluate(() => scrollTo(0, 1e6));
    await expect(button(page, "Back to the result")).toBeVisible();
    await expect(page.locator(".pinned .told")).toContainText("Fits");
    await expect.poll(async () => (await result(page).boundingBox())?.width).toBeLessThan(large / 2);
    const { painted } = await paint(result(page));
    expect(painted).toBeGreaterThan(0.1);
    await button(page, "Back to the result").click();
    await expect(button(page, "Back to the result")).toHaveCount(0);
    await expect(result(page)).toBeInViewport({ ratio: 0.9 });
  });

  test("who jumps past the result from above it has the small one as well", async ({ page }) => {
    await page.setViewportSize({ width: 320, height: 480 });
    await page.goto("./#v=1&preset=ellipse&finest=5");
    await finished(page);
    await expect(result(page)).not.toBeInViewport();
    await expect(button(page, "Back to the result")).toHaveCount(0);
    await page.evaluate(() => scrollTo(0, 1e6));
    await expect(button(page, "Back to the result")).toBeVisible();
  });

  test("an example brings the result into view", async ({ page }) => {
    await page.goto("./");
    await finished(page);
    await button(page, "Bean → crescent").scrollIntoViewIfNeeded();
    await button(page, "Bean → crescent").click();
    await expect(result(page)).toBeInViewport({ ratio: 0.9 });
  });
});

test("on a desk the result stays in sight beside open settings", async ({ page }) => {
  await page.goto("./#v=1&preset=ellipse&finest=5");
  await finished(page);
  await settings(page).click();
  await page.getByText("For those who know the paper").click();
  await page.getByLabel("Minimiser", { exact: true }).scrollIntoViewIfNeeded();
  expect(await page.evaluate(() => scrollY)).toBeGreaterThan(200);
  await expect(result(page)).toBeInViewport({ ratio: 0.95 });
});
