/** The page without the network, after one visit; and a new version of it. */

import { createHash } from "node:crypto";
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { expect, type Page, test } from "@playwright/test";
import { choose, svgFile, take } from "./files";
import { button, clear, drawn, ellipse, finished, settings, stroke, value, watch } from "./handles";
import { type Server, serving } from "./server";

test.use({ serviceWorkers: "allow" });

/** Waits until the page could do without the network. */
async function kept(page: Page): Promise<void> {
  await page.evaluate(async () => {
    await navigator.serviceWorker.ready;
    if (navigator.serviceWorker.controller) return;
    await new Promise((resolve) =>
      navigator.serviceWorker.addEventListener("controllerchange", resolve, { once: true }),
    );
  });
}

test("offline after one visit everything works: match, import, views, export, the experiments", async ({
  page,
  context,
}) => {
  test.slow();
  const seen = watch(page);
  await page.goto("./#v=2&preset=ellipse&finest=5&match=later");
  await kept(page);
  await context.setOffline(true);
  // What this visit has not yet fetched is there, and so is the page for the next one.
  await settings(page).click();
  await expect(page.getByLabel("Bending", { exact: true })).toBeVisible();
  await page.goto("./?bending=0#v=2&preset=leaf&finest=5");
  await finished(page);
  expect(await value(page, "mismatch-max")).toBeLessThan(0.5);
  await choose(page, "Reference", svgFile('<rect width="9" height="9"/>'));
  await take(page, "Reference");
  await button(page, "Match").click();
  await finished(page);
  await page.getByLabel("View", { exact: true }).selectOption("Stretch");
  await expect(page.locator(".legend")).toBeVisible();
  for (const label of ["Picture (PNG)", "Everything (JSON)"]) {
    await page.getByText("Save", { exact: true }).click();
    await Promise.all([page.waitForEvent("download"), button(page, label).click()]);
  }
  await button(page, "Import target").click();
  await button(page, "Gallery").click();
  await expect(button(page, "Drop")).toBeVisible();
  await page.goto("./experiments.html");
  const section = page.getByRole("region", { name: /^Fig\. 5/ });
  await section.getByRole("button", { name: /^Compute: / }).click();
  await expect(section.getByRole("img")).toBeVisible({ timeout: 60_000 });
  await page.goto("./licences.html");
  await expect(page.getByRole("heading", { name: "Licences" })).toBeVisible();
  expect(seen.errors).toEqual([]);
});

test("every file of the build is kept, none else, and the page can be installed", async ({ page, baseURL }) => {
  await page.goto("./#v=2&preset=ellipse&match=later");
  await kept(page);
  const all = await page.evaluate(async () => {
    const [name] = (await caches.keys()).filter((key) => key.startsWith("thinshell "));
    return (await (await caches.open(name)).keys()).map(({ url }) => url.replace(location.origin, ""));
  });
  for (const path of ["/index.html", "/experiments.html", "/licences.html", "/manifest.webmanifest"])
    expect(all).toContain(path);
  // Of curves, of surfaces, and of both where a graphics card computes.
  expect(all.filter((path) => path.endsWith(".wasm"))).toHaveLength(3);
  expect(all).not.toContain("/sw.js");
  const manifest = await (await page.request.get(`${baseURL}manifest.webmanifest`)).json();
  for (const { src } of manifest.icons) expect(all).toContain(`/${src}`);
  const client = await page.context().newCDPSession(page);
  const { installabilityErrors } = await client.send("Page.getInstallabilityErrors");
  // An incognito window, as tests have, installs nothing; that is all there may be against it.
  expect(installabilityErrors.map(({ errorId }) => errorId).filter((id) => id !== "in-incognito")).toEqual([]);
});

test.describe("a new version", () => {
  let folder = "";
  let server: Server;

  test.beforeEach(async () => {
    folder = mkdtempSync(join(tmpdir(), "thinshell-"));
    server = await serving("dist");
  });
  test.afterEach(() => {
    server.close();
    rmSync(folder, { recursive: true });
  });

  /** The build with another title, as the next build would have it: its worker has another list and version. */
  function next(title: string): string {
    const to = join(folder, title);
    cpSync("dist", to, { recursive: true });
    const page = readFileSync(join(to, "index.html"), "utf8");
    const changed = page.replace(/<title>[^<]*/, `<title>${title}`);
    const digest = (text: string) => createHash("sha256").update(text).digest("hex");
    writeFileSync(join(to, "index.html"), changed);
    const worker = readFileSync(join(to, "sw.js"), "utf8");
    const version = worker.match(/(?<= |\})[0-9a-f]{16}(?=[`"'])/)?.[0] ?? "";
    expect(worker).toContain(digest(page));
    expect(version).not.toBe("");
    const listed = worker.replace(digest(page), digest(changed));
    writeFileSync(join(to, "sw.js"), listed.replace(version, digest(listed).slice(0, 16)));
    return to;
  }

  function notice(page: Page) {
    return page.getByRole("region", { name: "Version" });
  }

  test("waits and says so, and takes over at a press without losing what has been drawn", async ({ page }) => {
    await page.goto(`${server.address}#v=2&preset=ellipse&finest=5&match=later`);
    await kept(page);
    await expect(notice(page)).toHaveText("");
    server.serve(next("second"));
    // The old version is what the visit gets, while the new one is fetched.
    await page.reload();
    expect(await page.title()).not.toBe("second");
    await expect(notice(page)).toContainText("A new version of this page is ready.");
    await clear(page);
    await stroke(page, "Reference", ellipse(0.2, 0.15));
    await expect.poll(() => drawn(page, "Reference")).toBeTruthy();
    const before = drawn(page, "Reference");
    await button(page, "Use it now").click();
    await expect.poll(() => page.title()).toBe("second");
    await expect.poll(() => drawn(page, "Reference")).toBe(before);
    await expect(notice(page)).toHaveText("");
  });

  test("is what the next visit gets once nobody looks at the old one; a tab that does keeps its parts", async ({
    page,
    context,
  }) => {
    await page.goto(`${server.address}#v=2&preset=ellipse&finest=5&match=later`);
    await kept(page);
    const old = await context.newPage();
    await old.goto(`${server.address}#v=2&preset=leaf&finest=5&match=later`);
    server.serve(next("second"));
    await page.reload();
    await button(page, "Use it now").click();
    await expect.poll(() => page.title()).toBe("second");
    expect(await old.title()).not.toBe("second");
    await context.setOffline(true);
    await settings(old).click();
    await expect(old.getByLabel("Bending", { exact: true })).toBeVisible();
    await context.setOffline(false);
    await old.close();

    server.serve(next("third"));
    await page.reload();
    await expect(notice(page)).toContainText("A new version of this page is ready.");
    await page.close();
    const visit = await context.newPage();
    await visit.goto(server.address);
    await expect.poll(() => visit.title()).toBe("third");
    // Of the versions before, one is left.
    const caches_ = await visit.evaluate(() => caches.keys());
    expect(caches_).toHaveLength(2);
  });
});
