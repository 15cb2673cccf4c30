import { AxeBuilder } from "@axe-core/playwright";
import { expect, test } from "@playwright/test";
import { button, finished, paint, picture, watch } from "./handles";

const EASY = "./#v=1&preset=ellipse&finest=5&match=later";

for (const [colorScheme, width] of [
  ["light", 1280],
  ["dark", 390],
] as const) {
  test.describe(`${colorScheme}, ${width} pixels`, () => {
    test.use({ colorScheme, viewport: { width, height: 800 } });

    test("two settings are matched side by side, with one view, one morph and a table", async ({ page }) => {
      const seen = watch(page);
      await page.goto(EASY);
      await page.getByText("Compare side by side").click();
      await page.getByLabel("Setting that B changes").selectOption({ label: "Stretching" });
      await page.getByLabel("Stretching of B").fill("20");
      await button(page, "Compare").click();
      const row = (name: string) => page.getByRole("row", { name }).getByRole("cell");
      await expect(row("Energy")).toHaveCount(3);
      const cells = await row("of stretching").allTextContents();
      expect(Number(cells[1])).toBeGreaterThan(Number(cells[0]));
      const numbers = (await row("Mean stretch").allTextContents()).map((text) => Number(text.replace("−", "-")));
      expect(numbers[1] - numbers[0]).toBeCloseTo(numbers[2], 1);

      const results = [page.getByRole("img", { name: "Result of A" }), page.getByRole("img", { name: "Result of B" })];
      const pictures = () => Promise.all(results.map(picture));
      for (const one of results) await expect.poll(async () => (await paint(one)).painted).toBeGreaterThan(0.05);
      const [a, b] = await pictures();
      expect(a === b).toBe(false);
      await page.getByRole("combobox", { name: "View of both" }).selectOption("Area ratio");
      await expect(page.locator(".pair .legend")).toHaveCount(2);
      await expect.poll(async () => (await pictures()).some((picture) => picture === a || picture === b)).toBe(false);
      const matched = await pictures();
      await page.getByLabel("Morph of both").fill("0");
      await expect.poll(async () => (await pictures()).some((picture) => matched.includes(picture))).toBe(false);

      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
      expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
      expect(seen.errors).toEqual([]);
    });

    test("the energies' chart shows every term with its value under the pointer", async ({ page }) => {
      const seen = watch(page);
      await page.goto(EASY);
      await page.getByText("Energies over iterations").click();
      await expect(page.getByText("Press Match to see the energies fall.")).toBeVisible();
      await button(page, "Match").click();
      await finished(page);
      const chart = page.getByRole("img", { name: "Energy terms over iterations, logarithmic" });
      await expect.poll(async () => (await paint(chart.locator("canvas"))).colours).toBeGreaterThan(20);
      const { width: across } = (await chart.boundingBox()) ?? { width: 0 };
      await chart.locator(".u-over").hover({ position: { x: across / 4, y: 60 } });
      for (const term of ["Total", "Stretching", "Bending", "Mismatch", "Volume"]) {
        await expect(chart.locator(".u-series", { hasText: term }).locator(".u-value")).toHaveText(/\d/);
      }
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
      expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
      expect(seen.errors).toEqual([]);
    });
  });
}

test("what cannot be compared is refused with a reason", async ({ page }) => {
  await page.goto(EASY);
  await page.getByText("Compare side by side").click();
  await page.getByLabel("Bending of B").fill("-3");
  await button(page, "Compare").click();
  await expect(page.getByRole("alert")).toContainText("Bending is “-3”, but must be a number from 0 to 100");
  await page.getByLabel("Bending of B").fill("0");
  await button(page, "Clear template").click();
  await button(page, "Compare").click();
  await expect(page.getByRole("alert")).toContainText("The target has no points");
});
