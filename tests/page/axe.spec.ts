/** No accessibility violation at AA, on any route of the page, in any scheme. */

import { AxeBuilder } from "@axe-core/playwright";
import { expect, type Page, test } from "@playwright/test";
import { button, finished, settings } from "./handles";

const EASY = "./#v=1&preset=ellipse&finest=5";

async function matched(page: Page): Promise<void> {
  await page.goto(EASY);
  await finished(page);
}

/** Every place of the page that somebody can come to, and how. */
const ROUTES: Readonly<Record<string, (page: Page) => Promise<void>>> = {
  "the page with everything open": async (page) => {
    await matched(page);
    await settings(page).click();
    await page.getByText("For those who know the paper").click();
    for (const title of ["Energies over iterations", "Runs so far", "Compare side by side"])
      await page.locator("summary", { hasText: title }).click();
    await button(page, "Compare").click();
    await expect(page.getByRole("row", { name: "Energy" })).toBeVisible({ timeout: 45_000 });
  },
  "the menus": async (page) => {
    await matched(page);
    await page.locator(".save summary").click();
    await expect(button(page, "Picture (PNG)")).toBeVisible();
    expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
    await page.locator(".exchange summary").click();
    await expect(button(page, "Swap the shapes")).toBeVisible();
  },
  "the import": async (page) => {
    await matched(page);
    await button(page, "Import target").click();
    await expect(page.getByRole("dialog")).toBeVisible();
  },
  "the gallery": async (page) => {
    await matched(page);
    await button(page, "Open the gallery").click();
    await expect(page.getByRole("region", { name: "Countries" })).toBeVisible();
    expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
    await page.getByRole("dialog").getByRole("listitem").first().getByRole("button").click();
    await expect(button(page, "Use as target")).toBeEnabled();
  },
  "the presentation": async (page) => {
    await matched(page);
    await button(page, "Present").click();
    await expect(button(page, "Leave")).toBeVisible();
  },
  "a tool under way": async (page) => {
    await matched(page);
    await button(page, "Polygon").click();
    await page.locator("#reference-surface").click({ position: { x: 40, y: 40 } });
    await expect(button(page, "Close outline")).toBeVisible();
  },
  "a question": async (page) => {
    await matched(page);
    await button(page, "Clear template").click();
    await button(page, "Match").click();
    await expect(page.getByRole("alert")).not.toBeEmpty();
  },
  "the experiments": async (page) => {
    await page.goto("./experiments.html");
    await expect(page.getByRole("heading", { level: 1 })).toBeVisible();
  },
  "the licences": async (page) => {
    await page.goto("./licences.html");
    await expect(page.getByRole("heading", { level: 1 })).toBeVisible();
  },
};

/** Their light and dark are looked at where they are tested. */
const FORCED: typeof ROUTES = {
  "a lesson": async (page) => {
    await page.goto("./lessons.html#stretch/6");
    await expect(button(page, "Check")).toBeVisible();
    await expect(page.frameLocator(".live iframe").getByRole("img").first()).toBeVisible({ timeout: 20_000 });
  },
  "a frame": async (page) => {
    await page.goto(`./?embed=full${EASY.slice(2)}`);
    await finished(page);
  },
};

const SCHEMES = {
  light: { colorScheme: "light" },
  dark: { colorScheme: "dark" },
  "forced colours": { forcedColors: "active" },
} as const;

for (const [scheme, media] of Object.entries(SCHEMES)) {
  test.describe(scheme, () => {
    const routes = scheme === "forced colours" ? { ...ROUTES, ...FORCED } : ROUTES;
    for (const [route, open] of Object.entries(routes)) {
      test(`has no accessibility violation: ${route}`, async ({ page }) => {
        test.slow();
        await page.emulateMedia(media);
        await open(page);
        expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
      });
    }
  });
}
