/** Surfaces: the way there and back, a match in space, its views, files and links. */

import { readFileSync } from "node:fs";
import { AxeBuilder } from "@axe-core/playwright";
import { expect, type Locator, type Page, test } from "@playwright/test";
import { drop, file } from "./files";
import { button, drawn, finished, ours, paint, picture, result, surface, value, watch } from "./handles";

const SMALL = "./#space=1&finest=4";

/** In heights of a view of some 300 pixels: the place is rounded to pixels of the screen. */
const PIXEL = 0.005;
/** As seen from the side: the way back is the inverse of what is known at nodes a sixteenth of the box apart. */
const CELL = 0.02;

/** An octahedron with its triangles cut in four: a closed mesh, as ASCII. */
function octahedron(): string {
  const ends = [
    [1, 0, 0],
    [0, 0, -1],
    [-1, 0, 0],
    [0, 0, 1],
  ];
  const points: number[][] = [];
  const faces: string[] = [];
  const add = (point: number[]) => points.push(point) - 1;
  const middle = (p: number[], q: number[]) => p.map((x, k) => 0.6 * (x + q[k]));
  for (const [k, p] of ends.entries())
    for (const pole of [1, -1]) {
      const q = ends[(k + 1) % 4];
      const triangle = pole > 0 ? [p, q, [0, pole, 0]] : [q, p, [0, pole, 0]];
      const [a, b, c] = triangle.map(add);
      const [ab, bc, ca] = triangle.map((corner, i) => add(middle(corner, triangle[(i + 1) % 3])));
      faces.push(`3 ${a} ${ab} ${ca}`, `3 ${ab} ${b} ${bc}`, `3 ${ca} ${bc} ${c}`, `3 ${ab} ${bc} ${ca}`);
    }
  return [
    "ply",
    "format ascii 1.0",
    `element vertex ${points.length}`,
    ...["x", "y", "z"].map((axis) => `property float ${axis}`),
    `element face ${faces.length}`,
    "property list uchar int vertex_indices",
    "end_header",
    ...points.map((point) => point.map((x) => 40 * x + 7).join(" ")),
    ...faces,
    "",
  ].join("\n");
}

/** Downloads by a button of the menu, as text. */
async function saved(page: Page, format: string): Promise<string> {
  await page.locator(".save summary").click();
  const coming = page.waitForEvent("download");
  await button(page, format).click();
  return readFileSync(await (await coming).path(), "latin1");
}

