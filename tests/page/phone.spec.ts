/** The page under a finger: a surface to draw on that fills the screen, and nothing too small to be hit. */

import { AxeBuilder } from "@axe-core/playwright";
import { expect, type Page, test } from "@playwright/test";
import { button, drawn, finished, settings, surface } from "./handles";

test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

const EASY = "./#v=1&preset=ellipse&finest=5";

/** Whatever is pressed and less than 44 pixels high or wide. Links within a sentence are read, and as high as its line. */
async function small(page: Page): Promise<string[]> {
  return page.evaluate(() =>
    [...document.querySelectorAll<HTMLElement>("button, select, summary, input, textarea, a[href], [role=application]")]
      .filter((element) => element.checkVisibility({ visibilityProperty: true }) && !element.closest("[inert]"))
      // Behind a dialog nothing is pressed.
      .filter((element) => !document.querySelector("dialog[open]") || element.closest("dialog[open]"))
      .filter((element) => !(element.tagName === "A" && getComputedStyle(element).display === "inline"))
      // Of a box with its words, the words are pressed as well.
      .map((element) =>
        element.matches("[type=checkbox], [type=file]") ? (element.closest("label") ?? element) : element,
      )
      .filter((element) => {
        const { width, height } = element.getBoundingClientRect();
        return Math.round(width) < 44 || Math.round(height) < 44;
      })
      .map((element) => {
        const { width, height } = element.getBoundingClientRect();
        const name = element.getAttribute("aria-label") ?? element.textContent?.slice(0, 30);
        return `${element.tagName}.${element.className} “${name}” ${Math.round(width)} × ${Math.round(height)}`;
      }),
  );
}

test("whatever is pressed is 44 pixels wide and high: on the page with everything open", async ({ page }) => {
  await page.goto(EASY);
  await finished(page);
  await settings(page).click();
  await page.getByText("For those who know the paper").click();
  for (const title of ["Energies over iterations", "Runs so far", "Compare side by side"])
    await page.locator("summary", { hasText: title }).click();
  await expect(button(page, "Compare")).toBeVisible();
  expect(await small(page)).toEqual([]);
  await page.locator(".save summary").click();
  expect(await small(page)).toEqual([]);
  await page.locator(".exchange summary").click();
  expect(await small(page)).toEqual([]);
  for (const name of ["Circle", "Polygon", "Mirror", "Pin"]) await button(page, name).tap();
  await button(page, "Polygon").tap();
  await surface(page, "Reference").tap({ position: { x: 30, y: 30 } });
  await expect(button(page, "Close outline")).toBeVisible();
  expect(await small(page)).toEqual([]);
});

test("whatever is pressed is 44 pixels wide and high: in the dialogs and the presentation", async ({ page }) => {
  await page.goto(EASY);
  await finished(page);
  await button(page, "Open the gallery").tap();
  await expect(page.getByRole("region", { name: "Countries" })).toBeVisible();
  expect(await small(page)).toEqual([]);
  await page.getByRole("dialog").getByRole("listitem").first().getByRole("button").tap();
  await expect(button(page, "Use as target")).toBeEnabled();
  expect(await small(page)).toEqual([]);
  await button(page, "Close").tap();
  await button(page, "Present").tap();
  await expect(button(page, "Leave")).toBeVisible();
  expect(await small(page)).toEqual([]);
});

test("whatever is pressed is 44 pixels wide and high: on the other pages", async ({ page }) => {
  for (const address of ["./experiments.html", "./licences.html"]) {
    await page.goto(address);
    await expect(page.getByRole("heading", { level: 1 })).toBeVisible();
    expect(await small(page), address).toEqual([]);
  }
});

test("whatever is pressed is 44 pixels wide and high: in a lesson, in its frame, and with surfaces", async ({
  page,
}) => {
  await page.goto("./lessons.html");
  await expect(page.getByRole("listitem").first()).toBeVisible();
  expect(await small(page)).toEqual([]);
  await page.goto("./lessons.html#stretch/6");
  await expect(button(page, "Check")).toBeVisible();
  expect(await small(page)).toEqual([]);
  await page.goto("./?embed=full#v=2&preset=ellipse&finest=5");
  await finished(page);
  expect(await small(page)).toEqual([]);
  await page.goto("about:blank");
  await page.goto("./#space=1&finest=4");
  await finished(page);
  await button(page, "Set pins").tap();
  await settings(page).click();
  expect(await small(page)).toEqual([]);
});

for (const [way, size] of [
  ["upright", { width: 390, height: 844 }],
  ["sideways", { width: 844, height: 390 }],
] as const) {
  test(`a surface fills the screen to be drawn on, and Done leads back to the page (${way})`, async ({ page }) => {
    await page.setViewportSize(size);
    await page.goto("./#v=1&preset=star&finest=5&match=later");
    await button(page, "Enlarge reference").tap();
    const { width = 0, height = 0, x = 0, y = 0 } = (await surface(page, "Reference").boundingBox()) ?? {};
    expect(width).toBeGreaterThan(0.88 * Math.min(size.width, size.height));
    expect(height).toBeCloseTo(width, 0);
    await expect(surface(page, "Reference")).toBeInViewport({ ratio: 1 });
    await expect(surface(page, "Reference")).toBeFocused();
    await expect(surface(page, "Template")).toBeHidden();
    for (const name of ["Undo", "To the target", "Done"])
      await expect(page.locator(".enlarged-bar").getByText(name)).toBeInViewport({ ratio: 1 });
    await button(page, "Polygon").tap();
    for (const [u, v] of [
      [0.3, 0.3],
      [0.7, 0.3],
      [0.5, 0.7],
      [0.3, 0.3],
    ])
      await page.touchscreen.tap(x + u * width, y + (1 - v) * height);
    await expect.poll(() => drawn(page, "Reference")).toBeTruthy();
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(size.width);
    expect(await small(page)).toEqual([]);
    expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
    await page.locator(".enlarged-bar").getByText("Undo").tap();
    await button(page, "To the target").tap();
    await expect(surface(page, "Template")).toBeFocused();
    await button(page, "Done").tap();
    await expect(surface(page, "Reference")).toBeVisible();
    await expect(surface(page, "Template")).toBeFocused();
    await expect(button(page, "Done")).toHaveCount(0);
  });
}
