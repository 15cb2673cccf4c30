/** The page as its users meet it: by role and name. */

import { expect, type Locator, type Page } from "@playwright/test";
import { unpack } from "../../www/link/pack";

export type Side = "Reference" | "Template";

/** What the page calls the shapes, outside of the names of their surfaces. */
export const SIDES: Readonly<Record<Side, string>> = { Reference: "reference", Template: "target" };

export function surface(page: Page, side: Side): Locator {
  return page.getByRole("application", { name: `${side} shape` });
}

export function result(page: Page): Locator {
  return page.getByRole("img", { name: "Deformed grid and matched curve" });
}

export function button(page: Page, name: string): Locator {
  return page.getByRole("button", { name, exact: true });
}

/** A machine-readable value of the status; waits until it is there. */
export async function value(page: Page, name: string): Promise<number> {
  const text = await page.getByRole("status").locator(`data[data-name="${name}"]`).getAttribute("value");
  // Without a value there is no number: an empty text would be 0.
  return text ? Number(text) : Number.NaN;
}

/** Waits for the end of the run and for its last picture. */
export async function finished(page: Page): Promise<void> {
  await expect(page.getByRole("status").locator('data[data-name="mismatch-max"]')).toBeVisible({ timeout: 45_000 });
  await page.evaluate(
    () => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(() => resolve(null)))),
  );
}

/** Draws through the points (parts of the surface, y up) with the mouse. */
export async function stroke(page: Page, side: Side, points: readonly (readonly [number, number])[]): Promise<void> {
  const box = await surface(page, side).boundingBox();
  if (!box) throw new Error(`the ${side} surface is not on the page`);
  const at = ([x, y]: readonly [number, number]) => [box.x + x * box.width, box.y + (1 - y) * box.height] as const;
  await page.mouse.move(...at(points[0]));
  await page.mouse.down();
  for (const point of points.slice(1)) await page.mouse.move(...at(point));
  await page.mouse.up();
}

/** An ellipse, drawn almost to its start. */
export function ellipse(a: number, b: number, x = 0.5, y = 0.5): [number, number][] {
  return Array.from({ length: 48 }, (_, i) => {
    const t = (2 * Math.PI * i) / 49;
    return [x + a * Math.cos(t), y + b * Math.sin(t)];
  });
}

/** Empties both surfaces, so that drawings start from nothing. */
export async function clear(page: Page): Promise<void> {
  await button(page, "Clear reference").click();
  await button(page, "Clear template").click();
}

/** Pixels of a canvas that are painted, as a part of all, and the number of different colours. */
export async function paint(canvas: Locator): Promise<{ painted: number; colours: number }> {
  return canvas.evaluate((element) => {
    const target = element as HTMLCanvasElement;
    // A copy: reading a canvas itself more than once makes the browser warn, and draw it in another way from then on.
    const copy = new OffscreenCanvas(target.width, target.height).getContext("2d", { willReadFrequently: true });
    copy?.drawImage(target, 0, 0);
    const image = copy?.getImageData(0, 0, target.width, target.height);
    if (!image) throw new Error("no 2D canvas");
    const words = new Uint32Array(image.data.buffer);
    const seen = new Set(words);
    return { painted: words.reduce((sum, word) => sum + (word === 0 ? 0 : 1), 0) / words.length, colours: seen.size };
  });
}

/** What a canvas shows, to be compared. A copy is read, see `paint`. */
export async function picture(canvas: Locator): Promise<string> {
  return canvas.evaluate((element) => {
    const copy = document.createElement("canvas");
    const source = element as HTMLCanvasElement;
    [copy.width, copy.height] = [source.width, source.height];
    copy.getContext("2d", { willReadFrequently: true })?.drawImage(source, 0, 0);
    return copy.toDataURL();
  });
}

/** What the address holds of a shape: changes with every edit. */
export function drawn(page: Page, side: Side): string | null {
  return new URLSearchParams(new URL(page.url()).hash.slice(1)).get(side.toLowerCase());
}

/** The points of loops as `drawn` reads them. */
export function loops(text: string | null): [number, number][][] {
  if (!text) return [];
  return text.split(".").map((loop) => {
    const numbers = unpack(loop);
    return Array.from({ length: numbers.length / 2 }, (_, i) => [numbers[2 * i], numbers[2 * i + 1]]);
  });
}

/** The line that opens the settings. */
export function settings(page: Page): Locator {
  return page.locator("summary", { hasText: "Settings" });
}

/** Chooses a setting in the panel, by its label. */
export async function choose(page: Page, label: string, option: string): Promise<void> {
  const select = page.getByLabel(label, { exact: true });
  if (!(await select.isVisible())) await settings(page).click();
  await select.selectOption(option);
}

/** Playwright's own word where a test keeps the service worker away. */
export const BLOCKED = "Service Worker registration blocked by Playwright";

/** When the page has fetched the last of what it fetches by itself; to be called before it is opened. */
export async function loaded(page: Page): Promise<void> {
  const last = await page.waitForResponse(/\/assets\/Update-[^/]*\.js$/);
  await last.finished();
}

/** Collects what should not be there: console errors, uncaught errors, and requests from now on. */
export function watch(page: Page): { errors: string[]; requests: string[] } {
  const seen = { errors: [] as string[], requests: [] as string[] };
  page.on("console", (message) => {
    const text = message.text();
    if ((message.type() === "error" || message.type() === "warning") && text !== BLOCKED) seen.errors.push(text);
  });
  page.on("pageerror", (error) => seen.errors.push(error.message));
  page.on("request", (request) => seen.requests.push(request.url()));
  return seen;
}

/** Without a graphics card Chromium itself warns of how slowly canvases are copied to the screen. */
export function ours(errors: readonly string[]): readonly string[] {
  return errors.filter((text) => !text.includes("GL Driver Message (OpenGL, Performance"));
}
