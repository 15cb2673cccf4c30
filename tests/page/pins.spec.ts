/** Points of the reference tied to points of the template, on the page. */

import { readFileSync } from "node:fs";
import { AxeBuilder } from "@axe-core/playwright";
import { expect, type Page, test } from "@playwright/test";
import { encode } from "../../www/link/text";
import { PRESETS } from "../../www/shapes/presets";
import {
  button,
  choose,
  finished,
  loops,
  picture,
  result,
  type Side,
  settings,
  surface,
  value,
  watch,
} from "./handles";

const STAR = PRESETS.find(({ id }) => id === "star") ?? PRESETS[0];

/** The tip of the star's reference, and another tip of the turned one than the nearest. */
const TIP = [0.5, 0.76] as const;
const OTHER_TIP = [0.239, 0.464] as const;

type Spot = readonly [number, number];

async function open(page: Page, more = "&finest=6"): Promise<void> {
  await page.goto(`./#v=1&preset=star${more}&match=later`);
  await button(page, "Pin").click();
  await expect(button(page, "Pin")).toHaveAttribute("aria-pressed", "true");
}

async function at(page: Page, side: Side, [x, y]: Spot): Promise<Spot> {
  const box = await surface(page, side).boundingBox();
  if (!box) throw new Error(`the ${side} surface is not on the page`);
  return [box.x + x * box.width, box.y + (1 - y) * box.height];
}

async function press(page: Page, side: Side, spot: Spot): Promise<void> {
  await page.mouse.click(...(await at(page, side, spot)));
}

async function tie(page: Page, from: Spot, to: Spot): Promise<void> {
  await press(page, "Reference", from);
  await press(page, "Template", to);
}

/** The pins in the address: x y on the reference, x y on the template, pin by pin. */
function pins(page: Page): number[] {
  const text = new URLSearchParams(new URL(page.url()).hash.slice(1)).get("pins") ?? "";
  return loops(text).flat(2);
}

async function pinsAre(page: Page, ...expected: (readonly [...Spot, ...Spot])[]): Promise<void> {
  const near = expected.flat().map((number) => expect.closeTo(number, 1));
  await expect.poll(() => pins(page)).toEqual(near);
}

function guide(page: Page) {
  return page.locator(".guide");
}

async function match(page: Page): Promise<void> {
  await button(page, "Match").click();
  await finished(page);
}

/** Of the match in a saved file: where φ takes the first pin's reference end, in cells from its template end. */
async function cellsOff(page: Page): Promise<number> {
  const { pins: saved, match: found } = await savedJson(page);
  const cells = 2 ** found.report.level;
  const [x, y] = saved[0].reference.map((coordinate) => coordinate * cells);
  const node = (i: number, j: number) => 2 * (j * (cells + 1) + i);
  const [i, j] = [Math.floor(x), Math.floor(y)];
  const [u, v] = [x - i, y - j];
  const end = [0, 1].map(
    (k) =>
      (1 - v) * ((1 - u) * found.deformation[node(i, j) + k] + u * found.deformation[node(i + 1, j) + k]) +
      v * ((1 - u) * found.deformation[node(i, j + 1) + k] + u * found.deformation[node(i + 1, j + 1) + k]),
  );
  return Math.hypot(end[0] - saved[0].template[0], end[1] - saved[0].template[1]) * cells;
}

type Saved = {
  pins: { reference: [number, number]; template: [number, number] }[];
  match: { report: { level: number; energies: Record<string, number> }; deformation: number[] };
};

async function save(page: Page, label: string): Promise<Buffer> {
  await page.getByText("Save", { exact: true }).click();
  const [download] = await Promise.all([page.waitForEvent("download"), button(page, label).click()]);
  return readFileSync(await download.path());
}

async function savedJson(page: Page): Promise<Saved> {
  return JSON.parse((await save(page, "Everything (JSON)")).toString());
}

test("two presses tie a point to its partner, and the match takes it there", async ({ page }) => {
  const seen = watch(page);
  await open(page);
  await expect(guide(page)).toHaveText("Press a point of the reference, then its partner on the target.");
  await press(page, "Reference", TIP);
  await expect(guide(page)).toHaveText("Now the partner of pin 1: press where it belongs on the target.");
  await press(page, "Template", OTHER_TIP);
  await pinsAre(page, [...TIP, ...OTHER_TIP]);
  await match(page);
  expect(await value(page, "mismatch-max")).toBeLessThan(0.5);
  expect(await value(page, "least-determinant")).toBeGreaterThan(0);
  expect(await cellsOff(page)).toBeLessThan(0.5);
  await expect(page.locator(".pins-off")).toHaveCount(0);
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  expect(seen.errors).toEqual([]);
});

