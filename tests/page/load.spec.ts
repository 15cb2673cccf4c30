import { expect, test } from "@playwright/test";

test("the page loads without an error and asks for nothing afterwards", async ({ page, baseURL }) => {
  const problems: string[] = [];
  const requests: string[] = [];
  page.on("console", (message) => {
    if (message.type() === "error" || message.type() === "warning") problems.push(message.text());
  });
  page.on("pageerror", (error) => problems.push(String(error)));
  page.on("request", (request) => requests.push(request.url()));

  await page.goto("./");
  await page.waitForLoadState("networkidle");
  await expect(page.getByRole("button", { name: "Match" })).toBeVisible();
  expect(requests.filter((url) => !url.startsWith(baseURL ?? "") && !/^(data|blob):/.test(url))).toEqual([]);

  const loaded = requests.length;
  await page.mouse.move(200, 300);
  await page.waitForTimeout(1000);
  expect(requests.slice(loaded)).toEqual([]);
  expect(problems).toEqual([]);
});
