/** Strokes that are no shapes yet: judged when the hand lets go, with a way out. */

import { expect, test } from "@playwright/test";
import { button, clear, drawn, ellipse, loops, stroke, surface } from "./handles";

const PLAIN = "./#v=1&preset=star&finest=5&match=later";

function eight(): [number, number][] {
  return Array.from({ length: 60 }, (_, i) => {
    const t = (2 * Math.PI * i) / 60;
    return [0.5 + 0.3 * Math.sin(t), 0.5 + 0.2 * Math.sin(2 * t)];
  });
}

for (const [title, points, words, way] of [
  ["crosses itself", eight(), "This line crosses itself", "Keep its larger part"],
  ["is too small", ellipse(0.03, 0.03, 0.3, 0.7), "the grid sees nothing below four", "Enlarge it"],
  ["crosses the border", ellipse(-0.2, 0.2, 0.85, 0.5), "crosses the border of the box", "Move it inside"],
] as const) {
  test(`a stroke that ${title} waits for what is to become of it, and the way out makes a shape of it`, async ({
    page,
  }) => {
    await page.goto(PLAIN);
    await clear(page);
    await stroke(page, "Reference", points);
    await expect(page.getByRole("alert")).toContainText(words);
    await expect(button(page, "Clear reference")).toBeDisabled();
    await button(page, way).click();
    await expect(page.getByRole("alert")).toBeEmpty();
    await expect.poll(() => drawn(page, "Reference")).toBeTruthy();
    await button(page, "Undo").click();
    await expect.poll(() => drawn(page, "Reference")).toBe("");
  });
}

test("a line there and back encloses nothing; drawing again, the sentence goes", async ({ page }) => {
  await page.goto(PLAIN);
  await clear(page);
  const there = Array.from({ length: 15 }, (_, i) => [0.3 + i / 40, 0.5] as const);
  await stroke(page, "Template", [...there, ...there.toReversed()]);
  await expect(page.getByRole("alert")).toContainText("This line encloses nothing");
  await stroke(page, "Template", ellipse(0.2, 0.2));
  await expect(page.getByRole("alert")).toBeEmpty();
  await expect.poll(() => drawn(page, "Template")).toBeTruthy();
});

test("what has been said of shapes goes with them, by undo as well", async ({ page }) => {
  await page.goto(PLAIN);
  await button(page, "Clear template").click();
  await button(page, "Match").click();
  await expect(page.getByRole("alert")).toContainText("The target has no points");
  await button(page, "Undo").click();
  await expect(page.getByRole("alert")).toBeEmpty();
  await stroke(page, "Reference", ellipse(0.1, 0.1, 0.5, 0.95));
  await expect(page.getByRole("alert")).toContainText("crosses the border");
  await button(page, "Redo").click();
  await expect(page.getByRole("alert")).toBeEmpty();
});

test("just beside the curve of an example, a stroke bends it and replaces nothing", async ({ page }) => {
  await page.goto("./#v=1&preset=ellipse&match=later");
  const box = await surface(page, "Reference").boundingBox();
  if (!box) throw new Error("the reference surface is not on the page");
  for (const off of [6, 10, 14]) {
    const from = 0.65 + off / box.width;
    await stroke(page, "Reference", [
      [from, 0.5],
      [from + 0.02, 0.5],
      [from + 0.04, 0.5],
    ]);
    await expect.poll(() => drawn(page, "Reference")).toBeTruthy();
    const xs = loops(drawn(page, "Reference")).flatMap((points) => points.map(([x]) => x));
    // The circle is still there, pulled by as much as the hand has moved.
    expect(Math.min(...xs)).toBeCloseTo(0.35, 2);
    expect(Math.max(...xs)).toBeCloseTo(0.69, 2);
    await button(page, "Undo").click();
    await expect.poll(() => drawn(page, "Reference")).toBeNull();
  }
});