test("the template's point may come first", async ({ page }) => {
  await open(page);
  await press(page, "Template", OTHER_TIP);
  await expect(guide(page)).toContainText("press where it belongs on the reference");
  await press(page, "Reference", TIP);
  await pinsAre(page, [...TIP, ...OTHER_TIP]);
});

test("a point near the curve snaps to it", async ({ page }) => {
  await open(page);
  await tie(page, [0.5, 0.785], [0.6, 0.98]);
  await expect.poll(() => pins(page).length).toBe(4);
  const [, y, u, v] = pins(page);
  expect(y).toBeCloseTo(0.7604, 3);
  expect(u).toBeCloseTo(0.6, 2);
  expect(v).toBeCloseTo(0.98, 2);
});

test("either end is dragged, which is one step to undo", async ({ page }) => {
  await open(page);
  await tie(page, TIP, OTHER_TIP);
  await pinsAre(page, [...TIP, ...OTHER_TIP]);
  await page.mouse.move(...(await at(page, "Template", OTHER_TIP)));
  await page.mouse.down();
  for (const spot of [
    [0.3, 0.5],
    [0.45, 0.55],
    [0.5, 0.5],
  ] as const) {
    await page.mouse.move(...(await at(page, "Template", spot)));
  }
  await page.mouse.up();
  await pinsAre(page, [...TIP, 0.5, 0.5]);
  await button(page, "Undo").click();
  await pinsAre(page, [...TIP, ...OTHER_TIP]);
  await button(page, "Undo").click();
  await pinsAre(page);
  await button(page, "Redo").click();
  await pinsAre(page, [...TIP, ...OTHER_TIP]);
});

test("a chosen pin is deleted by button and by key, and what remains counts from one", async ({ page }) => {
  await open(page);
  await tie(page, TIP, OTHER_TIP);
  await tie(page, [0.5, 0.5], [0.5, 0.5]);
  await press(page, "Reference", TIP);
  await button(page, "Delete pin 1").click();
  await pinsAre(page, [0.5, 0.5, 0.5, 0.5]);
  await press(page, "Reference", [0.5, 0.5]);
  await expect(button(page, "Delete pin 1")).toBeVisible();
  await page.keyboard.press("Delete");
  await pinsAre(page);
  await button(page, "Undo").click();
  await tie(page, TIP, OTHER_TIP);
  await button(page, "Delete all pins").click();
  await pinsAre(page);
});

test("everything is done with the keyboard alone, and told", async ({ page }) => {
  await page.goto("./#v=1&preset=star&finest=6&match=later");
  await button(page, "Pin").focus();
  await page.keyboard.press("Enter");
  const told = page.locator(".sketch-tools [aria-live]");
  await page.keyboard.press("Tab");
  while (!(await surface(page, "Reference").evaluate((canvas) => canvas === document.activeElement))) {
    await page.keyboard.press("Tab");
  }
  await expect(surface(page, "Reference")).toHaveAccessibleDescription(/Enter sets a point here and its partner there/);
  for (let step = 0; step < 13; step += 1) await page.keyboard.press("ArrowUp");
  await expect(told).toHaveText("0.5 across, 0.76 up, on the curve.");
  await page.keyboard.press("Enter");
  await expect(told).toHaveText(/^Pin 1 begun on the reference: 0.5 across, 0.76 up/);
  // On to the partner by itself.
  await expect(surface(page, "Template")).toBeFocused();
  for (let step = 0; step < 13; step += 1) await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("Shift+ArrowDown");
  await page.keyboard.press("Enter");
  await expect(told).toHaveText(/^Pin 1 set: 0.5 across, 0.76 up goes to/);
  await pinsAre(page, [...TIP, 0.24, 0.495]);
  // Taken up, moved, set down.
  await page.keyboard.press("PageDown");
  await expect(told).toHaveText(/^Pin 1 chosen/);
  await page.keyboard.press("Enter");
  await expect(told).toHaveText(/^Pin 1 taken up/);
  for (let step = 0; step < 5; step += 1) await page.keyboard.press("ArrowUp");
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("Enter");
  await expect(told).toHaveText(/^Pin 1 moved/);
  await expect.poll(() => pins(page)[3]).toBeGreaterThan(0.55);
  // Taken up and put back.
  const before = pins(page);
  await page.keyboard.press("Enter");
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("Escape");
  await page.waitForTimeout(600);
  expect(pins(page)).toEqual(before);
  await page.keyboard.press("Delete");
  await expect(told).toHaveText("Pin 1 deleted.");
  await pinsAre(page);
  await page.keyboard.press("Control+z");
  await expect.poll(() => pins(page)).toEqual(before);
});

