import { readFileSync } from "node:fs";
import { AxeBuilder } from "@axe-core/playwright";
import { expect, type Page, test } from "@playwright/test";
import type { Shape, Status } from "../../www/protocol";
import { initSync, Registration } from "../../www/wasm/thinshell.js";
import { choose, type File, file, svg, svgFile, take } from "./files";
import { button, finished, result, value, watch } from "./handles";

const PLAIN = "./#v=1&preset=star&finest=6&align=none&match=later";

async function match(page: Page): Promise<void> {
  await button(page, "Match").click();
  await finished(page);
}

/** Chooses the entry of the menu and gives the file that it downloads. */
async function save(page: Page, label: string): Promise<File> {
  await page.getByText("Save", { exact: true }).click();
  const [download] = await Promise.all([page.waitForEvent("download"), button(page, label).click()]);
  await expect(page.getByText("Save", { exact: true })).toBeVisible();
  return file(download.suggestedFilename(), "", readFileSync(await download.path()));
}

type Json = {
  reference: { loops: [number, number][][] };
  template: { loops: [number, number][][] };
  settings: Record<string, number | string | boolean>;
  match: { report: Status; deformation: number[]; curves: Record<string, [number, number][][]> };
};

test("a picture for print", async ({ page }) => {
  await page.goto(PLAIN);
  await match(page);
  const { name, buffer } = await save(page, "Picture (PNG)");
  expect(name).toBe("thinshell-match-65x65.png");
  expect(buffer.subarray(1, 4).toString()).toBe("PNG");
  expect([buffer.readUInt32BE(16), buffer.readUInt32BE(20)]).toEqual([2400, 2400]);
  const shown = await inked(page, buffer);
  expect(shown.colours).toBeGreaterThan(300);
  expect(shown.part).toBeGreaterThan(0.1);
  expect(shown.part).toBeLessThan(0.9);
});

test("the picture and the film are of the view that is chosen", async ({ page }) => {
  await page.goto(PLAIN);
  await match(page);
  const grid = await inked(page, (await save(page, "Picture (PNG)")).buffer);
  const gridFilm = (await save(page, "Morph as GIF")).buffer;
  await page.getByLabel("View", { exact: true }).selectOption("Image carried");
  await expect(page.locator(".legend")).toBeVisible();
  const image = await inked(page, (await save(page, "Picture (PNG)")).buffer);
  // The carried picture covers the box, the grid lets the paper through.
  expect(image.part).toBeGreaterThan(0.75);
  expect(image.part).toBeGreaterThan(grid.part + 0.1);
  const film = (await save(page, "Morph as GIF")).buffer;
  expect(film.equals(gridFilm)).toBe(false);
  expect((await inked(page, film)).part).toBeGreaterThan(0.75);
});

/** Colours of a picture, and the part that has another one than its first pixel. */
function inked(page: Page, buffer: Buffer): Promise<{ colours: number; part: number }> {
  return page.evaluate(async (content) => {
    const picture = new Image();
    picture.src = `data:image;base64,${content}`;
    await picture.decode();
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [picture.width, picture.height];
    const context = canvas.getContext("2d");
    if (!context) throw new Error("no 2D canvas");
    context.drawImage(picture, 0, 0);
    const words = new Uint32Array(context.getImageData(0, 0, canvas.width, canvas.height).data.buffer);
    const paper = words[0];
    const other = words.reduce((sum, word) => sum + Number(word !== paper), 0);
    return { colours: new Set(words).size, part: other / words.length };
  }, buffer.toString("base64"));
}

test("a drawing, whose shapes come back with the same distance field", async ({ page }) => {
  const before = await prepared(page);
  const { name, buffer } = await save(page, "Drawing (SVG)");
  expect(name).toBe("thinshell-shapes.svg");
  await button(page, "Clear reference").click();
  await choose(page, "Reference", { name, mimeType: "image/svg+xml", buffer });
  await expect(page.getByLabel("Shape", { exact: true }).locator("option")).toHaveText(["Reference", "Target"]);
  await expect(page.getByLabel("Place", { exact: true })).toHaveValue("asIs");
  await take(page, "Reference");
  const after = loopsOf(await saveJson(page));
  // In cells: distances of the nodes of the grid of 129 × 129 to either outline.
  const [fieldBefore, fieldAfter] = [distances(before), distances(after)];
  let worst = 0;
  fieldBefore.forEach((distance, node) => {
    worst = Math.max(worst, 128 * Math.abs(distance - fieldAfter[node]));
  });
  expect(worst).toBeLessThan(0.1);
});

