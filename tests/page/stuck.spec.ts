/** Nothing gets stuck: whatever fails or hangs is said, can be cancelled, and leaves a page that works. */

import { readFileSync } from "node:fs";
import { expect, type Page, test, type Worker } from "@playwright/test";
import { file } from "./files";
import { button, choose, finished, value, watch } from "./handles";

const EASY = "./#v=1&preset=ellipse&finest=5&match=later";

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

/** From now on, in pages that have been prepared for it. */
async function successorsHang(page: Page, endless: boolean): Promise<void> {
  await page.evaluate((value) => Reflect.set(window, "endless", value), endless);
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
    await page.addInitScript(() => {
      window.Worker = new Proxy(Worker, {
        construct(target, parts) {
          const [address, ...others] = parts;
          const endless =
            Reflect.get(window, "endless") && URL.createObjectURL(new Blob(["for (;;);"], { type: "text/javascript" }));
          return Reflect.construct(target, [endless || address, ...others]);
        },
      });
    });
    await page.goto("./#v=1&preset=moon&finest=5&bending=0.5");
    await button(page, "Match").click();
    await finished(page);
    const [before] = page.workers();
    await hang(before);
    // Its successors, too, or the page would help itself before anybody looks.
    await successorsHang(page, true);
    await button(page, "Match").click();
    await expect(page.getByRole("status")).toContainText("Preparing the shapes");
    await expect(page.getByRole("progressbar", { name: "Match" })).toBeVisible();
    await successorsHang(page, false);
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
  await expect.poll(() => page.workers().includes(before)).toBe(false);
});

test.describe("a part that cannot be fetched says so, and comes as soon as it can", () => {
  /** Files of the build that are refused until the function given back is called. */
  async function withhold(page: Page, pattern: string): Promise<() => void> {
    let there = false;
    await page.route(pattern, (route) => (there ? route.continue() : route.abort()));
    return () => {
      there = true;
    };
  }

  test("the import", async ({ page }) => {
    await page.goto(EASY);
    const give = await withhold(page, "**/assets/ImportDialog-*");
    await button(page, "Import target").click();
    await expect(page.getByRole("alert")).toContainText("The import could not be loaded; check the connection");
    give();
    await button(page, "Import target").click();
    const dialog = page.getByRole("dialog", { name: "Import a target" });
    await expect(dialog).toBeVisible();
    // With its style sheet: without it the dialog would be as narrow as its text.
    expect((await dialog.boundingBox())?.width).toBeGreaterThan(700);
    await page.getByText("Paste text here").click();
    await page.getByLabel("SVG, path data, JSON or CSV text").fill("0 0\n2 0\n2 1\n0 1");
    await button(page, "Use as target").click();
    await expect(page.getByRole("dialog")).toHaveCount(0);
  });

  test("the import, on its way for long, says that it comes", async ({ page }) => {
    await page.goto(EASY);
    let arrive = () => {};
    const arrived = new Promise<void>((resolve) => {
      arrive = resolve;
    });
    await page.route("**/assets/ImportDialog-*.js", async (route) => {
      await arrived;
      await route.continue();
    });
    await button(page, "Import target").click();
    await expect(page.getByText("Loading the import …")).toBeVisible();
    arrive();
    await expect(page.getByRole("dialog", { name: "Import a target" })).toBeVisible();
    await expect(page.getByText("Loading the import …")).toHaveCount(0);
  });

  test("the gallery", async ({ page }) => {
    await page.goto(EASY);
    const give = await withhold(page, "**/assets/gallery-*");
    await button(page, "Import target").click();
    await button(page, "Gallery").click();
    await expect(page.getByRole("dialog").getByRole("alert")).toContainText("The gallery could not be loaded; check");
    give();
    await button(page, "Gallery").click();
    await expect(button(page, "Heart")).toBeVisible();
  });

  test("what saves files", async ({ page }) => {
    await page.goto(EASY);
    const give = await withhold(page, "**/assets/export-*");
    const save = async () => {
      await page.getByText("Save", { exact: true }).click();
      await button(page, "Drawing (SVG)").click();
    };
    await save();
    await expect(page.getByRole("alert")).toContainText("What saves files could not be loaded; check the connection");
    give();
    const download = page.waitForEvent("download");
    await save();
    expect((await download).suggestedFilename()).toBe("thinshell-shapes.svg");
  });

  test("the comparison and the views", async ({ page }) => {
    await page.goto(EASY);
    const give = await withhold(page, "**/assets/{Compare,views}-*");
    await page.getByText("Compare side by side").click();
    await expect(page.getByRole("alert")).toContainText("“Compare side by side” could not be loaded; check");
    await page.getByLabel("View", { exact: true }).selectOption("Area ratio");
    await expect(page.getByRole("alert")).toContainText("This view could not be loaded; check");
    give();
    await page.getByText("Compare side by side").click();
    await expect(button(page, "Compare")).toBeVisible();
  });

  test("the other language, on pages without a place for what goes wrong", async ({ page }) => {
    const give = await withhold(page, "**/assets/de-*");
    for (const address of ["./lessons.html", "./experiments.html"]) {
      await page.goto(address);
      await button(page, "Deutsch").click();
      await expect(page.getByRole("alert")).toContainText("This language could not be loaded; check the connection");
    }
    give();
    await page.reload();
    await button(page, "Deutsch").click();
    await expect(page.locator("html")).toHaveAttribute("lang", "de");
  });

  test("what is shown in a frame", async ({ page }) => {
    await withhold(page, "**/assets/embed-*");
    await page.goto("./?embed=result#v=2&preset=ellipse&finest=5");
    await expect(page.getByRole("alert")).toContainText("This view could not be loaded; check the connection");
  });
});

