/** The page within another one: its frame, what is said to it, and the dialog that makes the snippet. */

import AxeBuilder from "@axe-core/playwright";
import { expect, type Frame, type Page, test } from "@playwright/test";
import { button, finished, value, watch } from "./handles";
import { type Server, serving } from "./server";

const EASY = "v=2&preset=ellipse&finest=5";

/** What could be scrolled in any direction, by how much. */
function overflowing(page: Page): Promise<string[]> {
  return page.evaluate(() =>
    [...document.querySelectorAll<HTMLElement>("*")]
      .filter((element) => {
        const { overflowX, overflowY } = getComputedStyle(element);
        const scrolls = (overflow: string) => overflow === "auto" || overflow === "scroll";
        const isRoot = element === document.documentElement;
        return (
          ((isRoot || scrolls(overflowY)) && element.scrollHeight > element.clientHeight) ||
          ((isRoot || scrolls(overflowX)) && element.scrollWidth > element.clientWidth)
        );
      })
      .map((element) => `${element.tagName}.${element.className}`),
  );
}

const KINDS = {
  result: "?embed=result",
  compare: "?embed=compare&b=bending:1",
  full: "?embed=full",
} as const;

for (const [kind, search] of Object.entries(KINDS)) {
  for (const [width, height] of [
    [700, 500],
    [360, 480],
  ]) {
    test(`embed=${kind} fits ${width} × ${height} without scroll bars, in both schemes`, async ({ page }) => {
      test.slow();
      const seen = watch(page);
      await page.setViewportSize({ width, height });
      for (const colorScheme of ["light", "dark"] as const) {
        await page.emulateMedia({ colorScheme });
        await page.goto(`./${search}#${EASY}`);
        if (colorScheme === "dark") await page.reload();
        if (kind === "compare") await expect(page.locator(".pair canvas")).toHaveCount(2);
        else await finishedIn(page.mainFrame());
        expect(await overflowing(page)).toEqual([]);
        await expect(page.locator("canvas").first()).toBeVisible();
        for (const canvas of await page.locator("canvas").all()) await expect(canvas).toBeInViewport({ ratio: 1 });
        expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
      }
      expect(seen.errors).toEqual([]);
    });
  }
}

async function finishedIn(frame: Frame): Promise<void> {
  await expect(frame.getByRole("status").locator(".headline")).toContainText("Fits", { timeout: 45_000 });
}

test("numbers keep to their columns, in German as well, whose words are longer", async ({ page }) => {
  for (const [width, height] of [
    [668, 540],
    [700, 500],
    [1280, 900],
  ]) {
    await page.setViewportSize({ width, height });
    for (const lang of ["en", "de"]) {
      await page.goto("about:blank");
      await page.goto(`./?lang=${lang}${width < 1000 ? "&embed=result" : ""}#v=2&preset=square&finest=6`);
      await finished(page);
      expect(await page.locator(".status :is(dt, dd)").count()).toBeGreaterThan(10);
      const wide = await page
        .locator(".status :is(dt, dd)")
        .evaluateAll((all) => all.filter((one) => one.scrollWidth > one.clientWidth).map((one) => one.textContent));
      expect(wide, `${width} ${lang}`).toEqual([]);
    }
  }
});

test("a frame has the controls that its address names, and no others", async ({ page }) => {
  await page.goto(`./?embed=result&controls=terms&sliders=bending#${EASY}`);
  await expect(page.getByRole("switch", { name: "Bending" })).toBeVisible();
  await expect(page.getByRole("slider", { name: /Bending/ })).toBeVisible();
  await expect(page.getByLabel("View", { exact: true })).toHaveCount(0);
  await expect(page.getByRole("button", { name: "Play the morph" })).toHaveCount(0);
  await expect(page.getByRole("link")).toHaveCount(0);
});

test("with match=later nothing is matched before a press", async ({ page }) => {
  await page.goto(`./?embed=full&match=later#${EASY}`);
  await expect(page.locator(".headline")).toHaveText("Ready: press Match.");
  await button(page, "Match").click();
  await finished(page);
});

test("what cannot be asked for is said, over what is usually shown", async ({ page }) => {
  await page.goto(`./?embed=everything#${EASY}`);
  await expect(page.getByRole("alert")).toContainText("embed=everything, which must be one of result, compare, full");
  await finishedIn(page.mainFrame());
});

