// examples/notebook/book as mystmd reads it, each widget shown by the renderer of MyST's themes. The themes themselves are
// fetched by `myst` when it builds pages; what they do with a widget is this.

import { spawnSync } from "node:child_process";
import { cpSync, existsSync, mkdirSync, readdirSync, readFileSync, symlinkSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { freePort } from "../lib/drivers.mjs";
import { Obstacle } from "../lib/process.mjs";
import { expect, matches } from "./front.mjs";

const MISSING =
  "There is no mystmd: npm install mystmd @myst-theme/anywidget react react-dom in a folder of its own, and name that by MYST.";

/** A theme of nothing, in place of the one that would be fetched. */
const TEMPLATE = "myst: v1\nkind: site\ntitle: Bare\nbuild:\n  start: node -e 0\n";

const PAGE = `<!doctype html><link rel="icon" href="data:,"><main id="place"></main>
<script type="module" src="/main.js"></script>`;

/** What a theme does with a page's nodes. */
const MAIN = `import { createElement } from "react";
import { createRoot } from "react-dom/client";
import { ANY_RENDERERS } from "@myst-theme/anywidget";
import nodes from "./nodes.json";
const shown = nodes.map((node) => createElement(ANY_RENDERERS.anywidget, { node, key: node.key }));
createRoot(document.getElementById("place")).render(shown);
`;

/** @param {import("./front.mjs").Place} place */
export async function myst({ folder, shown }) {
  const packages = resolve(process.env.MYST ?? ".", "node_modules");
  const command = join(packages, ".bin", "myst");
  if (!existsSync(command) || !existsSync(join(packages, "@myst-theme", "anywidget"))) throw new Obstacle(MISSING);
  const book = join(folder, "book");
  mkdirSync(join(book, "bare"));
  writeFileSync(join(book, "bare", "template.yml"), TEMPLATE);
  writeFileSync(join(book, "myst.yml"), `${readFileSync(join(book, "myst.yml"), "utf8")}  template: ./bare\n`);
  const { status, stdout, stderr } = spawnSync(command, ["build", "--site", "--strict", "--ci"], {
    cwd: book,
    encoding: "utf8",
  });
  if (status !== 0) throw new Obstacle(`myst could not build the book:\n${stdout}${stderr}`);
  const site = join(book, "_build", "site");
  const nodes = readdirSync(join(site, "content")).flatMap((name) =>
    widgets(JSON.parse(readFileSync(join(site, "content", name), "utf8")).mdast),
  );
  expect(`The book has ${nodes.length} widgets.`, /2 widgets/);

  const project = join(book, "shown");
  mkdirSync(project);
  symlinkSync(packages, join(project, "node_modules"));
  cpSync(join(site, "public"), join(project, "public"), { recursive: true });
  writeFileSync(join(project, "index.html"), PAGE);
  writeFileSync(join(project, "main.js"), MAIN);
  writeFileSync(join(project, "nodes.json"), JSON.stringify(nodes));
  const { build, preview } = await import("vite");
  const port = await freePort();
  const options = { root: project, configFile: /** @type {const} */ (false), logLevel: /** @type {const} */ ("error") };
  await build(options);
  const served = await preview({ ...options, preview: { port, strictPort: true } });
  try {
    await shown(`http://localhost:${port}/`, read);
  } finally {
    await served.close();
  }
}

/** @param {any} node @returns {any[]} */
function widgets(node) {
  return [...(node.type === "anywidget" ? [node] : []), ...(node.children ?? []).flatMap(widgets)];
}

/** @param {import("@playwright/test").Page} page */
async function read(page) {
  /** @type {string[]} */
  const wrong = [];
  page.on("console", (message) => message.type() === "error" && wrong.push(message.text()));
  page.on("pageerror", (error) => wrong.push(error.message));
  await matches(page, 2);
  const said = await page.locator("thin-shell-match").getByRole("status").allTextContents();
  const views = await page.getByLabel("View").evaluateAll((all) => all.map((one) => Reflect.get(one, "value")));
  expect(said.map((words, i) => `${views[i]}: ${words}`).join("\n"), /^stretch: Fits.*\ngrid: Fits/);
  if (wrong.length > 0) throw new Obstacle(`The browser tells of errors:\n${wrong.join("\n")}`);
}
