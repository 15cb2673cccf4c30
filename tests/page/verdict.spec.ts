import { expect, type Page, test } from "@playwright/test";
import { encode } from "../../www/link/text";
import type { Shape } from "../../www/shapes/geometry";
import { button, finished, value } from "./handles";

function circle(radius: number): Float64Array {
  return Float64Array.from({ length: 256 }, (_, i) => {
    const t = (2 * Math.PI * (i >> 1)) / 128;
    return 0.5 + radius * (i % 2 === 0 ? Math.cos(t) : Math.sin(t));
  });
}

/** A square cut open from the right to its middle. */
function slit(width: number): Float64Array {
  const [low, high] = [0.5 - width / 2, 0.5 + width / 2];
  return Float64Array.from([0.3, 0.3, 0.7, 0.3, 0.7, low, 0.5, low, 0.5, high, 0.7, high, 0.7, 0.7, 0.3, 0.7]);
}

async function open(page: Page, reference: Shape, template: Shape, finest: number): Promise<void> {
  await page.goto(`./#${encode({ reference, template, pins: [], settings: { finest }, preset: null })}&match=later`);
}

test("a match that fits says so, and what it is measured by", async ({ page }) => {
  await open(page, [circle(0.2)], [circle(0.25)], 6);
  await button(page, "Match").click();
  await finished(page);
  await expect(page.getByRole("status")).toContainText("Fits: nowhere more than 0.");
  expect(await value(page, "cover-max")).toBeLessThan(0.5);
  expect(Math.abs((await value(page, "measure")) - 1)).toBeLessThan(0.01);
});

test("a hole that was not reached is named, however close the curve lies", async ({ page }) => {
  await open(page, [circle(0.25)], [circle(0.25), circle(0.1)], 6);
  await button(page, "Match").click();
  await finished(page);
  const status = page.getByRole("status");
  await expect(status).toContainText("hole");
  await expect(status).not.toContainText("Fits:");
  expect(await value(page, "cover-max")).toBeGreaterThan(1);
  expect(await value(page, "measure")).toBeLessThan(0.9);
});

test("a gap that the grid does not resolve is named before the match, and one press matches on the grid that does", async ({
  page,
}) => {
  await open(page, [circle(0.2)], [slit(1.5 / 64)], 6);
  const status = page.getByRole("status");
  await expect(status).toContainText("The target's narrowest gap");
  await expect(status).toContainText("is 1.5 cells wide; a grid of 129² resolves it.");
  await button(page, "Match on 129 × 129").click();
  await finished(page);
  expect(await value(page, "level")).toBe(7);
  await expect(status).not.toContainText("narrowest gap");
});

test("a gap that no grid resolves is named without a button", async ({ page }) => {
  await open(page, [circle(0.2)], [slit(0.3 / 128)], 7);
  await expect(page.getByRole("status")).toContainText("not even a grid of 513² resolves it");
  await expect(page.getByRole("button", { name: /^Match on/ })).toHaveCount(0);
});