test("the way to surfaces and back leaves the sketch as it was", async ({ page }) => {
  const { errors } = watch(page);
  await page.goto("./#v=1&preset=ellipse&finest=5");
  await finished(page);
  await button(page, "Clear template").click();
  await expect.poll(() => drawn(page, "Template")).toBe("");
  const before = drawn(page, "Reference");
  await button(page, "Surfaces").click();
  await expect(page.getByRole("heading", { level: 1 })).toHaveText("Elastic matching of two surfaces");
  await expect(page).toHaveURL(/#space=1&reference=sphere&template=ellipsoid/);
  await button(page, "Back to curves").click();
  await expect(page.getByRole("heading", { level: 1 })).toHaveText("Elastic matching of two curves");
  expect(drawn(page, "Reference")).toBe(before);
  expect(drawn(page, "Template")).toBe("");
  await button(page, "Undo").click();
  await expect.poll(() => new URL(page.url()).hash).toContain("preset=ellipse");
  expect(ours(errors)).toEqual([]);
});

test("a pair of the gallery is matched at 33³: verdict, numbers, and equal colours on both surfaces", async ({
  page,
}) => {
  test.slow();
  const { errors, requests } = watch(page);
  await page.goto("./#space=1");
  await finished(page);
  requests.length = 0;
  expect(await value(page, "level")).toBe(5);
  expect(await value(page, "mismatch-max")).toBeLessThan(0.3);
  expect(await value(page, "least-determinant")).toBeGreaterThan(0.3);
  await expect(page.getByRole("status")).toContainText("Fits: nowhere more than");
  await expect(result(page)).toHaveAccessibleName(/matched, at most 0\.\d+ cells off, nothing folded$/);
  for (const canvas of [surface(page, "Reference"), surface(page, "Template"), result(page)]) {
    const { painted, colours } = await paint(canvas);
    expect(painted).toBeGreaterThan(0.1);
    expect(colours).toBeGreaterThan(500);
  }
  expect(ours(errors)).toEqual([]);
  expect(requests).toEqual([]);
});

test("the camera turns by keys in all views at once, says where it is, and stands in the link", async ({ page }) => {
  await page.goto(SMALL);
  await finished(page);
  const all = [surface(page, "Reference"), surface(page, "Template"), result(page)];
  const before = await Promise.all(all.map(picture));
  await result(page).focus();
  for (let k = 0; k < 4; k += 1) await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowUp");
  const said = page.locator("#space-pose");
  await expect(said).toHaveText("Seen 74° from the right, 33° from above, zoom 1.0");
  for (const [k, canvas] of all.entries()) expect(await picture(canvas)).not.toBe(before[k]);
  await page.keyboard.press("+");
  await page.keyboard.press("Shift+ArrowLeft");
  await expect(said).toHaveText("Seen 74° from the right, 33° from above, zoom 1.2, moved");
  await expect(page).toHaveURL(/camera=1\.298%2C0\.575%2C1\.2/);
  await page.reload();
  await finished(page);
  await expect(said).toHaveText("Seen 74° from the right, 33° from above, zoom 1.2, moved");
  await button(page, "Reset view").click();
  await expect.poll(async () => (await picture(result(page))) === before[2]).toBe(true);
});

test("a drag turns, and two views show numbers with their legend", async ({ page }) => {
  await page.goto(SMALL);
  await finished(page);
  const before = await picture(result(page));
  const box = await result(page).boundingBox();
  if (!box) throw new Error("the result is not on the page");
  await page.mouse.move(box.x + 200, box.y + 200);
  await page.mouse.down();
  await page.mouse.move(box.x + 260, box.y + 220, { steps: 3 });
  await page.mouse.up();
  await expect.poll(() => picture(result(page))).not.toBe(before);
  let last = await picture(result(page));
  for (const [view, legend] of [
    ["Area ratio", "Area ratio"],
    ["Distance", "Distance to the target"],
  ]) {
    await page.getByLabel("View", { exact: true }).selectOption(view);
    await expect(page.getByRole("figure", { name: "What the colours mean" })).toContainText(legend);
    await expect.poll(() => picture(result(page))).not.toBe(last);
    last = await picture(result(page));
  }
  await page.getByLabel("View", { exact: true }).selectOption("Slice");
  await expect.poll(() => picture(result(page))).not.toBe(last);
  last = await picture(result(page));
  await page.getByLabel("Plane at").fill("62");
  await expect.poll(() => picture(result(page))).not.toBe(last);
  last = await picture(result(page));
  await page.getByRole("slider", { name: "Morph" }).fill("0");
  await expect.poll(() => picture(result(page))).not.toBe(last);
});

test("what is under the pointer has its partner in the other views, which leads back to it", async ({ page }) => {
  await page.goto(SMALL);
  await finished(page);
  const views = [surface(page, "Reference"), surface(page, "Template"), result(page)];
  const marks = page.locator(".partner");
  await expect(marks).toHaveCount(0);
  /** The rings from the middle of each view, in its heights, when a place of one of them is pointed at. */
  const pointed = async (view: Locator, [right, down]: readonly number[]) => {
    const box = await view.boundingBox();
    if (!box) throw new Error("the surface is not on the page");
    const { x, y, width, height } = box;
    await page.mouse.move(x + width / 2 + right * height, y + height / 2 + down * height);
    await expect(marks).toHaveCount(3);
    return Promise.all(
      views.map((one) =>
        one.evaluate((canvas) => {
          const box = canvas.getBoundingClientRect();
          const ring = canvas.parentElement?.querySelector(".partner")?.getBoundingClientRect() ?? new DOMRect();
          const middle = ({ left, right, top, bottom }: DOMRect) => [(left + right) / 2, (top + bottom) / 2];
          const [at, of] = [middle(ring), middle(box)];
          return [(at[0] - of[0]) / box.height, (at[1] - of[1]) / box.height];
        }),
      ),
    );
  };
  const apart = ([a, b]: readonly number[], [c, d]: readonly number[]) => Math.hypot(a - c, b - d);
  const given = [0.15, 0.02];
  const [there, partner, moved] = await pointed(views[0], given);
  expect(apart(there, given)).toBeLessThan(PIXEL);
  // The ellipsoid is longer along x: what is beside the middle of the sphere goes farther out, in the result as on the target.
  expect(partner[0]).toBeGreaterThan(1.15 * given[0]);
  expect(apart(moved, partner)).toBeLessThan(PIXEL);
  for (const [k, place] of [
    [1, partner],
    [2, moved],
  ] as const) {
    const [back, again] = await pointed(views[k], place);
    expect(apart(again, place)).toBeLessThan(PIXEL);
    expect(apart(back, given)).toBeLessThan(CELL);
  }
  const box = await views[2].boundingBox();
  if (!box) throw new Error("the result is not on the page");
  await page.mouse.move(box.x + 4, box.y + box.height - 30);
  await expect(marks).toHaveCount(0);
});

test("pins are set by presses and by keys, moved, deleted and undone, hold in the match, and stand in link and JSON", async ({
  page,
}) => {
  test.slow();
  const { errors } = watch(page);
  await page.goto(`${SMALL}&align=none`);
  await finished(page);
  await button(page, "Set pins").click();
  const pins = page.locator("button.pin");
  const guide = page.locator("#space-pins");
  const press = async (name: "Reference" | "Template", right: number, down: number) => {
    const canvas = surface(page, name);
    const box = await canvas.boundingBox();
    if (!box) throw new Error(`no ${name}`);
    await canvas.click({ position: { x: right * box.width, y: down * box.height } });
  };
  await press("Reference", 0.6, 0.5);
  await expect(guide).toContainText("Pin 1 begins on the reference");
  await press("Template", 0.64, 0.47);
  await expect(pins).toHaveCount(2);
  await expect(page).toHaveURL(/pins=0\.\d+%2C/);
  await expect(page.getByRole("status")).toContainText("press Match");
  await button(page, "Match").click();
  await finished(page);
  expect(await value(page, "pins-off")).toBeLessThan(0.5);
  expect(JSON.parse(await saved(page, "Everything (JSON)")).pins).toHaveLength(1);

  await surface(page, "Template").focus();
  await page.keyboard.press("Enter");
  await expect(guide).toContainText("Pin 2 begins on the target");
  await surface(page, "Reference").focus();
  await page.keyboard.press("Enter");
  await expect(pins).toHaveCount(4);
  const second = page.getByRole("button", { name: "Pin 2 on the reference" });
  const places = () => new URLSearchParams(new URL(page.url()).hash.slice(1)).get("pins")?.split(",").map(Number) ?? [];
  await expect.poll(places).toHaveLength(12);
  const before = places();
  await second.focus();
  await page.keyboard.press("ArrowLeft");
  await expect.poll(places).not.toEqual(before);
  // Only this end has moved, and it is still on the sphere.
  const moved = places();
  expect(moved.filter((x, k) => x === before[k]).length).toBeGreaterThanOrEqual(9);
  expect(Math.hypot(...[6, 7, 8].map((k) => moved[k] - 0.5))).toBeCloseTo(0.24, 2);
  await page.keyboard.press("Delete");
  await expect(pins).toHaveCount(2);
  await expect.poll(places).toHaveLength(6);

  const first = page.getByRole("button", { name: "Pin 1 on the target" });
  const box = await first.boundingBox();
  if (!box) throw new Error("no pin");
  const held = places();
  await page.mouse.move(box.x + 12, box.y + 12);
  await page.mouse.down();
  await page.mouse.move(box.x + 42, box.y + 22, { steps: 4 });
  await page.mouse.up();
  await expect.poll(places).not.toEqual(held);
  await button(page, "Undo").click();
  await expect.poll(places).toEqual(held);
  await page.reload();
  await finished(page);
  await expect(pins).toHaveCount(2);
  await button(page, "Delete all pins").click();
  await expect(pins).toHaveCount(0);
  await expect.poll(places).toEqual([]);
  expect(ours(errors)).toEqual([]);
});

test("the match after each grid can be looked back to, and plays", async ({ page }) => {
  test.slow();
  await page.goto("./#space=1&finest=4&coarsest=3&reference=torus&template=torus-bent");
  await finished(page);
  // A single level has nothing to look back to.
  await expect(page.getByLabel("Match after the grid")).toHaveCount(0);
  await page.locator("summary", { hasText: "Settings" }).click();
  await page.getByLabel("Finest grid").selectOption({ label: "33³" });
  await button(page, "Match").click();
  await finished(page);
  const last = await picture(result(page));
  await page.getByLabel("Match after the grid").selectOption("17³");
  await expect.poll(() => picture(result(page))).not.toBe(last);
  await page.getByLabel("Match after the grid").selectOption("33³");
  await expect.poll(() => picture(result(page))).toBe(last);
  await page.getByLabel("How the morph plays").selectOption("again and again");
  await button(page, "Play the morph").click();
  await expect(button(page, "Stop the morph")).toBeVisible();
  await expect.poll(() => picture(result(page))).not.toBe(last);
});

test("the morph of surfaces is saved as a film", async ({ page }) => {
  test.slow();
  const { errors } = watch(page);
  await page.goto(SMALL);
  await finished(page);
  const gif = await saved(page, "Morph as GIF");
  expect(gif).toMatch(/^GIF89a/);
  // Frames that differ, not one that stands.
  expect(gif.length).toBeGreaterThan(20_000);
  const video = await saved(page, "Morph as video");
  expect(video.slice(0, 4)).toBe("\x1aE\xdf\xa3");
  expect(ours(errors)).toEqual([]);
});

test("examples have pictures of their surfaces, painted when they come into sight", async ({ page }) => {
  test.slow();
  await page.setViewportSize({ width: 390, height: 844 });
  await page.goto(SMALL);
  await finished(page);
  const pictures = page.locator(".presets .thumb img");
  await expect(page.locator(".presets .thumb")).toHaveCount(22);
  await expect(pictures).toHaveCount(0);
  await page.locator(".presets").evaluate((list) => list.scrollIntoView({ block: "end" }));
  await page.setViewportSize({ width: 390, height: 1800 });
  await expect(pictures).toHaveCount(22, { timeout: 60_000 });
});

test("a dropped PLY is matched, saved, and there again after a reload", async ({ page }) => {
  test.slow();
  const { errors } = watch(page);
  await page.goto(SMALL);
  await finished(page);
  await drop(page, "#template-surface", file("eight.ply", "", octahedron()));
  await expect(page.getByLabel("Surface of the target").locator("option:checked")).toHaveText("eight.ply");
  await expect(page.getByRole("status")).toContainText("press Match");
  await button(page, "Match").click();
  await finished(page);
  expect(await value(page, "mismatch-max")).toBeLessThan(0.5);
  const { colours } = await paint(surface(page, "Template"));
  expect(colours).toBeGreaterThan(500);

  const ply = await saved(page, "Matched surface (PLY)");
  expect(ply).toMatch(/^ply\nformat ascii 1\.0\n/);
  const count = Number(ply.match(/element vertex (\d+)/)?.[1]);
  const rows = ply
    .slice(ply.indexOf("end_header\n") + 11)
    .split("\n")
    .slice(0, count)
    .map((row) => row.split(" ").map(Number));
  const column = (k: number) => rows.map((row) => row[k]);
  expect(Math.min(...[0, 1, 2].flatMap(column))).toBeGreaterThan(0.15);
  expect(Math.min(...column(6))).toBeGreaterThan(0);
  expect(Math.max(...column(7))).toBeLessThan(0.6);
  // The dropped mesh has six corners and twelve middles of edges.
  expect(new Set(column(8)).size).toBeLessThanOrEqual(18);
  const everything = JSON.parse(await saved(page, "Everything (JSON)"));
  expect(everything.template.name).toBe("eight.ply");
  expect(everything.match.deformation).toHaveLength(3 * 17 ** 3);
  expect(await saved(page, "Picture (PNG)")).toMatch(/^.PNG/);

  await button(page, "Copy link").click();
  await expect(page.getByRole("alert")).toContainText("kept in this browser only");
  await page.reload();
  await finished(page);
  await expect(page.getByLabel("Surface of the target").locator("option:checked")).toHaveText("eight.ply");
  expect(ours(errors)).toEqual([]);
});

test("what cannot be read or matched is said, and changes nothing", async ({ page }) => {
  await page.goto(SMALL);
  await finished(page);
  const alert = page.getByRole("alert");
  await page.getByLabel("Open a file as reference").setInputFiles({
    name: "notes.txt",
    mimeType: "text/plain",
    buffer: Buffer.from("no mesh"),
  });
  await expect(alert).toContainText("“notes.txt” was not taken: it is none of PLY, OBJ, STL, NRRD or JSON");
  await expect(page.getByLabel("Surface of the reference").locator("option:checked")).toHaveText("Sphere");
  const open = octahedron().split("\n").slice(0, -2).join("\n").replace("face 32", "face 31");
  await drop(page, "#reference-surface", file("open.ply", "", open));
  await expect(page.getByLabel("Surface of the reference").locator("option:checked")).toHaveText("open.ply");
  await button(page, "Match").click();
  await expect(alert).toContainText("The reference is open");
  await page.keyboard.press("Control+z");
  await expect(page.getByLabel("Surface of the reference").locator("option:checked")).toHaveText("Sphere");
  await button(page, "Swap").click();
  await page.goto("./#space=1&reference=teapot");
  await expect(alert).toContainText("there is no surface “teapot” in the gallery");
  await expect(page.getByLabel("Surface of the reference").locator("option:checked")).toHaveText("Ellipsoid");
});

test("a match in space pauses, goes on and is cancelled", async ({ page }) => {
  await page.goto("./#space=1&finest=6");
  await expect(page.getByRole("status").locator('data[data-name="level"]')).toBeVisible({ timeout: 45_000 });
  await expect(page.getByRole("progressbar")).toBeVisible();
  await button(page, "Pause").click();
  await expect(page.getByRole("status")).toContainText("Paused.");
  await button(page, "Resume").click();
  await expect(page.getByRole("status")).toContainText("Matching on the");
  await button(page, "Cancel").click();
  await expect(page.getByRole("status")).toContainText("Cancelled.");
  await expect(page.getByRole("progressbar")).toHaveCount(0);
});

test("with Live a match of surfaces begins with every change", async ({ page }) => {
  await page.goto(SMALL);
  await finished(page);
  const status = page.getByRole("status");
  await page.locator(".settings summary").click();
  const weight = page.locator("#setting-bending");
  const off = () => value(page, "mismatch-max");
  const before = await off();
  await weight.fill("1");
  await weight.press("Tab");
  // Nothing begins of itself.
  await expect(status).toContainText("settings have changed");
  const live = page.getByRole("switch", { name: "Live" });
  await live.click();
  await expect(live).toBeChecked();
  await expect(status).toContainText("Fits", { timeout: 45_000 });
  const stiff = await off();
  expect(stiff).not.toBe(before);
  await button(page, "Undo").click();
  await expect.poll(off, { timeout: 45_000 }).toBe(before);
  await expect(status).toContainText("Fits");
});

test("without WebGL a sentence says so, and the match has its numbers", async ({ page }) => {
  await page.addInitScript(() => {
    const get = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, kind: string, ...rest: unknown[]) {
      return kind.startsWith("webgl") ? null : get.call(this, kind as "2d", ...rest);
    } as typeof get;
  });
  await page.goto(SMALL);
  await finished(page);
  await expect(page.getByRole("alert")).toContainText("This browser shows no WebGL");
});

for (const [scheme, media] of Object.entries({
  light: { colorScheme: "light" },
  dark: { colorScheme: "dark" },
  "forced colours": { forcedColors: "active" },
} as const)) {
  test(`surfaces have no accessibility violation: ${scheme}`, async ({ page }) => {
    await page.emulateMedia(media);
    await page.goto(`${SMALL}&view=area&align=none&pins=0.74,0.5,0.5,0.82,0.5,0.5`);
    await finished(page);
    await button(page, "Set pins").click();
    await page.locator("summary", { hasText: "Settings" }).click();
    expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
    await page.getByLabel("View", { exact: true }).selectOption("Slice");
    await page.locator(".save summary").click();
    expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  });
}

test("nothing scrolls sideways from 320 pixels up", async ({ page }) => {
  await page.goto(`${SMALL}&view=slice`);
  await finished(page);
  for (const width of [320, 390, 768, 1280]) {
    await page.setViewportSize({ width, height: 800 });
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
  }
});