/** A shape with corners, curves and a hole as the reference. */
async function prepared(page: Page): Promise<[number, number][][]> {
  await page.goto(PLAIN);
  const drawing = '<path fill-rule="evenodd" d="M5 5h70v40c0 30-40 40-70 20zM20 15h30v20l-15 9-15-9z"/>';
  await choose(page, "Reference", svgFile(drawing));
  await take(page, "Reference");
  return loopsOf(await saveJson(page));
}

async function saveJson(page: Page): Promise<Json> {
  return JSON.parse((await save(page, "Everything (JSON)")).buffer.toString());
}

function loopsOf({ reference }: Json): [number, number][][] {
  expect(reference.loops).toHaveLength(2);
  return reference.loops;
}

/** Signed distances of the nodes of the finest grid to the loops: even–odd inside, exact. */
function distances(loops: [number, number][][]): Float64Array {
  const out = new Float64Array(129 * 129);
  for (let node = 0; node < out.length; node += 1) {
    const [x, y] = [(node % 129) / 128, Math.floor(node / 129) / 128];
    let least = Infinity;
    let inside = false;
    for (const loop of loops) {
      let [a, b] = loop[loop.length - 1];
      for (const [c, d] of loop) {
        const t = Math.min(1, Math.max(0, ((x - a) * (c - a) + (y - b) * (d - b)) / ((c - a) ** 2 + (d - b) ** 2)));
        least = Math.min(least, Math.hypot(x - a - t * (c - a), y - b - t * (d - b)));
        if (b > y !== d > y && x < a + ((y - b) / (d - b)) * (c - a)) inside = !inside;
        [a, b] = [c, d];
      }
    }
    out[node] = inside ? -least : least;
  }
  return out;
}

test("the drawing of a match is well-formed and has the matched curve", async ({ page }) => {
  await page.goto(PLAIN);
  await match(page);
  const { name, buffer } = await save(page, "Drawing (SVG)");
  expect(name).toBe("thinshell-match-65x65.svg");
  const counts = await page.evaluate((text) => {
    const drawing = new DOMParser().parseFromString(text, "image/svg+xml");
    const count = (selector: string) => drawing.querySelectorAll(selector).length;
    return {
      broken: count("parsererror"),
      sides: count("[data-side]"),
      colours: new Set([...drawing.querySelectorAll("#arc-length path")].map((path) => path.getAttribute("stroke")))
        .size,
      partners: count("#partners path"),
      grid: drawing.querySelector("#grid")?.getAttribute("d")?.match(/M/g)?.length,
    };
  }, buffer.toString());
  expect(counts).toMatchObject({ broken: 0, sides: 3, partners: 36, grid: 66 });
  expect(counts.colours).toBeGreaterThan(100);
});

test("everything as JSON loads to the same state", async ({ page, context }) => {
  await page.goto(PLAIN);
  await match(page);
  const shown = await numbers(page);
  const saved = await save(page, "Everything (JSON)");
  expect(saved.name).toBe("thinshell-match-65x65.json");

  const other = await context.newPage();
  const seen = watch(other);
  await other.goto("./#v=1&preset=ellipse&finest=5&match=later");
  await choose(other, "Reference", saved);
  await expect(other.getByText("A saved match on the 65 × 65 grid")).toBeVisible();
  await button(other, "Open everything").click();
  await finished(other);
  expect(await numbers(other)).toEqual(shown);
  await expect(result(other)).toHaveAccessibleName(/matched, at most/);
  expect(await save(other, "Everything (JSON)")).toEqual(saved);
  // What was loaded can be matched again, from the same shapes and settings, to the same energy.
  await match(other);
  expect(await numbers(other)).toEqual(shown);
  // And what was there before is one step back.
  await button(other, "Undo").click();
  await expect(button(other, "Undo")).toBeDisabled();
  expect(seen.errors).toEqual([]);
});

