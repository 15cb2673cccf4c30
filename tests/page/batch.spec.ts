import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { AxeBuilder } from "@axe-core/playwright";
import { expect, type Page, test } from "@playwright/test";
import { readland } from "../../scripts/lib/readland.mjs";
import { readCsv } from "../../www/shapes/import/csv";
import { choose, type File, file, svgFile } from "./files";
import { button, drawn, loops, SIDES, watch } from "./handles";

test.beforeEach(async ({ page }) => {
  await page.goto("./#v=1&preset=ellipse&finest=5");
});

/** Three specimens with a closed curve of 60 points and three landmarks on it; the last is missing one of them. */
function specimens(): File {
  const one = (id: string, a: number, b: number, scale: string) => {
    const points = Array.from({ length: 60 }, (_, k) => {
      const t = (2 * Math.PI * k) / 60;
      return `${300 + a * Math.cos(t) + 30 * Math.cos(2 * t)} ${300 + b * Math.sin(t)}`;
    });
    const marks = [points[0], points[20], id === "wide" ? "-1 -1" : points[40]];
    const curve = `CURVES=1\nPOINTS=60\n${points.join("\n")}`;
    return `LM=3\n${marks.join("\n")}\n${curve}\nIMAGE=${id}.jpg\nID=${id}\nSCALE=${scale}\n`;
  };
  return file(
    "leaves.tps",
    "text/plain",
    one("round", 100, 100, "0.5") + one("long", 90, 130, "0.5") + one("wide", 140, 90, "0.5"),
  );
}

const SQUARE = svgFile('<rect x="10" y="10" width="50" height="50"/>', "square.svg");
const OVAL = svgFile('<ellipse cx="50" cy="50" rx="40" ry="25"/>', "oval.svg");
const BROKEN = file("broken.json", "application/json", '[{"name": "half", "points": [[0, 0], [1');

async function openBatch(page: Page, files: readonly File[]): Promise<void> {
  await button(page, "Import reference").click();
  await button(page, "Many files").click();
  await page.getByLabel("Choose files").setInputFiles(files.map((each) => ({ ...each })));
}

/** Four numbers a pin. */
function pins(page: Page): number[] {
  return loops(new URLSearchParams(new URL(page.url()).hash.slice(1)).get("pins") ?? "").flat(2);
}

function status(page: Page) {
  return page.getByRole("dialog").getByRole("status");
}

/** A cell of the table, by its row's name. */
function cells(page: Page, name: string) {
  return page.getByRole("row", { name: new RegExp(`^${name}`) }).getByRole("cell");
}

async function saved(page: Page, label: string): Promise<string> {
  const [download] = await Promise.all([page.waitForEvent("download"), button(page, label).click()]);
  return readFileSync(await download.path(), "utf8");
}

test("many files are matched with the page's reference, and one that is broken is a line of the table", async ({
  page,
}) => {
  const seen = watch(page);
  await openBatch(page, [SQUARE, BROKEN, OVAL]);
  await expect(page.getByText("3 files are ready.")).toBeVisible();
  await button(page, "Match all").click();
  await expect(status(page)).toHaveText("2 of 3 shapes are matched, 2 of them fit.", { timeout: 45_000 });
  await expect(cells(page, "square").nth(0)).toHaveText(/^0\.\d{4}$/);
  await expect(cells(page, "broken").last()).toHaveText(/The JSON is broken/);
  await expect(cells(page, "oval").last()).toHaveText(/^Fits/);

  const specimens = readland(await saved(page, "Points (TPS)"));
  expect(specimens.map(({ id, points }) => [id, points.length])).toEqual([
    ["reference", 100],
    ["square", 100],
    ["oval", 100],
  ]);
  const table = (await saved(page, "Table (CSV)")).trimEnd().split("\n");
  expect(table.map((line) => line.split(",").slice(0, 3).join(","))).toEqual([
    "shape,file,matched",
    "square,square.svg,yes",
    "broken.json,broken.json,no",
    "oval,oval.svg,yes",
  ]);
  const points = readCsv(await saved(page, "Points (CSV)"));
  expect(points.kind === "shapes" && points.choices.map(({ name }) => name)).toEqual(["reference", "square", "oval"]);
  // Two matches on a grid of 32² cells.
  expect((await saved(page, "Strains (CSV)")).trimEnd().split("\n")).toHaveLength(1 + 2 * 32 * 32);
  expect(seen.errors).toEqual([]);
});

test("a match of the table is shown on the page, and one undo takes it back", async ({ page }) => {
  await openBatch(page, [OVAL]);
  await button(page, "Match all").click();
  await expect(status(page)).toHaveText("1 of 1 shapes are matched, 1 of them fit.", { timeout: 45_000 });
  await button(page, "oval").click();
  await expect(page.getByRole("dialog")).toBeHidden();
  await expect(page.getByRole("status").locator('data[data-name="mismatch-max"]')).toBeVisible();
  await expect.poll(() => drawn(page, "Template")).not.toBeNull();
  await button(page, "Undo").click();
  await expect.poll(() => page.url()).toContain("preset=ellipse");
});

