import { expect, test } from "@playwright/test";
import { loaded, watch } from "./handles";

test("the page loads without an error and asks for nothing afterwards", async ({ page, baseURL }) => {
  const { errors, requests } = watch(page);
  const whole = loaded(page);
  await page.goto("./");
  await whole;
  await page.waitForLoadState("networkidle");
  await expect(page.getByRole("button", { name: "Match" })).toBeVisible();
  expect(requests.filter((url) => !url.startsWith(baseURL ?? "") && !/^(data|blob):/.test(url))).toEqual([]);

  const before = requests.length;
  await page.mouse.move(200, 300);
  await page.waitForTimeout(1000);
  expect(requests.slice(before)).toEqual([]);
  expect(errors).toEqual([]);
});
