/** A presentation: the result alone, whole on every screen, and led by keys. */

import { AxeBuilder } from "@axe-core/playwright";
import { expect, test } from "@playwright/test";
import { button, finished, result } from "./handles";

test("a presentation shows the result alone in type of 20 px and more, and keys do the rest", async ({ page }) => {
  await page.setViewportSize({ width: 1024, height: 768 });
  await page.goto("./#v=1&preset=ellipse&finest=6");
  await finished(page);
  await button(page, "Present").click();
  await expect(page.getByText("Esc leaves")).toBeVisible();
  await expect(page.getByRole("application")).toHaveCount(0);
  await expect(result(page)).toBeInViewport({ ratio: 1 });
  const smallest = await page.evaluate(() => {
    const texts = [...document.querySelectorAll<HTMLElement>("#app *")].filter(
      (element) =>
        element.checkVisibility() &&
        getComputedStyle(element).clipPath === "none" &&
        [...element.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.textContent?.trim()),
    );
    return Math.min(...texts.map((element) => Number.parseFloat(getComputedStyle(element).fontSize)));
  });
  expect(smallest).toBeGreaterThanOrEqual(20);
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(1024);
  await page.keyboard.press("ArrowLeft");
  await expect(page.getByRole("slider", { name: "Morph" })).toHaveValue("95");
  await page.keyboard.press("v");
  await expect(page.getByLabel("View", { exact: true })).toHaveValue("image");
  await page.keyboard.press("Shift+V");
  await expect(page.getByLabel("View", { exact: true })).toHaveValue("grid");
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  await page.keyboard.press("Escape");
  await expect(button(page, "Present")).toBeVisible();
  await expect(page.getByRole("application", { name: "Reference shape" })).toBeVisible();
});

for (const lang of ["en", "de"]) {
  test(`a presentation fills a projector of 1024 × 768 without a part on another (${lang})`, async ({ page }) => {
    await page.setViewportSize({ width: 1024, height: 768 });
    await page.goto(`./?lang=${lang}#v=1&preset=star&finest=5`);
    await finished(page);
    await page.locator("button.present").click();
    await expect(page.locator(".present-keys")).toBeVisible();
    const box = (part: string) => page.locator(part).evaluate((one) => one.getBoundingClientRect().toJSON());
    await expect.poll(async () => (await box(".stage")).width).toBeGreaterThan(0.56 * 1024);
    const [stage, header, morph, terms, caption] = await Promise.all(
      [".stage", ".outcome header", ".morph", ".terms", ".caption"].map(box),
    );
    expect(stage.height).toBeCloseTo(stage.width, 0);
    expect(header.left).toBeGreaterThan(stage.right);
    expect(morph.top).toBeGreaterThan(stage.bottom);
    expect(terms.top).toBeGreaterThanOrEqual(morph.bottom);
    expect(terms.bottom).toBeGreaterThan(0.95 * 768);
    expect(Math.max(terms.bottom, caption.bottom)).toBeLessThanOrEqual(768);
    expect(await page.evaluate(() => document.documentElement.scrollHeight)).toBeLessThanOrEqual(768);
  });
}

/** What the presentation shows: words by the lines they fill, what is pressed and the picture by their boxes. */
const PARTS = ".headline, .status :is(dt, dd), .term, .share, .caption, .present-keys, .percent";
const BOXES = ".stage, .stack, .outcome header :is(button, select), .morph > :is(button, select)";

/** Pixels by which lines of neighbours may touch: they are higher than their letters. */
const TOUCH = 3;

for (const lang of ["en", "de"]) {
  test(`a presentation writes nothing over another part or over the edge, on low screens neither (${lang})`, async ({
    page,
  }) => {
    await page.goto(`./?lang=${lang}#v=1&preset=hand`);
    await finished(page);
    await page.locator("button.present").click();
    await expect(page.locator(".present-keys")).toBeVisible();
    for (const [width, height] of [
      [740, 360],
      [844, 390],
      [900, 500],
      [800, 600],
      [1024, 600],
      [1280, 600],
      [1280, 800],
    ]) {
      const size = `${width} × ${height}`;
      await page.setViewportSize({ width, height });
      const side = () => page.locator(".stage").evaluate((stage) => stage.getBoundingClientRect().bottom);
      await expect.poll(side, size).toBeLessThan(height);
      const seen = await page.evaluate(
        ([parts, boxes]) => {
          const lines = [...document.querySelectorAll(parts)].flatMap((part) => {
            const range = document.createRange();
            range.selectNodeContents(part);
            return { name: part.textContent, box: range.getBoundingClientRect() };
          });
          const whole = [...document.querySelectorAll(boxes)].map((part) => {
            return { name: part.className, box: part.getBoundingClientRect() };
          });
          return [...lines, ...whole]
            .filter(({ box }) => box.width > 0)
            .map(({ name, box }) => ({ name, ...box.toJSON() }));
        },
        [PARTS, BOXES] as const,
      );
      expect(seen.length, size).toBeGreaterThan(15);
      for (const [k, a] of seen.entries()) {
        expect(a.bottom, `${size}: ${a.name}`).toBeLessThanOrEqual(height);
        expect(a.right, `${size}: ${a.name}`).toBeLessThanOrEqual(width);
        for (const b of seen.slice(k + 1)) {
          const [across, down] = [
            Math.min(a.right, b.right) - Math.max(a.left, b.left),
            Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top),
          ];
          expect(Math.min(across, down), `${size}: ${a.name} | ${b.name}`).toBeLessThan(TOUCH);
        }
      }
      expect(await page.evaluate(() => document.documentElement.scrollHeight), size).toBeLessThanOrEqual(height);
    }
  });
}

test("the focus goes round what a presentation shows, and to nothing that is hidden", async ({ page }) => {
  await page.goto("./#v=1&preset=ellipse&finest=5");
  await finished(page);
  await button(page, "Present").click();
  await expect(button(page, "Leave")).toBeFocused();
  for (const key of ["Tab", "Shift+Tab"]) {
    for (let k = 0; k < 15; k += 1) {
      await page.keyboard.press(key);
      expect(await page.evaluate(() => document.activeElement?.closest("body > header")?.textContent)).toBeUndefined();
    }
  }
});

test("a presentation leaves out how many iterations, and says the energy, also where none was needed", async ({
  page,
}) => {
  await page.goto("./#v=1&preset=hand&finest=5");
  await finished(page);
  const number = (name: string) => page.locator(`.status data[data-name="${name}"]`);
  await expect(number("iteration")).toHaveCount(0);
  await button(page, "Present").click();
  for (const name of ["level", "total", "mismatch-max"]) await expect(number(name)).toBeVisible();
  await expect(number("mismatch-mean")).toBeHidden();
});

test("on a screen higher than wide, all of a presentation is as wide as the screen", async ({ page }) => {
  await page.setViewportSize({ width: 800, height: 1280 });
  await page.goto("./#v=1&preset=ellipse&finest=5");
  await finished(page);
  await button(page, "Present").click();
  const box = (part: string) => page.locator(part).evaluate((one) => one.getBoundingClientRect().toJSON());
  await expect.poll(async () => (await box(".stage")).width).toBeGreaterThan(0.9 * 800);
  expect((await box(".morph")).top - (await box(".stage")).bottom).toBeLessThan(20);
});
