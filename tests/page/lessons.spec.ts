/** Lessons: read from start to end, by hand and by keyboard; their tasks take what is right, and nothing else. */

import AxeBuilder from "@axe-core/playwright";
import { expect, type FrameLocator, type Locator, type Page, test } from "@playwright/test";
import { filesOf } from "../../scripts/lib/lessons.mjs";
import { allLessons } from "../../www/lessons/files";
import { watch } from "./handles";

const LESSONS = allLessons(filesOf("docs/lessons"));
const WIDTHS = [320, 390, 768, 1280, 3840];

/** Notes what the policy has refused, in the page and in its frames. */
async function violations(page: Page): Promise<string[]> {
  const all: string[] = [];
  await page.exposeFunction("refused", (what: string) => all.push(what));
  await page.addInitScript(() => {
    document.addEventListener("securitypolicyviolation", ({ violatedDirective, blockedURI }) => {
      (window as unknown as { refused(what: string): void }).refused(`${violatedDirective}: ${blockedURI}`);
    });
  });
  return all;
}

function picture(page: Page): FrameLocator {
  return page.frameLocator(".live iframe");
}

/** Checks the task until its match is there. */
async function outcome(page: Page): Promise<Locator> {
  const task = page.getByRole("region", { name: "Do" });
  await expect(async () => {
    await task.getByRole("button", { name: "Check" }).click();
    await expect(task.getByRole("status")).toContainText(/Right\.|Not yet\./, { timeout: 1000 });
  }).toPass({ timeout: 90_000 });
  return task.getByRole("status");
}

for (const { id, title, steps } of LESSONS) {
  test(`“${title}”, from its start to its end`, async ({ page }) => {
    test.setTimeout(400_000);
    const seen = watch(page);
    const refused = await violations(page);
    await page.goto("./lessons.html");
    await page.getByRole("link", { name: title, exact: true }).click();
    await page.getByLabel("Teacher’s notes").check();
    for (const [index, step] of steps.entries()) {
      await expect(page.getByText(`Step ${index + 1} of ${steps.length}`)).toBeVisible();
      await expect(page.locator(".step .text > h3")).toBeVisible();
      await expect(picture(page).locator("canvas:visible, button:visible").first()).toBeVisible({ timeout: 20_000 });
      if (step.predict) {
        const section = page.getByRole("region", { name: "Predict first" });
        await expect(section.locator(".prose")).toHaveCount(1);
        await section.getByRole("button", { name: "Show the answer" }).click();
        await expect(section.locator(".prose")).toHaveCount(2);
      }
      if (step.task) {
        await expect(await outcome(page)).toContainText("Not yet.");
        await page.getByRole("button", { name: "Show a solution" }).click();
        await expect(async () => expect(await outcome(page)).toContainText("Right.", { timeout: 500 })).toPass({
          timeout: 100_000,
        });
      }
      if (index === 0) {
        // What is in the frame has tests of its own.
        const axe = new AxeBuilder({ page }).exclude("iframe");
        expect((await axe.analyze()).violations).toEqual([]);
        for (const width of WIDTHS) {
          await page.setViewportSize({ width, height: 800 });
          const scrolled = () => page.evaluate(() => document.documentElement.scrollWidth);
          await expect.poll(scrolled, `${width}`).toBeLessThanOrEqual(width);
        }
        await page.setViewportSize({ width: 1280, height: 800 });
      }
      await page.getByRole("link", { name: index + 1 < steps.length ? "Next" : "To all lessons" }).click();
    }
    await expect(page.getByRole("link", { name: title, exact: true })).toBeVisible();
    expect(refused).toEqual([]);
    expect(
      seen.errors.filter((error) => !/GPU stall|WebGL/.test(error)),
      id,
    ).toEqual([]);
  });
}

