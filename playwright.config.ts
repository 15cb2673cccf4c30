import { defineConfig } from "@playwright/test";
import { chromiumFlags, findChromium } from "./scripts/lib/chromium.mjs";

// Other than Vite's own, so that a running `npm start` is not mistaken for the build under test.
const port = Number(process.env.THINSHELL_PORT ?? 4190);
const browser = findChromium();

export default defineConfig({
  testDir: "tests/page",
  outputDir: "target/playwright",
  // The solver runs in the page: beside another one it would be half as fast, and tests would time out for it.
  workers: 1,
  timeout: 60_000,
  forbidOnly: Boolean(process.env.CI),
  // Machines of CI stand still for seconds now and then. What passes only at the second attempt is named in the report.
  retries: process.env.CI ? 1 : 0,
  reporter: "list",
  use: {
    baseURL: `http://localhost:${port}/`,
    viewport: { width: 1280, height: 800 },
    trace: "retain-on-failure",
    // Every test has a profile of its own, in which the worker would fetch the whole page anew, beside the solver.
    serviceWorkers: "block",
    launchOptions: { args: chromiumFlags(), ...(browser === null ? {} : { executablePath: browser }) },
  },
  webServer: {
    command: `node node_modules/vite/bin/vite.js preview --strictPort --port ${port}`,
    url: `http://localhost:${port}/`,
    reuseExistingServer: false,
  },
});