test("a saved match stays as it is where the match follows the hand", async ({ page }) => {
  await page.goto(PLAIN);
  await match(page);
  const shown = await numbers(page);
  const saved = await save(page, "Everything (JSON)");
  await page.goto("about:blank");
  await page.goto("./#v=1&preset=ellipse&finest=5&match=later");
  const live = page.getByRole("switch", { name: "Live" });
  await live.click();
  await finished(page);
  await choose(page, "Reference", saved);
  await button(page, "Open everything").click();
  await finished(page);
  expect(await numbers(page)).toEqual(shown);
  // A run that had been started would have ended within this time.
  await page.waitForTimeout(1500);
  expect(await numbers(page)).toEqual(shown);
  await expect(live).toBeChecked();
});

async function numbers(page: Page): Promise<number[]> {
  const names = ["level", "total", "mismatch-max", "mismatch-mean", "least-determinant"];
  return Promise.all(names.map((name) => value(page, name)));
}

test("the solver finds the saved energies at the saved deformation", async ({ page }) => {
  await page.goto(PLAIN);
  await match(page);
  const { reference, template, settings, match: saved } = await saveJson(page);
  initSync({ module: readFileSync("www/wasm/thinshell_bg.wasm") });
  const { level } = saved.report;
  // The saved level alone. Coarser ones have halved δ and ε on the way to it.
  const halvings = 2 ** (level - 4);
  const registration = await Registration.create(curves(reference), curves(template), {
    ...settings,
    coarsest: level,
    finest: level,
    thickness: Number(settings.thickness) / halvings,
    penalty: Number(settings.penalty) * halvings,
  });
  const { energies, leastDeterminant } = registration.evaluate(Float64Array.from(saved.deformation));
  for (const [name, energy] of Object.entries(saved.report.energies)) {
    // Without pins theirs is zero on both sides.
    const found = energies[name as keyof typeof energies];
    expect(Math.abs(found - energy)).toBeLessThanOrEqual(1e-9 * Math.abs(energy));
  }
  expect(leastDeterminant).toBeCloseTo(saved.report.leastDeterminant, 9);
  registration.free();
});

function curves({ loops }: Json["reference"]): Shape {
  return { kind: "curves", loops: loops.map((loop) => Float64Array.from(loop.flat())) };
}

test("single shapes of a saved match can be taken", async ({ page }) => {
  await page.goto(PLAIN);
  await match(page);
  const saved = await save(page, "Everything (JSON)");
  const { template } = JSON.parse(saved.buffer.toString()) as Json;
  await choose(page, "Reference", saved);
  await button(page, "Only the target").click();
  const [loop] = await take(page, "Reference");
  const right = Math.max(...template.loops[0].map(([x]) => x));
  expect(Math.max(...loop.map(([x]) => x))).toBeCloseTo(right, 3);
});

test("matched points as a table", async ({ page }) => {
  await page.goto(PLAIN);
  await match(page);
  const { name, buffer } = await save(page, "Matched points (CSV)");
  expect(name).toBe("thinshell-match-65x65.csv");
  const [header, ...rows] = buffer.toString().trimEnd().split("\n");
  expect(header.split(",")).toEqual(["loop", "x", "y", "phi_x", "phi_y", "arc_length", "stretch", "distance"]);
  const points = rows.map((row) => row.split(",").map(Number));
  const { match: saved } = await saveJson(page);
  const pairs = saved.curves.reference.flatMap((loop, l) =>
    loop.map((point, i) => [l, ...point, ...saved.curves.matched[l][i]]),
  );
  expect(points.map((point) => point.slice(0, 5))).toEqual(pairs);
  expect(points.every((point) => point.length === 8 && point.every(Number.isFinite))).toBe(true);
  // Distances in sides of the box: within half a cell of the grid.
  expect(Math.max(...points.map((point) => point[7]))).toBeLessThan(0.5 / 64);
  const mean = points.reduce((sum, point) => sum + point[6], 0) / points.length;
  expect(mean).toBeCloseTo(saved.report.stretch.mean, 1);
});

