import { expect, type Page, test } from "@playwright/test";
import { button, finished, loaded, picture, result, settings, surface, value, watch } from "./handles";

function live(page: Page) {
  return page.getByRole("switch", { name: "Live" });
}

/** Takes the template's rightmost point, without letting go. Gives the place in page pixels. */
async function take(page: Page): Promise<{ x: number; y: number; size: number }> {
  const canvas = surface(page, "Template");
  const box = await canvas.boundingBox();
  if (!box) throw new Error("the template's surface is not on the page");
  const [right, down] = await canvas.evaluate((element) => {
    const target = element as HTMLCanvasElement;
    const image = target.getContext("2d")?.getImageData(0, 0, target.width, target.height);
    for (let x = target.width - 1; image && x >= 0; x -= 1) {
      for (let y = 0; y < target.height; y += 1) {
        if (image.data[4 * (y * target.width + x) + 3] > 0) return [(x - 1) / target.width, y / target.height];
      }
    }
    throw new Error("the template's surface is empty");
  });
  const x = box.x + right * box.width;
  const y = box.y + down * box.height;
  await page.mouse.move(x, y);
  await page.mouse.down();
  return { x, y, size: box.width };
}

test("switching Live on matches, and the match follows a dragged point and is refined on release", async ({ page }) => {
  const seen = watch(page);
  const whole = loaded(page);
  await page.goto("./#v=1&preset=ellipse");
  await whole;
  await expect(live(page)).toHaveAttribute("aria-checked", "false");
  await live(page).click();
  await expect(live(page)).toHaveAttribute("aria-checked", "true");
  await finished(page);
  expect(await value(page, "level")).toBe(7);
  const pixels = () => picture(result(page));
  const before = await pixels();
  seen.requests.length = 0;

  const { x, y, size } = await take(page);
  for (let i = 1; i <= 20; i += 1) await page.mouse.move(x + 0.003 * i * size, y);
  await expect(result(page)).toHaveAttribute("aria-label", /following your hand on the 65 by 65 grid/);
  await expect.poll(pixels).not.toBe(before);
  const held = await value(page, "level");
  expect(held).toBe(6);
  await page.mouse.up();
  await finished(page);
  expect(await value(page, "level")).toBe(7);
  expect(await value(page, "mismatch-max")).toBeLessThan(0.5);
  expect(await value(page, "least-determinant")).toBeGreaterThan(0);
  await expect(result(page)).toHaveAttribute("aria-label", /matched, at most/);
  expect(seen.errors).toEqual([]);
  expect(seen.requests).toEqual([]);
});

test("a live match ends where a fresh one does", async ({ page }) => {
  await page.goto("./#v=1&preset=ellipse&finest=6");
  await live(page).click();
  await finished(page);
  const { x, y, size } = await take(page);
  for (let i = 1; i <= 10; i += 1) await page.mouse.move(x + 0.004 * i * size, y);
  await page.mouse.up();
  await finished(page);
  const followed = await value(page, "total");
  await button(page, "Match").click();
  await expect(page.getByRole("progressbar")).toHaveCount(0);
  await finished(page);
  // Both stop by relative decrease, so that their energies agree to some parts in a thousand only.
  expect(Math.abs(followed / (await value(page, "total")) - 1)).toBeLessThan(0.02);
});

test("a drag before the first match is there is caught up with", async ({ page }) => {
  await page.goto("./#v=1&preset=ellipse&finest=8");
  await live(page).click();
  const { x, y, size } = await take(page);
  for (let i = 1; i <= 10; i += 1) await page.mouse.move(x, y - 0.004 * i * size);
  await expect(result(page)).toHaveAttribute("aria-label", /following your hand on the 65 by 65 grid/);
  await page.mouse.up();
  await finished(page);
  expect(await value(page, "level")).toBe(8);
  expect(await value(page, "mismatch-max")).toBeLessThan(0.5);
});

test("a shape dragged to the border keeps the last picture, says why, and matches again when it is back", async ({
  page,
}) => {
  await page.goto("./#v=1&preset=ellipse&finest=6");
  await live(page).click();
  await finished(page);
  const { x, y, size } = await take(page);
  await page.mouse.move(x + 0.1 * size, y, { steps: 4 });
  const edge = (await surface(page, "Template").boundingBox())?.x ?? 0;
  await page.mouse.move(edge + 0.995 * size, y, { steps: 8 });
  await expect(page.getByRole("alert")).toContainText("The target comes within");
  await expect(result(page)).toHaveAttribute("aria-label", /following/);
  await page.mouse.move(x, y, { steps: 4 });
  await expect(page.getByRole("alert")).toBeEmpty();
  await page.mouse.up();
  await finished(page);
  expect(await value(page, "mismatch-max")).toBeLessThan(0.5);
});

test("the match follows a setting's slider", async ({ page }) => {
  await page.goto("./#v=1&preset=ellipse&finest=6");
  await live(page).click();
  await finished(page);
  const before = await value(page, "total");
  await settings(page).click();
  const slider = page.getByRole("slider", { name: "Stretching, slider" });
  await slider.focus();
  for (let i = 0; i < 5; i += 1) await slider.press("PageUp");
  await expect(page.getByLabel("Stretching", { exact: true })).not.toHaveValue("1");
  await finished(page);
  await expect.poll(() => value(page, "total")).toBeGreaterThan(before);
});
