/** Nothing gets stuck: whatever fails or hangs is said, can be cancelled, and leaves a page that works. */

import { expect, type Page, test, type Worker } from "@playwright/test";
import { button, choose, finished, value, watch } from "./handles";

const EASY = "./#v=1&preset=ellipse&finest=5";

/** Notes every worker that the page asks for. */
async function countWorkers(page: Page): Promise<() => Promise<number>> {
  await page.addInitScript(() => {
    Object.assign(window, { asked: 0 });
    window.Worker = new Proxy(Worker, {
      construct(target, parts) {
        Reflect.set(window, "asked", Reflect.get(window, "asked") + 1);
        return Reflect.construct(target, parts);
      },
    });
  });
  return () => page.evaluate(() => Reflect.get(window, "asked"));
}

/** The worker never comes back from what it does next. */
async function hang(worker: Worker): Promise<void> {
  await worker.evaluate(() => {
    setTimeout(() => {
      for (;;);
    });
  });
}

test("where no worker may start, each press of Match tries once and says why", async ({ page }) => {
  await page.route(/\/$/, async (route) => {
    const answer = await route.fetch();
    await route.fulfill({
      response: answer,
      headers: { ...answer.headers(), "content-security-policy": "worker-src 'none'" },
    });
  });
  const asked = await countWorkers(page);
  await page.goto("./");
  await expect(page.getByRole("alert")).toContainText(
    "The solver could not be started, because the browser refuses the page's worker. Reload the page",
  );
  const first = await asked();
  expect(first).toBeLessThanOrEqual(2);
  await button(page, "Dismiss").click();
  await button(page, "Match").click();
  await expect(page.getByRole("alert")).toContainText("The solver could not be started");
  await expect(page.getByRole("status")).toContainText("Ready");
  // Endless tries would go on meanwhile.
  await page.waitForTimeout(500);
  expect(await asked()).toBe(2 * first);
});

test("Match after a failed load says so, and works as soon as the solver can be had", async ({ page }) => {
  let there = false;
  await page.route("**/*.wasm", (route) => (there ? route.continue() : route.abort()));
  await page.goto(EASY);
  await expect(page.getByRole("alert")).toContainText("The solver could not be loaded; check the connection");
  await button(page, "Dismiss").click();
  await button(page, "Match").click();
  await expect(page.getByRole("alert")).toContainText("The solver could not be loaded; check the connection");
  await expect(page.getByRole("status")).toContainText("Ready");
  there = true;
  await button(page, "Match").click();
  await finished(page);
  await expect(page.getByRole("alert")).toBeEmpty();
});

test("while the solver is on its way, the status says so, and Cancel ends the waiting", async ({ page }) => {
  let arrive = () => {};
  const arrived = new Promise<void>((resolve) => {
    arrive = resolve;
  });
  await page.route("**/*.wasm", async (route) => {
    await arrived;
    await route.continue();
  });
  await page.goto(EASY);
  await button(page, "Match").click();
  await expect(page.getByRole("status")).toContainText("Loading the solver");
  await expect(page.getByRole("progressbar", { name: "Match" })).toBeVisible();
  await button(page, "Cancel").click();
  await expect(page.getByRole("status")).toContainText("Cancelled");
  await button(page, "Match").click();
  arrive();
  await finished(page);
});

test.describe("Cancel ends whatever the solver is doing and keeps all that was drawn and chosen", () => {
  test("while it takes up the shapes", async ({ page }) => {
    const seen = watch(page);
    await page.goto("./#v=1&preset=moon&finest=5&bending=0.5");
    await button(page, "Match").click();
    await finished(page);
    const [before] = page.workers();
    await hang(before);
    // Its successor, too, or the page would help itself before anybody looks.
    page.on("worker", hang);
    await button(page, "Match").click();
    await expect(page.getByRole("status")).toContainText("Preparing the shapes");
    await expect(page.getByRole("progressbar", { name: "Match" })).toBeVisible();
    page.off("worker", hang);
    await button(page, "Cancel").click();
    await expect(page.getByRole("status")).toContainText("Cancelled");
    await expect(page.getByRole("progressbar")).toHaveCount(0);
    await expect.poll(() => page.workers().includes(before)).toBe(false);
    await expect(button(page, "Bean → crescent")).toHaveAttribute("aria-pressed", "true");
    expect(page.url()).toContain("bending=0.5");
    await button(page, "Match").click();
    await finished(page);
    expect(seen.errors).toEqual([]);
  });

  test("while the match follows the hand", async ({ page }) => {
    await page.goto(EASY);
    await page.getByRole("switch", { name: "Live" }).click();
    await finished(page);
    const [before] = page.workers();
    await hang(before);
    await page.getByRole("application", { name: "Template shape" }).press("ArrowLeft");
    await expect(page.getByRole("progressbar", { name: "Match" })).toBeVisible();
    await button(page, "Cancel").click();
    await expect(page.getByRole("status")).toContainText("Cancelled");
    await expect.poll(() => page.workers().includes(before)).toBe(false);
    await page.getByRole("application", { name: "Template shape" }).press("ArrowRight");
    await finished(page);
    expect(await value(page, "mismatch-max")).toBeLessThan(0.5);
  });

  test("while two settings are compared", async ({ page }) => {
    await page.goto(EASY);
    const solver = new Set(page.workers());
    await page.getByText("Compare side by side").click();
    await expect.poll(() => page.workers().length).toBe(2);
    const other = page.workers().find((worker) => !solver.has(worker));
    if (!other) throw new Error("the comparison has no worker");
    // Not before it has loaded: until then there is nothing to end.
    await button(page, "Compare").click();
    await expect(page.getByRole("row", { name: "Energy" })).toBeVisible();
    await hang(other);
    await button(page, "Compare").click();
    await button(page, "Stop comparing").click();
    await expect(button(page, "Stop comparing")).toBeDisabled();
    await expect.poll(() => page.workers().includes(other)).toBe(false);
    await button(page, "Compare").click();
    await expect(page.getByRole("row", { name: "Energy" })).toBeVisible();
  });
});

test("a start that the solver does not take up goes to a fresh one", async ({ page }) => {
  await page.goto(EASY);
  await button(page, "Match").click();
  await finished(page);
  const [before] = page.workers();
  await hang(before);
  await choose(page, "Finest grid", "65 × 65");
  await button(page, "Match").click();
  await finished(page);
  expect(await value(page, "level")).toBe(6);
  expect(page.workers()).not.toContain(before);
});
