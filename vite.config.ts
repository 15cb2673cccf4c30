import { defineConfig } from "vitest/config";

export default defineConfig({
  // Relative addresses: the build works under any path of any static server.
  base: "./",
  build: { target: "es2022", sourcemap: false },
  worker: { format: "es" },
  test: { include: ["www/**/*.test.{ts,tsx}", "scripts/**/*.test.mjs"] },
});
