import AxeBuilder from "@axe-core/playwright";
import { expect, type Locator, type Page, test } from "@playwright/test";
import { BLOCKED } from "./handles";

function watch(page: Page): { problems: string[]; requests: string[] } {
  const seen = { problems: [] as string[], requests: [] as string[] };
  page.on("console", (message) => {
    if ((message.type() === "error" || message.type() === "warning") && message.text() !== BLOCKED)
      seen.problems.push(message.text());
  });
  page.on("pageerror", (error) => seen.problems.push(String(error)));
  page.on("request", (request) => {
    if (!/^(data|blob):/.test(request.url())) seen.requests.push(request.url());
  });
  return seen;
}

test("an experiment is computed live, with its table and its figure", async ({ page }) => {
  test.slow();
  const seen = watch(page);
  await page.goto("./");
  await page.getByRole("link", { name: "computed live" }).click();
  await expect(page.getByRole("heading", { level: 1, name: "The paper's experiments" })).toBeVisible();
  await page.waitForLoadState("networkidle");
  // A busy machine may begin with these only now.
  await page.waitForFunction(
    () =>
      performance.getEntriesByType("resource").some(({ name }) => name.endsWith(".wasm")) &&
      [...document.images].every(({ complete, naturalWidth }) => complete && naturalWidth > 0),
  );
  const loaded = seen.requests.length;

  const section = page.getByRole("region", { name: /^Fig\. 5/ });
  await section.getByRole("button", { name: /^Compute: / }).click();
  await expect(section.getByRole("status")).toContainText("Computed in", { timeout: 60_000 });
  await expect(section.getByRole("table")).toBeVisible();
  // The paper's settings come first, the cures last.
  const halved = section.getByRole("row").filter({ has: page.getByRole("cell", { name: "2", exact: true }) });
  const excess = async (row: Locator) => Number.parseFloat((await row.getByRole("cell").nth(1).textContent()) ?? "");
  expect(await excess(halved.first())).toBeGreaterThan(30);
  expect(Math.abs(await excess(halved.last()))).toBeLessThan(3);
  const figure = section.getByRole("img");
  await expect(figure).toBeVisible();
  expect(await figure.evaluate((image: HTMLImageElement) => image.naturalWidth)).toBeGreaterThan(300);
  await expect(section.getByRole("status")).toContainText("Computed in");

  const download = page.waitForEvent("download");
  await section.getByRole("link", { name: "Save as SVG" }).click();
  expect((await download).suggestedFilename()).toBe("crumpling.svg");

  const { violations } = await new AxeBuilder({ page }).analyze();
  expect(violations).toEqual([]);
  expect(seen.requests.slice(loaded)).toEqual([]);
  expect(seen.problems).toEqual([]);
});

test("an experiment can be cancelled and computed again", async ({ page }) => {
  await page.goto("./experiments.html");
  const section = page.getByRole("region", { name: /^Fig\. 6/ });
  await section.getByRole("button", { name: /^Compute in full: / }).click();
  await expect(section.getByRole("progressbar")).toBeVisible();
  await expect(section.getByRole("status")).toContainText("newton");
  await section.getByRole("button", { name: /^Cancel: / }).click();
  await expect(section.getByRole("progressbar")).toHaveCount(0);
  // Nothing of the run that was cancelled: what was computed beforehand is back.
  await expect(section.getByRole("status")).toHaveText("Computed beforehand; what you compute here takes its place.");

  const other = page.getByRole("region", { name: /^Fig\. 4/ });
  await other.getByRole("button", { name: /^Compute: / }).click();
  await expect(other.getByRole("status")).toContainText("Computed in", { timeout: 60_000 });
  await expect(other.getByRole("table")).toBeVisible();
});

test("the page opens with every experiment's outcome, and each pair opens in the page and is matched", async ({
  page,
}) => {
  await page.goto("./experiments.html");
  const regions = page.getByRole("region", { name: /./ }).filter({ has: page.getByRole("heading", { level: 2 }) });
  await expect(regions).toHaveCount(13);
  for (const region of await regions.all()) {
    await expect(region.getByRole("table").first().or(region.getByRole("img").first()).first()).toBeVisible();
    for (const image of await region.getByRole("img").all()) {
      await image.scrollIntoViewIfNeeded();
      await expect.poll(() => image.evaluate((one: HTMLImageElement) => one.naturalWidth)).toBeGreaterThan(300);
    }
  }
  await page.getByRole("link", { name: /^Open in the page: Fig\. 5/ }).click();
  await expect(page.getByRole("status").locator('data[data-name="mismatch-max"]')).toBeVisible({ timeout: 45_000 });
  expect(page.url()).toContain("bending=1");
});

test("fits a narrow screen, light and dark", async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 800 });
  await page.goto("./experiments.html");
  const section = page.getByRole("region", { name: /^Fig\. 5/ });
  await section.getByRole("button", { name: /^Compute: / }).click();
  await expect(section.getByRole("status")).toContainText("Computed in", { timeout: 60_000 });
  await expect(section.getByRole("table")).toBeVisible();
  const overflow = () => document.documentElement.scrollWidth - document.documentElement.clientWidth;
  // What is computed is the same in both: once is enough.
  for (const colorScheme of ["light", "dark"] as const) {
    await page.emulateMedia({ colorScheme });
    expect(await page.evaluate(overflow)).toBe(0);
    expect((await new AxeBuilder({ page }).analyze()).violations, colorScheme).toEqual([]);
  }
});