test("of a TPS file each specimen is matched with the first, led by its landmarks", async ({ page }) => {
  await openBatch(page, [specimens()]);
  await page.getByRole("dialog").getByLabel("Reference").selectOption("the first shape of the files");
  await page.getByLabel("Points on each outline").fill("40");
  await button(page, "Match all").click();
  await expect(status(page)).toHaveText("2 of 2 shapes are matched, 2 of them fit.", { timeout: 45_000 });
  const found = readland(await saved(page, "Points (TPS)"));
  expect(found.map(({ id, image, points }) => [id, image, points.length])).toEqual([
    ["round", "round.jpg", 40],
    ["long", "long.jpg", 40],
    ["wide", "wide.jpg", 40],
  ]);
  // In the file's units times its scale: some 130 by 100 pixels, half a millimetre each.
  const [x, y] = found[0].points[0];
  expect(x).toBeGreaterThan(80);
  expect(x).toBeLessThan(230);
  expect(y).toBeLessThan(230);
  await button(page, "long").click();
  await expect.poll(() => pins(page)).toHaveLength(12);
});

test("stopping keeps what has been matched, and another start begins anew", async ({ page }) => {
  const many = Array.from({ length: 40 }, (_, k) =>
    svgFile(`<ellipse cx="50" cy="50" rx="${20 + k / 2}" ry="25"/>`, `oval ${k}.svg`),
  );
  await openBatch(page, many);
  await button(page, "Match all").click();
  await expect(page.getByRole("dialog").getByRole("progressbar")).toBeVisible();
  await expect(page.getByRole("row")).not.toHaveCount(0);
  await expect(cells(page, "oval 1 ").or(cells(page, "oval 1")).first()).toBeVisible({ timeout: 45_000 });
  await button(page, "Stop").click();
  await expect(status(page)).toHaveText(/^Stopped; the .* so far can be saved\.$/);
  const rows = (await saved(page, "Table (CSV)")).trimEnd().split("\n").length - 1;
  expect(rows).toBeGreaterThan(0);
  expect(rows).toBeLessThan(40);
  await page.getByLabel("Choose files").setInputFiles([{ ...SQUARE }]);
  await button(page, "Match all").click();
  await expect(status(page)).toHaveText("1 of 1 shapes are matched, 1 of them fit.", { timeout: 45_000 });
});

test("several files dropped anywhere open the batch", async ({ page }) => {
  const given = [SQUARE, OVAL].map(({ name, mimeType, buffer }) => ({ name, mimeType, text: buffer.toString() }));
  const transfer = await page.evaluateHandle((files) => {
    const made = new DataTransfer();
    for (const { name, mimeType, text } of files) made.items.add(new File([text], name, { type: mimeType }));
    return made;
  }, given);
  await page.locator("body").dispatchEvent("dragover", { dataTransfer: transfer });
  await page.locator("body").dispatchEvent("drop", { dataTransfer: transfer });
  await expect(page.getByText("2 files are ready.")).toBeVisible();
});

test("a folder that is chosen is taken with what of it can be read", async ({ page }, testInfo) => {
  const folder = testInfo.outputPath("shapes");
  mkdirSync(folder, { recursive: true });
  for (const { name, buffer } of [SQUARE, OVAL]) writeFileSync(`${folder}/${name}`, buffer);
  writeFileSync(`${folder}/notes.docx`, "no shape");
  await button(page, "Import target").click();
  await button(page, "Many files").click();
  await page.getByLabel("Choose a folder").setInputFiles(folder);
  await expect(page.getByText("2 files are ready.")).toBeVisible();
});

test("landmarks of specimens taken one by one become pins", async ({ page }) => {
  for (const [side, specimen] of [
    ["Reference", "round"],
    ["Template", "wide"],
  ] as const) {
    await choose(page, side, specimens());
    await page.getByRole("dialog").getByLabel("Shape").selectOption({ label: specimen });
    await button(page, `Use as ${SIDES[side]}`).click();
    await expect(page.getByRole("dialog")).toBeHidden();
  }
  // The third is missing on one of them.
  await expect.poll(() => pins(page)).toHaveLength(8);
});

for (const colorScheme of ["light", "dark"] as const) {
  for (const [width, height] of [
    [1280, 800],
    [390, 844],
  ]) {
    test.describe(`${colorScheme}, ${width} pixels`, () => {
      test.use({ colorScheme, viewport: { width, height } });

      test("the batch has no accessibility violation and fits", async ({ page }) => {
        await openBatch(page, [SQUARE, BROKEN]);
        await button(page, "Match all").click();
        await expect(status(page)).toHaveText("1 of 2 shapes are matched, 1 of them fit.", { timeout: 45_000 });
        expect((await new AxeBuilder({ page }).include("dialog").analyze()).violations).toEqual([]);
        const [inner, outer] = await page.evaluate(() => {
          const dialog = document.querySelector("dialog");
          const over = (dialog?.scrollWidth ?? 1) - (dialog?.clientWidth ?? 0);
          return [over, document.documentElement.scrollWidth - innerWidth];
        });
        expect(inner).toBeLessThanOrEqual(0);
        expect(outer).toBeLessThanOrEqual(0);
      });
    });
  }
}
