/** The whole state in the address, and what damage to it comes to. */

import { expect, type Page, test } from "@playwright/test";
import { PRESETS } from "../../www/shapes/presets";
import { mutate, seeded } from "../../www/testing/mutate";
import { button, clear, drawn, ellipse, finished, result, settings, stroke, value, watch } from "./handles";

const MUTATIONS = 200;
const LEAF = PRESETS.find(({ id }) => id === "leaf")?.title ?? "";

test("a link brings back shapes, settings, view and morph in a fresh profile, and shows the match", async ({
  page,
  browser,
  baseURL,
}) => {
  await page.goto("./#v=2&preset=ellipse&finest=5&match=later");
  await clear(page);
  await stroke(page, "Reference", ellipse(0.2, 0.15));
  await stroke(page, "Template", ellipse(0.15, 0.2));
  await settings(page).click();
  await page.getByLabel("Bending", { exact: true }).fill("0.5");
  await page.getByLabel("Bending", { exact: true }).press("Enter");
  await button(page, "Match").click();
  await finished(page);
  await page.getByLabel("View", { exact: true }).selectOption("Stretch");
  await page.getByRole("slider", { name: "Morph" }).fill("40");
  await expect.poll(() => page.url()).toMatch(/&bending=0\.5&finest=5&view=stretch&morph=0\.4$/);
  const address = page.url();
  expect(address.length).toBeLessThan(2000);

  const context = await browser.newContext({ baseURL });
  const fresh = await context.newPage();
  const seen = watch(fresh);
  await fresh.goto(address);
  await finished(fresh);
  await expect(fresh.getByLabel("View", { exact: true })).toHaveValue("stretch");
  await expect(fresh.getByRole("slider", { name: "Morph" })).toHaveValue("40");
  expect(await value(fresh, "level")).toBe(5);
  expect(fresh.url()).toBe(address);
  await expect(result(fresh)).toHaveAccessibleName(/matched, at most/);
  expect(seen.errors).toEqual([]);
  await context.close();
});

test("a setting in the query stands instead of the link's, and the fragment takes it over", async ({ page }) => {
  await page.goto("./?bending=0&match=later#v=2&preset=ellipse&finest=5&bending=1");
  await expect.poll(() => new URL(page.url()).hash).toBe("#v=2&preset=ellipse&bending=0&finest=5");
  expect(new URL(page.url()).search).toBe("");
  await page.goto("./?bending=much&match=later#v=2&preset=leaf");
  await expect(page.getByRole("alert")).toContainText("Bending is “much”, but must be a number from 0 to 100");
  await expect(button(page, LEAF)).toHaveAttribute("aria-pressed", "true");
});

test("an anchor of the page leads to its place and leaves the shapes alone", async ({ page }) => {
  await page.goto("./#v=2&preset=leaf&match=later");
  await openAll(page, ["#method"]);
  await expect(button(page, LEAF)).toHaveAttribute("aria-pressed", "true");
  await expect(button(page, "Undo")).toBeDisabled();
  await expect(page.getByRole("alert")).toHaveText("");
});

test(`${MUTATIONS} mutated links: no error, no injection, the shapes kept, and undo brings everything back`, async ({
  page,
}) => {
  test.setTimeout(400_000);
  const seen = watch(page);
  await page.goto("./#v=2&preset=ellipse&finest=5&match=later");
  await clear(page);
  await stroke(page, "Reference", ellipse(0.2, 0.15));
  await stroke(page, "Template", ellipse(0.15, 0.2));
  await expect.poll(() => drawn(page, "Template")).toBeTruthy();
  const address = page.url();
  const link = `${new URL(address).hash.slice(1)}&bending=0.5&view=stretch&morph=0.5&match=later`;
  const random = seeded(2026);
  const outcomes = await openAll(
    page,
    Array.from({ length: MUTATIONS }, () => `#${mutate(link, random)}`),
  );
  expect(outcomes).toHaveLength(MUTATIONS);
  for (const { said, strange } of outcomes) {
    expect(strange).toBeNull();
    if (said !== "") expect(said).toMatch(/^The link could not be read: .+\. Everything is left as it was\.$/s);
  }
  const refused = outcomes.filter(({ said }) => said !== "").length;
  expect(refused).toBeGreaterThan(100);
  expect(refused).toBeLessThan(MUTATIONS);
  expect(await page.evaluate(() => "injected" in window || "injected" in {})).toBe(false);
  // The view and the morph are how one looks, and no step to undo.
  const drawing = new URL(address).hash.slice(1).replace(/&(view|morph)=[^&]*/g, "");
  expect(await undoTo(page, drawing)).toBeGreaterThan(0);
  expect(seen.errors).toEqual([]);
});

/** Presses Undo until the session, as the browser's storage has it at once, is this; returns how often. */
async function undoTo(page: Page, text: string): Promise<number> {
  return page.evaluate(
    ({ text, most }) => {
      const undo = [...document.querySelectorAll("button")].find(({ textContent }) => textContent === "Undo");
      const key = `thinshell:${sessionStorage.getItem("thinshell:tab")}`;
      const now = () => JSON.parse(localStorage.getItem(key) ?? "{}").text?.replace(/&(view|morph)=[^&]*/g, "");
      for (let pressed = 0; pressed <= most; pressed += 1) {
        if (now() === text) return pressed;
        undo?.click();
      }
      throw new Error(`after ${most} steps back it is still ${now()}`);
    },
    { text, most: MUTATIONS },
  );
}

type Outcome = { said: string; strange: string | null };

/** Opens links over the page, one after the other, and tells what each has come to. */
async function openAll(page: Page, hashes: readonly string[]): Promise<Outcome[]> {
  return page.evaluate(async (hashes) => {
    const outcomes: Outcome[] = [];
    for (const hash of hashes) {
      const before = location.hash;
      await new Promise((resolve) => {
        addEventListener("hashchange", resolve, { once: true });
        location.hash = hash;
        // The same fragment again is no change.
        if (location.hash === before) resolve(null);
      });
      await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
      const alert = document.querySelector('[role="alert"]');
      const said = alert?.querySelector(".text")?.textContent ?? "";
      // The alert has text and its own button, nothing that a link could have brought.
      const strange = alert?.querySelector(":not(.problem, .text, button)")?.outerHTML ?? null;
      alert?.querySelector("button")?.click();
      outcomes.push({ said, strange });
    }
    return outcomes;
  }, hashes);
}