test("Escape gives up a pin that waits for its partner, and so does another tool", async ({ page }) => {
  await open(page);
  await press(page, "Reference", TIP);
  await page.keyboard.press("Escape");
  await expect(guide(page)).toHaveText("Press a point of the reference, then its partner on the target.");
  await press(page, "Reference", TIP);
  await button(page, "Draw").click();
  await button(page, "Pin").click();
  await press(page, "Template", OTHER_TIP);
  await expect(guide(page)).toContainText("on the reference");
  await pinsAre(page);
});

test.describe("touch", () => {
  test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  test("taps set pins and choose them, and every target is 44 pixels", async ({ page }) => {
    await open(page);
    await page.touchscreen.tap(...(await at(page, "Reference", TIP)));
    await expect(guide(page)).toContainText("partner of pin 1");
    await page.touchscreen.tap(...(await at(page, "Template", OTHER_TIP)));
    await pinsAre(page, [...TIP, ...OTHER_TIP]);
    await page.touchscreen.tap(...(await at(page, "Reference", [0.2, 0.2])));
    await page.touchscreen.tap(...(await at(page, "Template", [0.2, 0.2])));
    await expect(button(page, "Delete pin 2")).toBeVisible();
    // Twenty pixels off the first pin are near enough for a finger.
    const [x, y] = await at(page, "Reference", TIP);
    await page.touchscreen.tap(x + 20, y);
    await expect(button(page, "Delete pin 1")).toBeVisible();
    for (const name of ["Draw", "Pin", "Delete pin 1", "Delete all pins"]) {
      const box = await button(page, name).boundingBox();
      expect(Math.min(box?.width ?? 0, box?.height ?? 0)).toBeGreaterThanOrEqual(44);
    }
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
    expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
    await button(page, "Delete pin 1").click();
    await pinsAre(page, [0.2, 0.2, 0.2, 0.2]);
  });
});

test("a link brings the pins back, and links of before there were pins open", async ({ page, context }) => {
  await open(page);
  await tie(page, TIP, OTHER_TIP);
  await pinsAre(page, [...TIP, ...OTHER_TIP]);
  const address = page.url();
  expect(address).toContain("preset=star");
  const other = await context.newPage();
  await other.goto(address);
  await finished(other);
  expect(await cellsOff(other)).toBeLessThan(0.5);
  expect(pins(other)).toEqual(pins(page));
  await other.goto("about:blank");
  await other.goto("./#v=1&preset=star&finest=6");
  await pinsAre(other);
  await expect(other.getByRole("alert")).toBeEmpty();
});

test("a reload loses no pin", async ({ page, context }) => {
  await open(page);
  await tie(page, TIP, OTHER_TIP);
  await pinsAre(page, [...TIP, ...OTHER_TIP]);
  const bare = await context.newPage();
  await bare.goto("./");
  await button(bare, "Pin").click();
  await expect(button(bare, "Delete all pins")).toBeVisible();
});

for (const [damage, words] of [
  ["AYBUoddj", "the list of pins is cut off"],
  ["*", "the list of pins is damaged"],
  ["AAAAAAAAAAA", "a pin lies outside the box"],
]) {
  test(`a link whose pins are ${damage} says so`, async ({ page }) => {
    await page.goto(`./#v=1&preset=star&pins=${damage}`);
    await expect(page.getByRole("alert")).toContainText(words);
  });
}

test("pins are in the saved file and come back with the match", async ({ page }) => {
  await open(page, "&finest=5");
  await tie(page, TIP, OTHER_TIP);
  await match(page);
  const content = await save(page, "Everything (JSON)");
  const saved: Saved = JSON.parse(content.toString());
  expect(saved.pins).toHaveLength(1);
  expect(saved.match.report.energies.pins).toBeGreaterThan(0);
  await page.goto("about:blank");
  await page.goto("./#v=1&preset=ellipse");
  await button(page, "Import reference").click();
  await page
    .getByLabel("Choose a file")
    .setInputFiles({ name: "match.json", mimeType: "application/json", buffer: content });
  await button(page, "Open everything").click();
  await pinsAre(page, [...TIP, ...OTHER_TIP]);
  expect(JSON.parse((await save(page, "Everything (JSON)")).toString())).toEqual(saved);
  await button(page, "Undo").click();
  await pinsAre(page);
});

