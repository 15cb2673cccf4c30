/** The page in German: no English is left to be seen, the switch takes nothing away, and long words have room. */

import { AxeBuilder } from "@axe-core/playwright";
import { expect, type Locator, type Page, test } from "@playwright/test";
import { file, svgFile } from "./files";
import { ours, watch } from "./handles";

/** What stands in English sentences and in no German ones; the paper keeps its title, and runs their own words. */
const TELLING =
  /\b(the|and|of|is|are|to|with|press|curves?|grid|target|shapes?|match(ed)?|settings?|draw|your|this|cells|undo|clear|view|energy|stretch|bending)\b/i;

const EASY = "./?lang=de#v=2&preset=ellipse&finest=5";

function button(page: Page, name: string): Locator {
  return page.getByRole("button", { name, exact: true });
}

async function matched(page: Page, address = EASY): Promise<void> {
  await page.goto(address);
  await expect(page.getByRole("status").locator('data[data-name="mismatch-max"]')).toBeVisible({ timeout: 45_000 });
}

/** All that can be read or is read out, but for what is marked as English. */
async function texts(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const found: string[] = [document.title];
    const walk = (element: Element) => {
      if (element.closest("[lang=en], math, script, style, .u-legend .u-value") && element !== document.documentElement)
        return;
      for (const name of ["aria-label", "title", "aria-valuetext", "placeholder", "alt"]) {
        const text = element.getAttribute(name);
        if (text) found.push(text);
      }
      for (const child of element.childNodes) {
        if (child instanceof Text && child.data.trim()) found.push(child.data.trim());
        else if (child instanceof Element) walk(child);
      }
    };
    walk(document.body);
    return found;
  });
}

async function expectGerman(page: Page): Promise<void> {
  await expect(page.locator("html")).toHaveAttribute("lang", "de");
  expect((await texts(page)).filter((text) => TELLING.test(text))).toEqual([]);
}

async function expectRoom(page: Page): Promise<void> {
  const [needed, given] = await page.evaluate(() => [document.documentElement.scrollWidth, innerWidth]);
  expect(needed).toBeLessThanOrEqual(given);
}

async function expectAccessible(page: Page): Promise<void> {
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
}

/** Every place that somebody can come to, and how. */
const ROUTES: Readonly<Record<string, (page: Page) => Promise<void>>> = {
  "the page with everything open": async (page) => {
    await matched(page);
    for (const summary of await page.locator("details.later > summary").all()) await summary.click();
    await page.getByText("Für Kenner des Artikels").click();
    await button(page, "Vergleichen").click();
    await expect(page.getByRole("row", { name: /^Energie/ })).toBeVisible({ timeout: 45_000 });
    await expect(page.getByLabel("Dicke δ", { exact: true })).toBeVisible();
  },
  "every view": async (page) => {
    await matched(page);
    for (const view of ["stretch", "curvature", "mismatch", "bending", "volume"]) {
      await page.getByLabel("Ansicht", { exact: true }).selectOption(view);
      await expect(page.locator(".legend")).toBeVisible();
      await expectGerman(page);
    }
  },
  "a question and an announcement": async (page) => {
    await matched(page);
    await button(page, "Leeren: die Referenz").click();
    const surface = page.getByRole("application", { name: "Form der Referenz" });
    const box = await surface.boundingBox();
    if (!box) throw new Error("the reference is not on the page");
    const eight = (i: number) => {
      const t = (2 * Math.PI * i) / 60;
      return [
        box.x + (0.5 + 0.3 * Math.sin(t)) * box.width,
        box.y + (0.5 + 0.2 * Math.sin(2 * t)) * box.height,
      ] as const;
    };
    await page.mouse.move(...eight(0));
    await page.mouse.down();
    for (let i = 1; i < 60; i += 1) await page.mouse.move(...eight(i));
    await page.mouse.up();
    await expect(page.getByRole("alert")).toContainText("kreuzt sich selbst");
    await button(page, "Neu zeichnen").click();
    await button(page, "Leeren: das Ziel").click();
    await expect(page.locator(".sketch-tools [aria-live]")).toHaveText("Das Ziel ist jetzt leer.");
  },
  "the import and the gallery": async (page) => {
    await matched(page);
    await button(page, "Galerie öffnen").click();
    await expect(button(page, "Eichel")).toBeVisible({ timeout: 20_000 });
    await expect(button(page, "Österreich")).toBeVisible();
    await button(page, "Herz").click();
    await expect(button(page, "Als Referenz nehmen")).toBeEnabled({ timeout: 20_000 });
  },
  "the menus": async (page) => {
    await matched(page);
    await page.locator(".save summary").click();
    await expect(button(page, "Bild (PNG)")).toBeVisible();
    await expectGerman(page);
    await page.locator(".exchange summary").click();
    await expect(button(page, "Formen tauschen")).toBeVisible();
  },
  "a link that is none": async (page) => {
    await page.goto("./?lang=de#v=77&preset=ellipse");
    await expect(page.getByRole("alert")).toContainText("die Version „77“ ist unbekannt");
  },
  "an import that is refused, and one with notes": async (page) => {
    await matched(page);
    await button(page, "Importieren: die Referenz").click();
    const chosen = page.getByLabel("Datei wählen");
    await chosen.setInputFiles({ ...file("page.html", "text/html", "<html><p>text</p></html>") });
    await expect(page.getByRole("alert").getByText("Das ist eine Webseite")).toBeVisible();
    await expectGerman(page);
    await chosen.setInputFiles({ ...svgFile('<circle r="20"/><path d="M0 0L90 90"/>') });
    await expect(page.getByText("Offene Linien sind weggelassen")).toBeVisible();
  },
  surfaces: async (page) => {
    // Without a graphics card the solver has to share its core with what draws.
    test.slow();
    await page.goto("./?lang=de#space=1&finest=4");
    await expect(page.getByRole("status").locator('data[data-name="mismatch-max"]')).toBeVisible({ timeout: 90_000 });
    await expect(page).toHaveTitle("thinshell: elastischer Abgleich zweier Flächen");
    await page.locator("details.settings > summary").click();
    for (const view of ["area", "distance", "slice"]) {
      await page.getByLabel("Ansicht", { exact: true }).selectOption(view);
      await expectGerman(page);
    }
  },
  "the experiments": async (page) => {
    await page.goto("./experiments.html?lang=de");
    await expect(page.getByRole("heading", { name: "Abb. 4: die verformten Gitter" })).toBeVisible();
  },
};

