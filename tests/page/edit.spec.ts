import { expect, type Page, test } from "@playwright/test";
import { button, clear, drawn, ellipse, loops, paint, type Side, settings, stroke, surface } from "./handles";

test.beforeEach(async ({ page }) => {
  await page.goto("./");
});

test("undo and redo walk through strokes, by button and by key", async ({ page }) => {
  await expect(button(page, "Undo")).toBeDisabled();
  await clear(page);
  await stroke(page, "Reference", ellipse(0.2, 0.2));
  await expect.poll(() => drawn(page, "Reference")).toBeTruthy();
  const first = drawn(page, "Reference");
  await stroke(page, "Reference", ellipse(0.06, 0.06));
  await expect.poll(() => drawn(page, "Reference")).toContain(".");
  const second = drawn(page, "Reference");
  await button(page, "Undo").click();
  await expect.poll(() => drawn(page, "Reference")).toBe(first);
  await page.keyboard.press("Control+z");
  await expect.poll(() => drawn(page, "Reference")).toBe("");
  await page.keyboard.press("Control+Shift+Z");
  await expect.poll(() => drawn(page, "Reference")).toBe(first);
  await button(page, "Redo").click();
  await expect.poll(() => drawn(page, "Reference")).toBe(second);
  await expect(button(page, "Redo")).toBeDisabled();
});

test("the first stroke replaces the example, further ones add parts and holes", async ({ page }) => {
  await stroke(page, "Template", ellipse(0.1, 0.1, 0.5, 0.72));
  await expect.poll(() => drawn(page, "Template")).toMatch(/^[^.]+$/);
  await stroke(page, "Template", ellipse(0.1, 0.1, 0.5, 0.3));
  await expect.poll(() => drawn(page, "Template")).toMatch(/^[^.]+\.[^.]+$/);
  const parts = await paint(surface(page, "Template"));
  await stroke(page, "Template", ellipse(0.05, 0.05, 0.5, 0.3));
  await expect.poll(() => drawn(page, "Template")).toMatch(/^[^.]+\.[^.]+\.[^.]+$/);
  expect((await paint(surface(page, "Template"))).painted).toBeLessThan(parts.painted);
});

test("a tap draws nothing and takes nothing away", async ({ page }) => {
  await clear(page);
  await stroke(page, "Reference", ellipse(0.2, 0.2));
  await expect.poll(() => drawn(page, "Reference")).toBeTruthy();
  const before = drawn(page, "Reference");
  for (const position of [
    { x: 20, y: 20 },
    { x: 150, y: 120 },
  ]) {
    await surface(page, "Reference").click({ position });
  }
  await page.waitForTimeout(600);
  expect(drawn(page, "Reference")).toBe(before);
});

test("pulling the curve bends it there and only there", async ({ page }) => {
  await clear(page);
  await stroke(page, "Reference", ellipse(0.2, 0.2));
  await stroke(page, "Reference", [
    [0.7, 0.5],
    [0.74, 0.5],
    [0.78, 0.5],
  ]);
  await expect.poll(() => most(xs(page, "Reference"))).toBeCloseTo(0.78, 1);
  expect(least(xs(page, "Reference"))).toBeCloseTo(0.3, 2);
});

test("the grip moves the whole shape", async ({ page }) => {
  await clear(page);
  await stroke(page, "Reference", ellipse(0.2, 0.2));
  await stroke(page, "Reference", [
    [0.5, 0.5],
    [0.55, 0.5],
    [0.6, 0.5],
  ]);
  await expect.poll(() => most(xs(page, "Reference"))).toBeCloseTo(0.8, 2);
  expect(least(xs(page, "Reference"))).toBeCloseTo(0.4, 2);
});

test("a shape can be moved, turned, scaled and cleared with the keyboard", async ({ page }) => {
  const canvas = surface(page, "Template");
  await canvas.focus();
  await expect(canvas).toBeFocused();
  await expect(canvas).toHaveAccessibleDescription(/arrow keys move it/);
  let before = drawn(page, "Template");
  for (const key of ["ArrowUp", "Shift+ArrowLeft", "+", "-", "[", "]"]) {
    await page.keyboard.press(key);
    await expect.poll(() => drawn(page, "Template")).not.toBe(before);
    before = drawn(page, "Template");
  }
  await page.keyboard.press("Delete");
  await expect.poll(() => drawn(page, "Template")).toBe("");
  await expect(page.getByText("Draw a closed curve here")).toBeVisible();
});

