// `npm run silhouettes`: writes the gallery's outlines to target/silhouettes.json, for `cargo run --release --example
// families`. They go through the page's own readers and its Fit, in a browser, so that what is measured is what people
// match. Of each silhouette the largest part is taken, its holes filled: only what is connected alike can match. The file
// is [{ "name": …, "loops": [[[x, y], …], …] }, …], in the unit box, y up, and ends with one shape that the gallery does
// not show: the wings of its butterfly with the slit between them open.

import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { chromiumFlags, ensureChromium } from "./lib/chromium.mjs";
import { main, root } from "./lib/process.mjs";
import { checkNode, ensurePackages } from "./lib/setup.mjs";

await main(async () => {
  checkNode();
  await ensurePackages();
  const executablePath = await ensureChromium();
  const { createServer } = await import("vite");
  const { chromium } = await import("@playwright/test");

  const server = await createServer({ root, logLevel: "warn", server: { port: 4220, hmr: false, watch: null } });
  const browser = await chromium.launch({ executablePath, args: chromiumFlags() });
  try {
    await server.listen();
    const page = await browser.newPage();
    // Any address of the server will do: what is wanted are its modules.
    await page.goto(`${server.resolvedUrls?.local[0]}package.json`);
    const silhouettes = await page.evaluate(outlines);
    const file = join(root, "target", "silhouettes.json");
    mkdirSync(join(root, "target"), { recursive: true });
    writeFileSync(file, JSON.stringify(silhouettes));
    console.log(`${silhouettes.length} silhouettes are written to ${file}.`);
  } finally {
    await browser.close();
    await server.close();
  }
});

/** In the browser: every silhouette as the import dialog gives its largest part, filled. */
async function outlines() {
  const [{ collections }, { ICONS }, { begun, selectionOf }, { Content }, { flattened, parsePath }] = await Promise.all(
    [
      "gallery/index.ts",
      "gallery/icons.ts",
      "controls/importDraft.ts",
      "shapes/import/content.ts",
      "shapes/import/path.ts",
    ].map((path) => import(`/www/${path}`)),
  );
  /** @param {string} name @param {import("../www/shapes/import/found").Found} found */
  const outline = (name, found) => {
    const content = new Content(found);
    const wishes = { ...selectionOf(begun(content.offer, name, null)), parts: "largest", holes: "fill" };
    const { prepared } = content.outcome(wishes);
    const points = (/** @type {Float64Array} */ loop) =>
      Array.from({ length: loop.length / 2 }, (_, i) =>
        [loop[2 * i], loop[2 * i + 1]].map((x) => Number(x.toFixed(6))),
      );
    return { name, loops: /** @type {Float64Array[]} */ (prepared.shape).map(points) };
  };
  const gallery = collections()
    .flatMap((/** @type {import("../www/gallery/index").Collection} */ { silhouettes }) => silhouettes)
    .map((/** @type {import("../www/gallery/index").Silhouette} */ { name, found }) => outline(name, found))
    .sort((/** @type {{ name: string }} */ a, /** @type {{ name: string }} */ b) => (a.name < b.name ? -1 : 1));

  const { svg } = ICONS.find((/** @type {{ name: string }} */ { name }) => name === "Butterfly");
  const [, path] = / d="([^"]*)"/.exec(svg) ?? [];
  const subpaths = flattened(parsePath(path), [1, 0, 0, -1, 0, 0], 0.002);
  const loops = [subpaths.map((/** @type {{ points: Float64Array }} */ { points }) => points).at(-1)];
  const choice = { name: "Wings", loops, placed: false, mainPart: false, smoothing: 0 };
  return [...gallery, outline("Butterfly’s wings", { kind: "shapes", choices: [choice], notes: [] })];
}
