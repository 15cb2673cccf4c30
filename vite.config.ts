import { defineConfig } from "vitest/config";
import { countries } from "./scripts/lib/countries.mjs";
import { licences } from "./scripts/lib/licences.mjs";
import { policyForDevelopment } from "./scripts/lib/policy.mjs";

const { page, worker } = licences();

export default defineConfig({
  // Relative addresses: the build works under any path of any static server.
  base: "./",
  plugins: [countries(), page, policyForDevelopment()],
  build: {
    target: "es2022",
    sourcemap: false,
    // Where a browser does not preload, modules come a moment later; no part of the first load for that.
    modulePreload: { polyfill: false },
    rolldownOptions: { input: ["index.html", "experiments.html"] },
  },
  worker: { format: "es", plugins: () => [worker] },
  // Neither watch what cargo builds nor look for pages in it.
  server: { watch: { ignored: ["**/target/**"] } },
  optimizeDeps: { entries: ["index.html", "experiments.html", "benches/page/index.html"] },
  test: { include: ["www/**/*.test.{ts,tsx}", "scripts/**/*.test.mjs"] },
});
