/** The content security policy of the page: strict, and nothing that the page does is against it. */

import { expect, type Page, test } from "@playwright/test";
import { choose, disc, drop, file, svgFile, take } from "./files";
import { button, ellipse, finished, stroke, value, watch } from "./handles";
import { serving } from "./server";

/** Notes what the policy has refused. */
async function violations(page: Page): Promise<() => Promise<string[]>> {
  await page.addInitScript(() => {
    const all: string[] = [];
    Object.assign(window, { violations: all });
    document.addEventListener("securitypolicyviolation", ({ violatedDirective, blockedURI }) => {
      all.push(`${violatedDirective}: ${blockedURI}`);
    });
  });
  return () => page.evaluate(() => Reflect.get(window, "violations"));
}

test("a whole session is within the policy", async ({ page }) => {
  test.slow();
  const seen = watch(page);
  const refused = await violations(page);
  await page.goto("./#v=1&preset=ellipse&finest=5");
  await stroke(page, "Reference", ellipse(0.15, 0.2));
  await button(page, "Match").click();
  await finished(page);
  await choose(
    page,
    "Template",
    svgFile('<style>rect{stroke:none}</style><rect style="fill:red" width="9" height="6"/>'),
  );
  await take(page, "Template");
  await drop(page, "body", file("a.png", "image/png", disc([0, 0, 0, 255], [255, 255, 255, 255])));
  await take(page, "Reference");
  await button(page, "Import target").click();
  await button(page, "Gallery").click();
  await button(page, "Drop").click();
  await take(page, "Template");
  await button(page, "Match").click();
  await finished(page);
  await page.getByLabel("View", { exact: true }).selectOption("Image carried");
  await expect(page.locator(".legend")).toBeVisible();
  for (const label of [
    "Picture (PNG)",
    "Drawing (SVG)",
    "Everything (JSON)",
    "Matched points (CSV)",
    "Morph as video (WebM)",
    "Morph as GIF",
  ]) {
    await page.getByText("Save", { exact: true }).click();
    await Promise.all([page.waitForEvent("download"), button(page, label).click()]);
    await expect(page.getByText("Save", { exact: true })).toBeVisible();
  }
  await page.getByText("Energies over iterations").click();
  await expect(page.getByRole("img", { name: /^Energy terms/ })).toBeVisible();
  await page.getByText("Compare side by side").click();
  await button(page, "Compare").click();
  await expect(page.getByRole("row", { name: "Energy" })).toBeVisible({ timeout: 30_000 });
  await page.getByRole("switch", { name: "Live" }).click();
  await finished(page);
  expect(await refused()).toEqual([]);
  expect(seen.errors).toEqual([]);
});

test("the experiments are within the policy", async ({ page }) => {
  const seen = watch(page);
  const refused = await violations(page);
  await page.goto("./experiments.html");
  const section = page.getByRole("region", { name: /^Fig\. 5/ });
  await section.getByRole("button", { name: /^Compute: / }).click();
  await expect(section.getByRole("img")).toBeVisible({ timeout: 60_000 });
  expect(await section.getByRole("img").evaluate((image: HTMLImageElement) => image.naturalWidth)).toBeGreaterThan(300);
  expect(await refused()).toEqual([]);
  expect(seen.errors).toEqual([]);
});

for (const address of ["./", "./experiments.html"]) {
  test(`${address} runs no script but its own, and sends nothing away`, async ({ page }) => {
    const refused = await violations(page);
    await page.goto(address);
    await expect(page.getByRole("button").first()).toBeVisible();
    const policy = (await page.locator("meta[http-equiv]").getAttribute("content")) ?? "";
    expect(policy).not.toMatch(/unsafe-inline|'unsafe-eval'|\*/);
    await page.evaluate(async () => {
      const script = document.createElement("script");
      script.textContent = "window.ran = 1";
      document.body.append(script);
      await fetch("https://example.org/").catch(() => {});
    });
    expect(await page.evaluate(() => "ran" in window)).toBe(false);
    await expect
      .poll(refused)
      .toEqual([expect.stringContaining("script-src"), expect.stringContaining("connect-src: https://example.org")]);
    expect(await page.evaluate(() => document.querySelectorAll("script:not([src]):not([type])").length)).toBe(1);
  });
}

test("under a sub-path of a plain static server everything works, the licences too", async ({ page }) => {
  const server = await serving("dist", "/deep/er/");
  try {
    const seen = watch(page);
    const refused = await violations(page);
    await page.goto(`${server.address}#v=1&preset=ellipse&finest=5`);
    await button(page, "Match").click();
    await finished(page);
    expect(await value(page, "mismatch-max")).toBeLessThan(0.5);
    await choose(page, "Reference", svgFile('<rect width="9" height="9"/>'));
    await take(page, "Reference");
    expect(await refused()).toEqual([]);
    await page
      .getByRole("contentinfo")
      .getByRole("link", { name: /^Licences/ })
      .click();
    await expect(page.getByRole("heading", { name: "Licences" })).toBeVisible();
    for (const part of ["preact", "svgpath", "clipper2-ts", "uplot", "gifenc", "glam", "js-sys", "wide"]) {
      await expect(page.getByRole("heading", { name: new RegExp(`^${part} \\d`) })).toBeVisible();
    }
    await page.getByRole("link", { name: "Back to the page" }).click();
    await expect(button(page, "Match")).toBeVisible();
    expect(seen.errors).toEqual([]);
  } finally {
    server.close();
  }
});