test("pins are in the drawing and in the picture of the result", async ({ page }) => {
  await open(page, "&finest=5");
  await match(page);
  const without = await picture(result(page));
  await tie(page, TIP, OTHER_TIP);
  await match(page);
  expect(await picture(result(page))).not.toBe(without);
  const drawing = (await save(page, "Drawing (SVG)")).toString();
  expect(drawing).toMatch(/<g id="pins"[^>]*>.*<circle .*<text [^>]*>1<\/text>/s);
});

test("with Live on, the match follows a pin that is dragged", async ({ page }) => {
  await open(page);
  await button(page, "Match").click();
  await finished(page);
  await page.getByRole("switch", { name: "Live" }).click();
  await tie(page, TIP, OTHER_TIP);
  await finished(page);
  const before = await picture(result(page));
  await page.mouse.move(...(await at(page, "Template", OTHER_TIP)));
  await page.mouse.down();
  await page.mouse.move(...(await at(page, "Template", [0.255, 0.535])), { steps: 4 });
  await expect(page.getByRole("status")).toContainText("Following your hand");
  await expect.poll(() => picture(result(page))).not.toBe(before);
  await page.mouse.up();
  await finished(page);
  expect(await cellsOff(page)).toBeLessThan(1);
});

test("a pin that the match does not reach says by how much, and its strength is among the settings", async ({
  page,
}) => {
  await open(page);
  await settings(page).click();
  await expect(page.getByLabel("Pin strength", { exact: true })).toHaveCount(0);
  await tie(page, TIP, OTHER_TIP);
  const strength = page.getByLabel("Pin strength", { exact: true });
  await expect(strength).toHaveValue("1");
  await strength.fill("0");
  await strength.press("Enter");
  await match(page);
  await expect(page.locator(".pins-off")).toHaveText("The pins are ignored: their strength is 0.");
  await strength.fill("0.00001");
  await strength.press("Enter");
  await match(page);
  await expect(page.locator(".pins-off")).toHaveText(
    /^Pin 1 ends [\d.]+ cells from its partner: move it, or raise the strength of pins in the settings\.$/,
  );
});

test("pins that contradict each other fold nothing, and the page says which are not reached", async ({ page }) => {
  // One point tied to two: no map has both.
  const [x, y] = TIP;
  const from = { x, y };
  const pins = [0.3, 0.7].map((u) => ({ reference: from, template: { x: u, y: 0.3 } }));
  await page.goto(`./#${encode({ ...STAR, pins, settings: { finest: 5 }, preset: "star" })}&match=later`);
  await match(page);
  expect(await value(page, "least-determinant")).toBeGreaterThan(0);
  await expect(page.locator(".pins-off")).toHaveText(/^Pin 1 ends [\d.]+ cells from its partner, pin 2/);
});

test("a match of other pins is marked as such until the pins are as they were", async ({ page }) => {
  await open(page, "&finest=5");
  await match(page);
  await tie(page, TIP, OTHER_TIP);
  await expect(page.getByRole("status")).toContainText("The pins have changed: press Match.");
  await expect(page.getByText("Computed with other pins")).toBeVisible();
  await button(page, "Undo").click();
  await expect(page.getByText("Computed with other pins")).toHaveCount(0);
});

test("pins go along with a shape that is moved, and go with one that is cleared", async ({ page }) => {
  await open(page);
  await tie(page, TIP, OTHER_TIP);
  await pinsAre(page, [...TIP, ...OTHER_TIP]);
  await button(page, "Draw").click();
  await surface(page, "Reference").focus();
  for (let step = 0; step < 5; step += 1) await page.keyboard.press("ArrowDown");
  await pinsAre(page, [0.5, 0.71, ...OTHER_TIP]);
  await button(page, "Clear reference").click();
  await pinsAre(page);
});

test("two settings compared are compared with the pins", async ({ page }) => {
  await open(page, "&finest=5");
  await tie(page, TIP, OTHER_TIP);
  await page.locator("summary", { hasText: "Compare side by side" }).click();
  await choose(page, "Setting that A changes", "Pin strength");
  await page.getByLabel("Pin strength of A").fill("0");
  await choose(page, "Setting that B changes", "nothing changed");
  await button(page, "Compare").click();
  const row = page.getByRole("row", { name: /of the pins/ });
  await expect(row.getByRole("cell")).toHaveText(["0", /./, /./], { timeout: 45_000 });
});