test("a video of no bytes is not saved: the morph is, as a GIF, and the page says so", async ({ page }) => {
  await page.addInitScript(() => {
    // A recorder that never gets a frame ends without an error and without a byte.
    class Empty extends EventTarget {
      static isTypeSupported = () => true;
      ondataavailable: ((event: { data: Blob }) => void) | null = null;
      onstop: (() => void) | null = null;
      start() {}
      stop() {
        this.ondataavailable?.({ data: new Blob([]) });
        this.onstop?.();
      }
    }
    Reflect.set(window, "MediaRecorder", Empty);
  });
  await page.goto(EASY);
  await button(page, "Match").click();
  await finished(page);
  await page.getByText("Save", { exact: true }).click();
  const download = page.waitForEvent("download");
  await button(page, "Morph as video (WebM)").click();
  const saved = await download;
  expect(saved.suggestedFilename()).toBe("thinshell-match-33x33.gif");
  expect(
    readFileSync(await saved.path())
      .subarray(0, 6)
      .toString(),
  ).toBe("GIF89a");
  await expect(page.getByRole("alert")).toContainText("recorded no video, so the morph is saved as a GIF");
});

test("numbers that are none are said in words, and what was saved of them opens again", async ({ page }) => {
  // A curve that falls between the nodes of its grid has no points there: nothing to measure on.
  const side = 3;
  const deformation = Array.from({ length: side * side }, (_, k) => [(k % side) / 2, Math.floor(k / side) / 2]).flat();
  const loop = [
    [0.4, 0.4],
    [0.6, 0.4],
    [0.5, 0.6],
  ];
  const record = {
    format: "thinshell",
    version: 1,
    reference: { loops: [loop] },
    template: { loops: [loop] },
    settings: {},
    match: {
      report: {
        finished: true,
        stop: "Converged.",
        level: 1,
        iteration: 3,
        evaluations: 9,
        energies: { membrane: 0, bending: 0, mismatch: 0, volume: 0, total: 0 },
        leastDeterminant: 0.25,
        mismatch: { mean: null, max: 0 },
        stretch: { mean: null, deviation: null },
      },
      deformation,
      curves: { reference: [], template: [], matched: [] },
    },
  };
  await page.goto(EASY);
  await choosing(page, "degenerate.json", JSON.stringify(record));
  await button(page, "Open everything").click();
  await expect(page.getByRole("status")).toContainText("none: the grid does not see the curve");
  await expect(page.getByRole("main")).not.toContainText("NaN");
  await page.getByText("Save", { exact: true }).click();
  const download = page.waitForEvent("download");
  await button(page, "Everything (JSON)").click();
  const again = readFileSync(await (await download).path(), "utf8");
  expect(JSON.parse(again).match.report.mismatch).toEqual({ mean: null, max: 0 });
  await choosing(page, "again.json", again);
  await expect(button(page, "Open everything")).toBeVisible();
});

test("a damaged match is refused on opening, and nothing is lost", async ({ page }) => {
  await page.goto(EASY);
  await button(page, "Match").click();
  await finished(page);
  const distance = await value(page, "mismatch-max");
  await choosing(
    page,
    "damaged.json",
    '{"format":"thinshell","version":1,"reference":{"loops":[]},"template":{"loops":[]},"match":{"report":{"level":-2000}}}',
  );
  await expect(page.getByRole("dialog").getByRole("alert")).toContainText(
    "The file is damaged: match.report.level is -2000, which no match has; save it again.",
  );
  await expect(button(page, "Open everything")).toHaveCount(0);
  await button(page, "Close").click();
  expect(await value(page, "mismatch-max")).toBe(distance);
  await expect(button(page, "Undo")).toBeDisabled();
});

async function choosing(page: Page, name: string, content: string): Promise<void> {
  await button(page, "Import reference").click();
  await page.getByLabel("Choose a file").setInputFiles({ ...file(name, "application/json", content) });
}
