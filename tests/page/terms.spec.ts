import { readFileSync } from "node:fs";
import { AxeBuilder } from "@axe-core/playwright";
import { expect, type Page, test } from "@playwright/test";
import { button, finished, picture, result, watch } from "./handles";

const EASY = "./#v=1&preset=ellipse&finest=6";

async function opened(page: Page): Promise<void> {
  await page.goto(EASY);
  await finished(page);
}

test("a term is left out by a press at the result, and taken in again with its own weight", async ({ page }) => {
  await page.goto(`${EASY}&bending=0.2`);
  await finished(page);
  const bending = page.getByRole("switch", { name: "Bending" });
  await expect(bending).toBeChecked();
  await bending.click();
  await expect(bending).not.toBeChecked();
  await expect.poll(() => page.url()).toContain("bending=0&");
  await finished(page);
  await bending.click();
  await expect.poll(() => page.url()).toContain("bending=0.2");
  await finished(page);
  await expect(result(page)).toHaveAccessibleName(/matched, at most/);
});

test("each term bears the symbol of its weight beside its word, in one line", async ({ page }) => {
  await opened(page);
  const terms = page.locator(".terms .term");
  await expect(terms).toHaveText(["Stretchingαmem", "Bendingαbend", "Mismatch1/ε", "Volumeξ"]);
  await expect(page.getByRole("switch", { name: "Stretching", exact: true })).toBeChecked();
  for (const width of [195, 320, 390, 521, 768, 1024, 1140, 1240, 1280]) {
    await page.setViewportSize({ width, height: 800 });
    const boxes = await terms.evaluateAll((all) => all.map((one) => one.getBoundingClientRect().toJSON()));
    for (const [k, { left, right, top, height }] of boxes.entries()) {
      expect(right, `${width}`).toBeLessThanOrEqual(width);
      expect(height, `${width}`).toBeLessThan(46);
      const before = boxes[k - 1];
      if (before?.top === top) expect(left, `${width}`).toBeGreaterThanOrEqual(before.right);
    }
  }
});

test("every iteration can be looked at again, and the end is what is left when that is over", async ({ page }) => {
  const seen = watch(page);
  await opened(page);
  const end = await picture(result(page));
  await page.getByText("Energies over iterations").click();
  const iteration = page.getByRole("slider", { name: "Iteration" });
  await iteration.fill("0");
  await expect(page.getByText(/^Iteration 1 of \d+, on the \d+ × \d+ grid$/)).toBeVisible();
  await expect.poll(() => picture(result(page))).not.toBe(end);
  await iteration.fill((await iteration.getAttribute("max")) ?? "");
  await expect.poll(() => picture(result(page))).toBe(end);
  await iteration.fill("1");
  await page.getByText("Energies over iterations").click();
  await expect.poll(() => picture(result(page))).toBe(end);
  expect(seen.errors).toEqual([]);
});

test("runs are kept; one is pinned beside the newest, titled by what differs, and shown again", async ({ page }) => {
  await opened(page);
  await page.getByRole("switch", { name: "Bending" }).click();
  await expect.poll(() => page.url()).toContain("bending=0");
  await finished(page);
  await page.getByText("Runs so far", { exact: true }).click();
  await expect(page.getByRole("list", { name: "Runs so far, newest first" }).getByRole("listitem")).toHaveCount(2);
  await page.getByRole("checkbox", { name: "Compare with it: Run 1" }).check();
  await expect(page.getByText("Pinned: Bending 0.03")).toBeVisible();
  await expect(page.getByText("Now: Bending 0", { exact: true })).toBeVisible();
  await expect(page.getByRole("row", { name: "of bending" }).getByRole("cell")).toHaveCount(3);
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  await button(page, "Show again: Run 1, Finest grid 65 × 65").click();
  await expect.poll(() => page.url()).not.toContain("bending");
  await expect(result(page)).toHaveAccessibleName(/matched, at most/);
});

async function saved(page: Page, label: string, legend: boolean): Promise<Buffer> {
  await page.getByText("Save", { exact: true }).click();
  await page.getByLabel("With a legend").setChecked(legend);
  const [download] = await Promise.all([page.waitForEvent("download"), button(page, label).click()]);
  return readFileSync(await download.path());
}

async function drawing(page: Page, legend = false): Promise<string> {
  return (await saved(page, "Drawing (SVG)", legend)).toString();
}

test("a drawing follows the view, and says what its colours mean when asked to", async ({ page }) => {
  await opened(page);
  const grid = await drawing(page);
  expect(grid).toContain('<path id="grid"');
  await page.getByLabel("View", { exact: true }).selectOption("Stretch");
  await expect(page.locator(".legend")).toBeVisible();
  const stretch = await drawing(page, true);
  expect(stretch).toContain("<title>Stretch</title>");
  expect(stretch).toContain('<g class="along"');
  expect(stretch).toContain("Length after / before");
  await page.getByLabel("View", { exact: true }).selectOption("Area ratio");
  await expect(page.locator(".legend")).toContainText("Area after / before");
  const area = await drawing(page);
  expect(area).toContain('href="data:image/png;base64,');
  expect(area).not.toContain('id="legend"');
  const pictures = [await saved(page, "Picture (PNG)", false), await saved(page, "Picture (PNG)", true)];
  expect(pictures[0].equals(pictures[1])).toBe(false);
  for (const text of [grid, stretch, area]) {
    const problem = await page.evaluate(
      (content) => new DOMParser().parseFromString(content, "image/svg+xml").querySelector("parsererror")?.textContent,
      text,
    );
    expect(problem).toBeUndefined();
    for (const side of ["reference", "template", "matched"]) expect(text).toContain(`data-side="${side}"`);
  }
});

test("the terms' forces are drawn over the picture, and go again", async ({ page }) => {
  const seen = watch(page);
  await opened(page);
  const plain = await picture(result(page));
  const forces = page.getByLabel("Show their forces as arrows");
  await forces.check();
  await expect.poll(() => picture(result(page)), { timeout: 30_000 }).not.toBe(plain);
  await forces.uncheck();
  await expect.poll(() => picture(result(page))).toBe(plain);
  expect(seen.errors).toEqual([]);
});

test("where a point goes is guessed first, by the hand or by the keys, and then seen", async ({ page }) => {
  await page.emulateMedia({ reducedMotion: "reduce" });
  await opened(page);
  await button(page, "Guess first").click();
  await expect(page.getByText(/^Where will the marked point of the reference go/)).toBeVisible();
  await expect(page.getByRole("slider", { name: "Morph" })).toHaveValue("0");
  const box = await result(page).boundingBox();
  if (!box) throw new Error("the result is not on the page");
  await page.mouse.click(box.x + box.width / 4, box.y + box.height / 2);
  await expect(page.getByText(/^Your guess was 0\.\d+ box sides off, [\d.]+ cells of the grid\.$/)).toBeVisible();
  await expect(page.getByRole("slider", { name: "Morph" })).toHaveValue("100");
  await button(page, "Another point").click();
  await result(page).focus();
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("Enter");
  await expect(page.getByText(/^Your guess was/)).toBeVisible();
  await button(page, "Done").click();
  await expect(page.getByText(/^Your guess was/)).toHaveCount(0);
});