for (const width of [320, 1280]) {
  test.describe(`at ${width} pixels`, () => {
    test.use({ viewport: { width, height: 900 } });

    for (const [name, come] of Object.entries(ROUTES)) {
      test(`${name}: all is German, has room, and is accessible`, async ({ page }) => {
        const seen = watch(page);
        await come(page);
        await expectGerman(page);
        await expectRoom(page);
        await expectAccessible(page);
        expect(ours(seen.errors)).toEqual([]);
      });
    }
  });
}

test("the switch, by keyboard, keeps shapes, result and settings, and the choice stays", async ({ page }) => {
  const seen = watch(page);
  await page.goto("./#v=2&preset=fish&finest=5&bending=0.5");
  const most = page.getByRole("status").locator('data[data-name="mismatch-max"]');
  await expect(most).toBeVisible({ timeout: 45_000 });
  await page.locator("details.settings > summary").click();
  await expect(page.getByLabel("Bending", { exact: true })).toHaveValue("0.5");
  const before = [held(page.url()), await most.getAttribute("value")];
  await button(page, "Deutsch").focus();
  await page.keyboard.press("Enter");
  await expect(page.getByRole("heading", { level: 1 })).toHaveText("Elastischer Abgleich zweier Kurven");
  await expect(button(page, "English")).toBeFocused();
  await expect(page.getByLabel("Biegung", { exact: true })).toHaveValue("0.5");
  await expect(most).toHaveText(/^\d,\d+$/);
  expect([held(page.url()), await most.getAttribute("value")]).toEqual(before);
  await expectGerman(page);

  await page.reload();
  await expect(button(page, "Abgleichen")).toBeVisible();
  await page.keyboard.press("Escape");
  await button(page, "English").click();
  await expect(button(page, "Match")).toBeVisible();
  await expect(page.locator("html")).toHaveAttribute("lang", "en");
  await expect(page.getByRole("heading", { level: 1 })).toHaveText("Elastic matching of two curves");
  expect(held(page.url())).toBe(before[0]);
  expect(seen.errors).toEqual([]);
});

test("surfaces change their language as they are, and the curves behind them with it", async ({ page }) => {
  test.slow();
  await page.goto("./#v=2&preset=fish&match=later");
  await button(page, "Surfaces").click();
  // Until they have come the settings are the curves'.
  await expect(page.getByLabel("Surface of the target")).toBeVisible();
  await page.locator("details.settings > summary").click();
  await page.getByLabel("Finest grid").selectOption("17³");
  await page.getByLabel("Surface of the target").selectOption("Rounded cube");
  await button(page, "Deutsch").click();
  await expect(page.getByLabel("Fläche des Ziels").locator("option:checked")).toHaveText("Abgerundeter Würfel");
  await expect(page.getByLabel("Feinstes Gitter")).toHaveValue("4");
  await expect(page.getByRole("heading", { level: 1 })).toHaveText("Elastischer Abgleich zweier Flächen");
  await expectGerman(page);
  await button(page, "Zurück zu den Kurven").click();
  await expect(page.getByRole("heading", { level: 1 })).toHaveText("Elastischer Abgleich zweier Kurven");
  await expect(page).toHaveTitle("thinshell: elastischer Abgleich zweier Kurven");
  await expectGerman(page);
  await button(page, "English").click();
  await expect(page.getByRole("heading", { level: 1 })).toHaveText("Elastic matching of two curves");
  await expect(page).toHaveTitle(/^thinshell: elastic matching of two curves/i);
});

test("a browser that prefers German gets it, English ones fetch none, and a link keeps no language", async ({
  browser,
}) => {
  const german = await browser.newContext({ locale: "de-AT" });
  const page = await german.newPage();
  await matched(page, "./#v=2&preset=ellipse&finest=5");
  await expectGerman(page);
  await german.close();

  const english = await browser.newContext({ locale: "en-GB", permissions: ["clipboard-read", "clipboard-write"] });
  const other = await english.newPage();
  await other.goto("./#v=2&preset=ellipse&finest=5&match=later");
  await expect(button(other, "Match")).toBeVisible();
  const scripts = await other.evaluate(() =>
    [...document.querySelectorAll("script, link")].map((element) => element.outerHTML).join(),
  );
  expect(scripts).not.toMatch(/assets\/de-/);
  await other.goto("./?lang=de#v=2&preset=ellipse&finest=5&match=later");
  await button(other, "Link kopieren").click();
  await expect(button(other, "Kopiert")).toBeVisible();
  const link = await other.evaluate(() => navigator.clipboard.readText());
  expect(link).not.toContain("lang=");
  await english.close();
});

/** What the address holds, in its order. */
function held(address: string): string {
  return new URL(address).hash;
}
