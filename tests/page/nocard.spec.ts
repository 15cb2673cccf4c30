/** A browser without a graphics card. */

import { expect, test } from "@playwright/test";
import { chromiumFlags, findChromium } from "../../scripts/lib/chromium.mjs";
import { button } from "./handles";

const args = chromiumFlags().filter((flag) => flag !== "--enable-unsafe-webgpu");
test.use({ launchOptions: { args, executablePath: findChromium() ?? undefined } });

test("who insists on a graphics card is told that there is none", async ({ page }) => {
  await page.goto("./#v=2&preset=ellipse&finest=5&backend=gpu&match=later");
  await button(page, "Match").click();
  await expect(page.getByRole("alert")).toContainText(/Backend is "gpu", but .*; choose "auto" or "cpu"\./);
});
