import { expect, test } from "@playwright/test";
import { watch } from "./handles";

test("the page loads without an error and asks for nothing afterwards", async ({ page, baseURL }) => {
  const { errors, requests } = watch(page);
  await page.goto("./");
  await page.waitForLoadState("networkidle");
  await expect(page.getByRole("button", { name: "Match" })).toBeVisible();
  expect(requests.filter((url) => !url.startsWith(baseURL ?? "") && !/^(data|blob):/.test(url))).toEqual([]);

  const loaded = requests.length;
  await page.mouse.move(200, 300);
  await page.waitForTimeout(1000);
  expect(requests.slice(loaded)).toEqual([]);
  expect(errors).toEqual([]);
});