test("the morph as a video that plays", async ({ page }) => {
  await page.goto(PLAIN);
  await match(page);
  const { name, buffer } = await save(page, "Morph as video (WebM)");
  expect(name).toBe("thinshell-match-65x65.webm");
  // The page's own policy lets it play nothing.
  await page.goto("about:blank");
  const film = await page.evaluate(async (content) => {
    const video = document.createElement("video");
    video.muted = true;
    video.src = `data:video/webm;base64,${content}`;
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [90, 90];
    const context = canvas.getContext("2d", { willReadFrequently: true });
    const frame = () => {
      context?.drawImage(video, 0, 0, 90, 90);
      return canvas.toDataURL();
    };
    await video.play();
    const pictures = new Set<string>();
    await new Promise((resolve) => {
      video.onended = resolve;
      video.ontimeupdate = () => pictures.add(frame());
    });
    return { width: video.videoWidth, seconds: video.currentTime, pictures: pictures.size };
  }, buffer.toString("base64"));
  expect(film.width).toBe(720);
  expect(film.seconds).toBeGreaterThan(3);
  expect(film.pictures).toBeGreaterThan(3);
});

test("the morph as a GIF that moves and repeats", async ({ page }) => {
  await page.goto(PLAIN);
  await match(page);
  const { name, buffer } = await save(page, "Morph as GIF");
  expect(name).toBe("thinshell-match-65x65.gif");
  expect(buffer.subarray(0, 6).toString()).toBe("GIF89a");
  expect(buffer.includes("NETSCAPE2.0")).toBe(true);
  const film = await page.evaluate(async (content) => {
    const bytes = Uint8Array.from(atob(content), (character) => character.charCodeAt(0));
    const decoder = new ImageDecoder({ data: bytes, type: "image/gif" });
    await decoder.tracks.ready;
    const frames = decoder.tracks.selectedTrack?.frameCount ?? 0;
    const pictures = new Set<string>();
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [90, 90];
    const context = canvas.getContext("2d", { willReadFrequently: true });
    let width = 0;
    for (const frameIndex of [0, 8, 16, 24]) {
      const { image } = await decoder.decode({ frameIndex });
      width = image.displayWidth;
      context?.drawImage(image, 0, 0, 90, 90);
      pictures.add(canvas.toDataURL());
      image.close();
    }
    return { frames, width, pictures: pictures.size };
  }, buffer.toString("base64"));
  expect(film).toEqual({ frames: 48, width: 480, pictures: 4 });
});

test("without a match only what needs none can be saved", async ({ page }) => {
  await page.goto(PLAIN);
  await page.getByText("Save", { exact: true }).click();
  for (const label of ["Matched points (CSV)", "Morph as video (WebM)", "Morph as GIF"]) {
    await expect(button(page, label)).toBeDisabled();
  }
  await page.keyboard.press("Escape");
  const { buffer, name } = await save(page, "Everything (JSON)");
  expect(name).toBe("thinshell-shapes.json");
  expect(JSON.parse(buffer.toString()).match).toBeNull();
});

test("a browser that records no video makes a GIF, and says so", async ({ page }) => {
  await page.addInitScript(() => Reflect.deleteProperty(window, "MediaRecorder"));
  await page.goto(PLAIN);
  await match(page);
  const { name, buffer } = await save(page, "Morph as video (WebM)");
  expect(name).toBe("thinshell-match-65x65.gif");
  expect(buffer.length).toBeGreaterThan(1000);
  await expect(page.getByRole("alert")).toContainText(
    "This browser recorded no video, so the morph is saved as a GIF.",
  );
});

for (const width of [1280, 390]) {
  test(`the menu opens, closes and fits at ${width} pixels, by the keyboard too`, async ({ page }) => {
    await page.setViewportSize({ width, height: 844 });
    await page.goto(PLAIN);
    const menu = page.getByText("Save", { exact: true });
    await menu.focus();
    await page.keyboard.press("Enter");
    await expect(button(page, "Picture (PNG)")).toBeInViewport({ ratio: 1 });
    expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
    await page.keyboard.press("Escape");
    await expect(button(page, "Picture (PNG)")).toBeHidden();
    await expect(menu).toBeFocused();
    await menu.click();
    await page.getByRole("heading", { level: 1 }).click();
    await expect(button(page, "Picture (PNG)")).toBeHidden();
  });
}

test("a drawing by another program is not taken for one of this page", async ({ page }) => {
  await page.goto(PLAIN);
  await choose(page, "Reference", file("a.svg", "image/svg+xml", svg('<path data-side="reference" d="M0 0h9v9z"/>')));
  await expect(page.getByLabel("Place", { exact: true })).toHaveCount(0);
  await expect(button(page, "Use as reference")).toBeEnabled();
});