test("a frame keeps nothing, and shows nothing of what the page has kept", async ({ page }) => {
  await page.goto("./#v=2&preset=letters&finest=5&bending=0");
  await finished(page);
  const kept = () => page.evaluate(() => JSON.stringify(localStorage));
  const before = await kept();
  await page.goto("about:blank");
  await page.goto("./?embed=full&match=later");
  await expect(button(page, "Match")).toBeVisible();
  await button(page, "Clear reference").click();
  await page.reload();
  expect(page.url()).not.toContain("#");
  expect(await kept()).toBe(before);
  const { href } = new URL((await page.getByRole("link", { name: "Open in the page" }).getAttribute("href")) ?? "");
  expect(href).toMatch(/#v=2&preset=ellipse$/);
});

test("surfaces are embedded as well", async ({ page }) => {
  for (const [width, height] of [
    [700, 500],
    [360, 480],
  ]) {
    await page.setViewportSize({ width, height });
    await page.goto("./?embed=full#space=1&reference=sphere&template=ellipsoid&finest=3");
    await page.reload();
    await expect(page.locator("canvas")).toHaveCount(3);
    expect(await overflowing(page)).toEqual([]);
    for (const canvas of await page.locator("canvas").all()) await expect(canvas).toBeInViewport({ ratio: 1 });
  }
});

test.describe("in a page of another origin", () => {
  let other: Server;
  test.beforeAll(async () => {
    other = await serving("public/demos");
  });
  test.afterAll(() => other.close());

  /** The demo, with the frame in it. */
  async function demo(page: Page, baseURL: string | undefined): Promise<Frame> {
    await page.goto(`${other.address}frame.html?page=${baseURL}`);
    const frame = await (await page.locator("iframe").elementHandle())?.contentFrame();
    if (!frame) throw new Error("the demo has a frame");
    return frame;
  }

  test("the demo sets states, hears of matches, and is refused what is wrong", async ({ page, baseURL }) => {
    const seen = watch(page);
    const frame = await demo(page, baseURL);
    const heard = page.locator("#heard");
    await expect(heard).toContainText("finished: Fits", { timeout: 45_000 });
    expect(new URL(frame.url()).origin).not.toBe(new URL(page.url()).origin);

    await button(page, "Ask for what is not there").click();
    await expect(heard).toHaveText("refused: there is no example called “unknown”");
    await expect(frame.getByRole("alert")).toBeEmpty();

    await button(page, "Where does the middle go?").click();
    await expect(heard).toHaveText(/^mapped: 0\.(49|50)\d,0\.(49|50)\d$/);

    await button(page, "Show letters, by their stretch").click();
    await expect(heard).toContainText("finished: Fits", { timeout: 45_000 });
    await expect(frame.getByLabel("View", { exact: true })).toHaveValue("stretch");
    expect(seen.errors).toEqual([]);
  });

  test("of all windows only the parent is obeyed, and the refused learn why and change nothing", async ({
    page,
    baseURL,
  }) => {
    const frame = await demo(page, baseURL);
    await finishedIn(frame);
    const headline = await frame.locator(".headline").textContent();
    // A frame beside it, which is not its parent.
    const beside = await page.evaluateHandle(() => document.body.appendChild(document.createElement("iframe")));
    const answers = await (await beside.contentFrame())?.evaluate(
      async (origin) => {
        const ask = (message: object) =>
          new Promise<unknown>((resolve) => {
            addEventListener("message", ({ data }) => resolve(data), { once: true });
            parent.frames[0].postMessage({ thinshell: 1, ...message }, origin);
          });
        return [await ask({ id: 1, kind: "set", state: "v=2&preset=star" }), await ask({ id: 2, kind: "get" })];
      },
      new URL(baseURL ?? "").origin,
    );
    const message = "only the page that holds this frame is answered";
    expect(answers).toEqual([
      { thinshell: 1, id: 1, kind: "refused", message },
      { thinshell: 1, id: 2, kind: "refused", message },
    ]);
    expect(await frame.locator(".headline").textContent()).toBe(headline);
  });

  test("a frame whose address names another origin does not obey this one", async ({ page, baseURL }) => {
    await page.goto(`${other.address}frame.html?page=${baseURL}`);
    const answer = await page.evaluate(
      (address) =>
        new Promise((resolve) => {
          const frame = document.createElement("iframe");
          frame.src = address;
          addEventListener("message", ({ data, source }) => {
            if (source !== frame.contentWindow) return;
            if (data.kind === "ready") {
              const message = { thinshell: 1, kind: "set", state: "v=2&preset=star" };
              frame.contentWindow?.postMessage(message, new URL(address).origin);
            } else resolve(data);
          });
          document.body.append(frame);
        }),
      `${baseURL}?embed=result&match=later&origin=https://course.example#${EASY}`,
    );
    expect(answer).toEqual({
      thinshell: 1,
      kind: "refused",
      message: "only https://course.example is answered, as this frame's address says",
    });
  });

  test("out of sight it does not begin, and what runs is paused until it is seen again", async ({ page, baseURL }) => {
    await page.goto(`${other.address}frame.html?page=${baseURL}`);
    await page.evaluate(() => {
      const spacer = document.createElement("div");
      spacer.style.height = "4000px";
      document.querySelector("main")?.prepend(spacer);
      const frame = document.querySelector("iframe");
      if (frame) frame.src = `${frame.src.replace("preset=ellipse", "preset=hand&finest=8")}`.replace("?", "?again=1&");
    });
    const frame = page.frameLocator("iframe");
    await expect(frame.locator(".headline")).toHaveText("Ready: press Match.");
    // A frame's time, many times over.
    await page.evaluate(() => new Promise((resolve) => setTimeout(resolve, 500)));
    await expect(frame.locator(".headline")).toHaveText("Ready: press Match.");
    await page.locator("iframe").scrollIntoViewIfNeeded();
    await expect(frame.locator(".headline")).toContainText("grid …", { timeout: 20_000 });
    await page.evaluate(() => scrollTo(0, 0));
    await expect(frame.locator(".headline")).toHaveText("Paused.");
    await page.locator("iframe").scrollIntoViewIfNeeded();
    await expect(frame.locator(".headline")).not.toHaveText("Paused.");
    await expect(frame.locator(".headline")).toContainText("Fits", { timeout: 45_000 });
  });
});

test("the dialog makes a snippet that shows what the page shows", async ({ page }) => {
  const seen = watch(page);
  await page.goto(`./#${EASY}&bending=0`);
  await finished(page);
  await page.locator(".save summary").click();
  await button(page, "Embed in another page …").click();
  const dialog = page.getByRole("dialog", { name: "Embed in another page" });
  await expect(dialog).toBeVisible();
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  const snippet = dialog.getByLabel("To be copied into the page");
  await expect(snippet).toHaveValue(/\?embed=result#v=2&amp;preset=ellipse&amp;bending=0&amp;finest=5" width="700"/);
  await dialog.getByLabel("Two settings side by side").check();
  await dialog.getByLabel("Change in the second").selectOption("volume");
  await dialog.getByLabel("Its value there").fill("0.1");
  await dialog.getByLabel("Its value there").press("Tab");
  await dialog.getByLabel("Choose the view").uncheck();
  await dialog.getByLabel("Match at once, without a press").uncheck();
  await dialog.getByLabel("Width, pixels").fill("600");
  await dialog.getByLabel("Width, pixels").press("Tab");
  await expect(snippet).toHaveValue(
    /embed=compare&amp;controls=morph,link&amp;b=volume:0.1&amp;match=later#.*width="600"/,
  );
  const text = await snippet.inputValue();
  await dialog.getByRole("button", { name: "Close" }).click();
  await expect(dialog).toHaveCount(0);

  expect(seen.errors).toEqual([]);

  // Another page, without the policy of this one.
  await page.goto("./demos/demo.css");
  await page.setContent(text);
  const frame = page.frameLocator("iframe");
  await frame.getByRole("button", { name: "Compare" }).click();
  await expect(frame.locator("figcaption")).toHaveText([/^A: .*0.01$/, /^B: .*0.1$/], { timeout: 45_000 });
});

test("the frame speaks German where it is asked to", async ({ page }) => {
  await page.goto(`./?embed=full&lang=de#${EASY}`);
  await expect(button(page, "Abgleichen")).toBeVisible({ timeout: 20_000 });
  await expect(page.locator(".headline")).toContainText("Passt", { timeout: 45_000 });
  expect(await value(page, "cover-max")).toBeLessThan(0.5);
});