test("Fit centres and scales", async ({ page }) => {
  await clear(page);
  await stroke(page, "Reference", ellipse(0.06, 0.06, 0.2, 0.8));
  await button(page, "Fit").click();
  await expect.poll(() => least(xs(page, "Reference"))).toBeCloseTo(0.2, 2);
  expect(most(points(page, "Reference").map(([, y]) => y))).toBeCloseTo(0.8, 2);
});

test("a link and the browser's storage bring everything back", async ({ page, context }) => {
  await clear(page);
  await stroke(page, "Reference", ellipse(0.2, 0.1));
  await stroke(page, "Template", ellipse(0.1, 0.2));
  await expect.poll(() => drawn(page, "Template")).toBeTruthy();
  const address = page.url();
  const link = await context.newPage();
  await link.goto(address);
  await button(link, "Fit").click();
  await button(link, "Undo").click();
  await expect.poll(() => link.url()).toBe(address);
  const bare = await context.newPage();
  await bare.goto("./");
  await button(bare, "Fit").click();
  await button(bare, "Undo").click();
  await expect.poll(() => bare.url()).toBe(address);
});

test("closing the page at once loses nothing", async ({ page, context }) => {
  await clear(page);
  await stroke(page, "Reference", ellipse(0.2, 0.1));
  await page.close({ runBeforeUnload: true });
  const again = await context.newPage();
  await again.goto("./");
  await expect(button(again, "Clear reference")).toBeEnabled();
  await expect(button(again, "Clear template")).toBeDisabled();
});

test("a broken link says what is wrong and keeps the shapes", async ({ page }) => {
  await clear(page);
  await stroke(page, "Reference", ellipse(0.2, 0.1));
  await expect.poll(() => drawn(page, "Reference")).toBeTruthy();
  await page.goto("about:blank");
  await page.goto("./#v=1&preset=dragon");
  await expect(page.getByRole("alert")).toContainText("there is no example called “dragon”");
  await expect(button(page, "Clear reference")).toBeEnabled();
  await expect(button(page, "Clear template")).toBeDisabled();
});

test("a setting out of its range is refused where it stands, and Reset brings the defaults back", async ({ page }) => {
  await settings(page).click();
  const bending = page.getByLabel("Bending", { exact: true });
  await bending.fill("-1");
  await bending.press("Enter");
  await expect(bending).toHaveAttribute("aria-invalid", "true");
  await expect(page.getByText("must be a number from 0 to 100")).toBeVisible();
  await bending.fill("0");
  await bending.press("Enter");
  await expect(bending).toHaveAttribute("aria-invalid", "false");
  await expect.poll(() => page.url()).toContain("bending=0");
  await button(page, "Reset to defaults").click();
  await expect(bending).toHaveValue("0.03");
  await expect.poll(() => page.url()).not.toContain("bending");
});

test.describe("touch", () => {
  test.use({ hasTouch: true });

  test("one finger draws, two fingers move and scale", async ({ page }) => {
    await clear(page);
    const canvas = surface(page, "Reference");
    const box = await canvas.boundingBox();
    if (!box) throw new Error("the reference surface is not on the page");
    const session = await page.context().newCDPSession(page);
    const touch = (type: "touchStart" | "touchMove" | "touchEnd", points: [number, number][]) =>
      session.send("Input.dispatchTouchEvent", {
        type,
        touchPoints: points.map(([x, y], id) => ({ x: box.x + x * box.width, y: box.y + (1 - y) * box.height, id })),
      });
    const [first, ...rest] = ellipse(0.2, 0.2);
    await touch("touchStart", [first]);
    for (const point of rest) await touch("touchMove", [point]);
    await touch("touchEnd", []);
    await expect.poll(() => most(xs(page, "Reference"))).toBeCloseTo(0.7, 2);

    await touch("touchStart", [[0.1, 0.1]]);
    await touch("touchStart", [
      [0.1, 0.1],
      [0.3, 0.1],
    ]);
    await touch("touchMove", [
      [0.15, 0.2],
      [0.25, 0.2],
    ]);
    await touch("touchEnd", []);
    // Half the distance between the fingers, half the size; their middle takes the shape along.
    await expect.poll(() => most(xs(page, "Reference"))).toBeCloseTo(0.45, 2);
  });
});

/** The points of a shape's first loop; the address follows an edit after a moment, so they are to be asked again. */
function points(page: Page, side: Side): [number, number][] {
  return loops(drawn(page, side))[0] ?? [];
}

const most = (numbers: readonly number[]) => Math.max(...numbers);
const least = (numbers: readonly number[]) => Math.min(...numbers);

function xs(page: Page, side: Side): number[] {
  return points(page, side).map(([x]) => x);
}
