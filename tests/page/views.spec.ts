import { AxeBuilder } from "@axe-core/playwright";
import { expect, type Page, test } from "@playwright/test";
import { VIEWS } from "../../www/view/names";
import { en } from "../../www/words/en";
import { button, finished, paint, picture, result, surface, watch } from "./handles";

const EASY = "./#v=1&preset=ellipse&finest=6";

async function matched(page: Page): Promise<void> {
  await page.goto(EASY);
  await button(page, "Match").click();
  await finished(page);
}

function picker(page: Page) {
  return page.getByRole("combobox", { name: "View" });
}

/** A number of the place pointed at. */
async function local(page: Page, name: string): Promise<number> {
  const readout = page.getByRole("region", { name: "Numbers at the point" });
  return Number(await readout.locator(`data[data-name="${name}"]`).getAttribute("value"));
}

test("every view paints the match in its own way, with a legend for its colours", async ({ page, baseURL }) => {
  const seen = watch(page);
  await matched(page);
  const pixels = () => picture(result(page));
  const pictures = new Set([await pixels()]);
  for (const view of VIEWS.slice(1)) {
    const label = en.views[view];
    await picker(page).selectOption(label);
    await expect(picker(page)).toHaveValue(view);
    await expect.poll(async () => pictures.has(await pixels())).toBe(false);
    pictures.add(await pixels());
    const { painted, colours } = await paint(result(page));
    expect(painted, label).toBeGreaterThan(0.02);
    expect(colours, label).toBeGreaterThan(100);
    await expect(page.locator(".legend"), label).toBeVisible();
  }
  expect(pictures.size).toBe(VIEWS.length);
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  await picker(page).selectOption("Grid");
  await expect(page.locator(".legend")).toHaveCount(0);
  expect(seen.errors).toEqual([]);
  // Only the page's own parts, fetched when they were first needed.
  expect(seen.requests.filter((url) => !url.startsWith(baseURL ?? "") && !/^(data|blob):/.test(url))).toEqual([]);
});

test("the picture that is carried along can be the user's own; what is none is refused", async ({ page }) => {
  await matched(page);
  await picker(page).selectOption("Image carried");
  const pixels = () => picture(result(page));
  const pattern = await pixels();
  const red = Buffer.from(
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8BQDwAEhQGAhKmMIQAAAABJRU5ErkJggg==",
    "base64",
  );
  const input = page.getByLabel("Choose a picture …");
  await input.setInputFiles({ name: "red.png", mimeType: "image/png", buffer: red });
  await expect.poll(pixels).not.toBe(pattern);
  await button(page, "Test pattern").click();
  await expect.poll(pixels).toBe(pattern);
  await input.setInputFiles({ name: "no.png", mimeType: "image/png", buffer: Buffer.from("no picture") });
  await expect(page.getByRole("alert")).toContainText("The picture could not be read");
  expect(await pixels()).toBe(pattern);
});

test("pointing at the reference lights its partner up, with the numbers there", async ({ page }) => {
  await matched(page);
  const template = surface(page, "Template");
  const plain = await picture(template);
  const box = await surface(page, "Reference").boundingBox();
  if (!box) throw new Error("the reference's surface is not on the page");
  // The circle's rightmost point: the first painted pixel from the right on the middle row.
  const right = await surface(page, "Reference").evaluate((element) => {
    const canvas = element as HTMLCanvasElement;
    const row = canvas.getContext("2d")?.getImageData(0, canvas.height >> 1, canvas.width, 1).data ?? [];
    let x = canvas.width - 1;
    while (x > 0 && row[4 * x + 3] === 0) x -= 1;
    return x / canvas.width;
  });
  await page.mouse.move(box.x + right * box.width - 2, box.y + box.height / 2);
  expect(Math.abs((await local(page, "point-x")) - right)).toBeLessThan(0.03);
  expect(await local(page, "partner-x")).toBeGreaterThan(0);
  expect(await local(page, "stretch")).toBeGreaterThan(0);
  expect(await local(page, "determinant")).toBeGreaterThan(0);
  expect(await local(page, "curvature")).toBeGreaterThan(0);
  expect(await local(page, "distance")).toBeLessThan(0.5);
  await expect.poll(() => picture(template)).not.toBe(plain);
  await page.mouse.move(box.x + 5, box.y + 5);
  await expect(page.getByRole("region", { name: "Numbers at the point" })).toBeEmpty();
});

test("the arrow keys walk along the curve", async ({ page }) => {
  await matched(page);
  await result(page).focus();
  await page.keyboard.press("ArrowRight");
  const [x, y] = [await local(page, "point-x"), await local(page, "point-y")];
  await page.keyboard.press("ArrowRight");
  expect([await local(page, "point-x"), await local(page, "point-y")]).not.toEqual([x, y]);
  await page.keyboard.press("ArrowLeft");
  expect([await local(page, "point-x"), await local(page, "point-y")]).toEqual([x, y]);
  await page.keyboard.press("Escape");
  await expect(page.getByRole("region", { name: "Numbers at the point" })).toBeEmpty();
});

for (const width of [390, 1280]) {
  test(`at ${width} pixels no view or legend makes the page scroll sideways`, async ({ page }) => {
    await page.setViewportSize({ width, height: 800 });
    await matched(page);
    for (const label of ["Stretch", "Image carried", "Mismatch"]) {
      await picker(page).selectOption(label);
      await expect(page.locator(".legend")).toBeVisible();
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
    }
  });
}
