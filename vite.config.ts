import type { Plugin } from "vite";
import { defineConfig } from "vitest/config";
import { countries } from "./scripts/lib/countries.mjs";
import { lessons } from "./scripts/lib/lessons.mjs";
import { licences } from "./scripts/lib/licences.mjs";
import { offline, WORKER } from "./scripts/lib/offline.mjs";
import { policyForDevelopment } from "./scripts/lib/policy.mjs";

const { page, worker } = licences();

const FIRST =
  /\/www\/(engine|view\/(along|canvas|palette|morph|result)|pins\/kit|link\/text|words\/numbers)\.ts$|\/wasm\/thinshell_bg\.wasm|preload-helper|\/preact\/jsx-runtime\//;

/** What a page's file says to those who write it, and how it is indented, is not sent. */
const plain: Plugin = {
  name: "thinshell-plain",
  apply: "build",
  transformIndexHtml: (html) => html.replace(/\s*<!--.*?-->/gs, "").replace(/\n\s+/g, "\n"),
};

export default defineConfig({
  // Relative addresses: the build works under any path of any static server.
  base: "./",
  plugins: [countries(), page, policyForDevelopment(), lessons("docs/lessons"), plain, offline()],
  build: {
    target: "es2022",
    sourcemap: false,
    // Where a browser does not preload, modules come a moment later; no part of the first load for that.
    modulePreload: { polyfill: false },
    rolldownOptions: {
      input: {
        index: "index.html",
        experiments: "experiments.html",
        lessons: "lessons.html",
        [WORKER]: "www/offline/worker.ts",
      },
      // The service worker's name is part of its contract, and it has to lie beside the page.
      output: {
        entryFileNames: ({ name }) => (name === WORKER ? WORKER : "assets/[name]-[hash].js"),
        // What the first picture needs of what others share, in one file: six would compress worse and come later.
        codeSplitting: { groups: [{ name: "shared", test: FIRST }] },
      },
    },
  },
  worker: { format: "es", plugins: () => [worker] },
  // Neither watch what cargo builds nor look for pages in it.
  server: { watch: { ignored: ["**/target/**"] } },
  optimizeDeps: { entries: ["index.html", "experiments.html", "lessons.html", "benches/page/index.html"] },
  test: { include: ["www/**/*.test.{ts,tsx}", "command/**/*.test.ts", "scripts/**/*.test.mjs"] },
});
