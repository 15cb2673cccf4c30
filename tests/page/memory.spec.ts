/** What is drawn is kept: over a reload, a killed tab, a second tab, and a storage that keeps nothing. */

import { AxeBuilder } from "@axe-core/playwright";
import { type BrowserContext, expect, type Page, test } from "@playwright/test";
import { button, drawn, ellipse, stroke, watch } from "./handles";

/** Draws a reference that nobody else has, and returns it as the address has it. */
async function draw(page: Page, width: number): Promise<string> {
  await button(page, "Clear reference").click();
  await stroke(page, "Reference", ellipse(width, 0.15));
  await expect.poll(() => drawn(page, "Reference")).toBeTruthy();
  return drawn(page, "Reference") ?? "";
}

async function fresh(context: BrowserContext, address = "./"): Promise<Page> {
  const page = await context.newPage();
  await page.goto(address);
  await expect(button(page, "Match")).toBeVisible();
  return page;
}

function recent(page: Page) {
  return page.locator("summary", { hasText: "Recent sessions" });
}

test("a tab that is killed loses nothing, not even the last step", async ({ page, context }) => {
  await page.goto("./#v=2&preset=ellipse&match=later");
  await draw(page, 0.2);
  await stroke(page, "Template", ellipse(0.12, 0.22));
  const client = await context.newCDPSession(page);
  const crashed = page.waitForEvent("crash");
  client.send("Page.crash").catch(() => {});
  await crashed;
  const after = await fresh(context);
  await expect.poll(() => drawn(after, "Reference")).toBeTruthy();
  expect(drawn(after, "Template")).toBeTruthy();
  await expect(button(after, "Clear template")).toBeEnabled();
});

test("two tabs keep a session each: neither overwrites the other's, and both can be come back to", async ({
  page,
  context,
}) => {
  test.slow();
  await page.goto("./#v=2&preset=ellipse&match=later");
  const first = await draw(page, 0.2);
  const second = await fresh(context);
  const other = await draw(second, 0.3);
  expect(other).not.toBe(first);
  await page.reload();
  await expect.poll(() => drawn(page, "Reference")).toBe(first);
  // At a bare address, too, a tab goes on with its own session.
  await page.goto("./");
  await expect.poll(() => drawn(page, "Reference")).toBe(first);

  await recent(page).click();
  const list = page.getByRole("list", { name: "Recent sessions" });
  await expect(list.getByRole("listitem")).toHaveCount(2);
  const { violations } = await new AxeBuilder({ page }).include("details.recent").analyze();
  expect(violations).toEqual([]);
  await list
    .getByRole("button", { name: /^Open: Drawn shapes/ })
    .last()
    .click();
  await expect.poll(() => drawn(page, "Reference")).toBe(other);
  await button(page, "Undo").click();
  await expect.poll(() => drawn(page, "Reference")).toBe(first);

  await list
    .getByRole("button", { name: /^Delete: / })
    .last()
    .click();
  await expect(list.getByRole("listitem")).toHaveCount(1);
  await second.close();
});

test("a link opened in a second tab leaves the first one's session alone", async ({ page, context }) => {
  await page.goto("./#v=2&preset=ellipse&match=later");
  const first = await draw(page, 0.2);
  const second = await fresh(context, "./#v=2&preset=leaf&match=later");
  await button(second, "Fit").click();
  await page.goto("./");
  await expect.poll(() => drawn(page, "Reference")).toBe(first);
});

test("a storage that is full or forbidden is told of in a sentence, and everything else works", async ({ page }) => {
  const seen = watch(page);
  await page.addInitScript(() => {
    for (const name of ["localStorage", "sessionStorage"]) {
      Object.defineProperty(window, name, {
        get: () => {
          throw new DOMException("denied", "SecurityError");
        },
      });
    }
  });
  await page.goto("./#v=2&preset=ellipse&match=later");
  await expect(page.getByRole("alert")).toHaveText("");
  await draw(page, 0.2);
  await expect(page.getByRole("alert")).toContainText("This browser keeps nothing for you");
  await button(page, "Dismiss").click();
  await stroke(page, "Template", ellipse(0.2, 0.15));
  await expect(page.getByRole("alert")).toHaveText("");
  const address = page.url();
  await page.reload();
  await expect.poll(() => page.url()).toBe(address);
  await recent(page).click();
  await expect(page.getByText("What you draw is kept here")).toBeVisible();
  expect(seen.errors).toEqual([]);
});

test("a session that cannot be read is told of, listed and left as it was, whatever is drawn after it", async ({
  page,
}) => {
  const LATER = JSON.stringify({ at: 1, text: "v=7&what=a later version wrote" });
  await page.addInitScript((text) => {
    if (sessionStorage.getItem("thinshell:tab")) return;
    sessionStorage.setItem("thinshell:tab", "a");
    localStorage.setItem("thinshell:a", text);
  }, LATER);
  await page.goto("./?match=later");
  await expect(page.getByRole("alert")).toContainText("could not be read: version “7” is not known. It stays under");
  await button(page, "Dismiss").click();
  await draw(page, 0.2);
  await page.reload();
  await expect(page.getByRole("alert")).toHaveText("");
  await recent(page).click();
  const list = page.getByRole("list", { name: "Recent sessions" });
  await expect(list.getByRole("listitem")).toHaveCount(2);
  await expect(list.getByRole("listitem").last()).toContainText("Could not be read: version “7” is not known");
  expect(await page.evaluate(() => Object.values(localStorage))).toContain(LATER);
  await list.getByRole("button", { name: /^Delete: Could not/ }).click();
  await expect(list.getByRole("listitem")).toHaveCount(1);
});