test("a lesson is read by keyboard alone, and its task is solved by keyboard", async ({ page }) => {
  test.setTimeout(240_000);
  /** Tabs until what has the focus has the name; never more often than the page has places. */
  const reach = async (name: RegExp) => {
    for (let press = 0; press < 80; press += 1) {
      await page.keyboard.press("Tab");
      const focused = await page.evaluate(() => {
        const inner = (document.activeElement as HTMLIFrameElement | null)?.contentDocument?.activeElement;
        const element = inner && inner !== inner.ownerDocument.body ? inner : document.activeElement;
        const label = element?.id && element.ownerDocument.querySelector(`label[for="${element.id}"]`)?.textContent;
        const spoken = element?.cloneNode(true) as Element | undefined;
        for (const unspoken of spoken?.querySelectorAll('[aria-hidden="true"]') ?? []) unspoken.remove();
        return label || element?.getAttribute("aria-label") || spoken?.textContent || "";
      });
      if (name.test(focused.trim())) return;
    }
    throw new Error(`${name} cannot be reached by Tab`);
  };
  await page.goto("./lessons.html");
  await reach(/^Stretching, and why it is even$/);
  await page.keyboard.press("Enter");
  for (let step = 1; step < 6; step += 1) {
    await expect(page.getByText(`Step ${step} of 6`)).toBeVisible();
    if (step > 1) await expect(page.locator(".step .text > h3")).toBeFocused();
    await reach(/^Show the answer$/);
    await page.keyboard.press("Enter");
    await expect(page.locator(".predict .prose")).toHaveCount(2);
    await reach(/^Next$/);
    await page.keyboard.press("Enter");
  }
  await expect(page.locator(".step .text > h3")).toHaveText("Make the stretch even");
  await expect(picture(page).locator(".headline")).toContainText("Fits", { timeout: 45_000 });
  await reach(/^Check$/);
  await page.keyboard.press("Enter");
  await expect(page.getByRole("region", { name: "Do" }).getByRole("status")).toContainText("Not yet.");
  // Stretching counts again, and bending no more: each switch matches anew.
  for (const [term, on] of [
    ["Stretching", "true"],
    ["Bending", "false"],
  ]) {
    await page.locator(".step .text > h3").focus();
    await reach(new RegExp(`^${term}$`));
    await page.keyboard.press("Enter");
    await expect(picture(page).getByRole("switch", { name: term })).toHaveAttribute("aria-checked", on);
  }
  await expect(picture(page).locator(".headline")).toContainText("Fits", { timeout: 45_000 });
  await page.locator(".step .text > h3").focus();
  await reach(/^Check$/);
  await page.keyboard.press("Enter");
  await expect(page.getByRole("region", { name: "Do" }).getByRole("status")).toContainText("Right.", {
    timeout: 20_000,
  });
});

for (const colorScheme of ["light", "dark"] as const) {
  test(`the list, a task with its outcome and the teacher's notes are accessible (${colorScheme})`, async ({
    page,
  }) => {
    test.slow();
    await page.emulateMedia({ colorScheme });
    await page.goto("./lessons.html");
    await expect(page.getByRole("listitem").first()).toBeVisible();
    expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
    await page.goto("./lessons.html#stretch/6");
    await page.getByLabel("Teacher’s notes").check();
    await expect(await outcome(page)).toContainText("Not yet.");
    expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  });
}

test("a lesson that is not there is said to be none", async ({ page }) => {
  await page.goto("./lessons.html#alchemy");
  await expect(page.getByRole("alert")).toContainText("There is no lesson “alchemy” here.");
});

test("in German the page around the lessons is German, and the lessons say that they are English", async ({ page }) => {
  await page.goto("./lessons.html?lang=de");
  await expect(page.getByRole("heading", { level: 1 })).toHaveText("Lektionen");
  await expect(page.locator(".promise")).toContainText("die Texte der Lektionen sind Englisch");
  await page.getByRole("link", { name: "Bending, and features" }).click();
  await expect(page.getByRole("link", { name: "Weiter" })).toBeVisible();
  await expect(page.locator(".lesson h2")).toHaveAttribute("lang", "en");
  await expect(picture(page).getByLabel("Ansicht", { exact: true })).toBeVisible({ timeout: 20_000 });
});

test("the page leads to its lessons", async ({ page }) => {
  await page.goto("./");
  await page.getByRole("link", { name: "Lessons" }).click();
  await expect(page.getByRole("heading", { level: 1, name: "Lessons" })).toBeVisible();
});
