// `npm run reproduce`: runs the paper's experiments and writes docs/paper.md and docs/figures/*.svg.
//
//   npm run reproduce -- strain rotation        only the experiments named; prints, writes nothing
//   npm run reproduce -- --shapes FILE.json     adds a table of the consecutive polygons of a file
//                                               [{ "name": …, "points": [[x, y], …] }, …]
//   … --shapes FILE.json --about "…"            what the document says of the file: its source, its terms

import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { parseArgs } from "node:util";
import { heading, main, Obstacle, root } from "./lib/process.mjs";
import { checkNode, ensurePackages } from "./lib/setup.mjs";
import { buildWasm } from "./wasm.mjs";

await main(async () => {
  const { values, positionals } = parseArgs({
    options: { shapes: { type: "string" }, about: { type: "string" } },
    allowPositionals: true,
  });
  if (values.shapes !== undefined && !existsSync(values.shapes))
    throw new Obstacle(`There is no file ${values.shapes}; --shapes takes the path of a JSON file of polygons.`);
  checkNode();
  await ensurePackages();
  await buildWasm();
  const experiments = await load();
  const unknown = positionals.find((id) => !experiments.EXPERIMENTS.some((experiment) => experiment.id === id));
  if (unknown !== undefined)
    throw new Obstacle(
      `There is no experiment "${unknown}"; there are ${experiments.EXPERIMENTS.map(({ id }) => id).join(", ")}.`,
    );
  const polygons = values.shapes === undefined ? null : read(experiments, values.shapes);

  const chosen = experiments.EXPERIMENTS.filter(({ id }) => positionals.length === 0 || positionals.includes(id));
  const chapters = [];
  for (const { run, ...about } of chosen) {
    heading(about.title);
    chapters.push({ ...about, blocks: await run(experiments.context, "full") });
  }
  if (polygons) {
    const title = `Real shapes: ${basename(values.shapes ?? "")}`;
    heading(title);
    const blocks = await experiments.matchPolygons(experiments.context, polygons);
    chapters.push({ id: "shapes", title, paper: "", setup: values.about ?? "", blocks });
  }
  const text = experiments.document(chapters);
  if (positionals.length > 0) console.log(`\n${text}`);
  else write(text, chapters);
});

/** The experiments' modules, compiled by Vite, and the solver they run on. */
async function load() {
  // Not above: on a fresh clone there is no Vite before the packages are installed.
  const { runnerImport } = await import("vite");
  const module = async (/** @type {string} */ name) =>
    (await runnerImport(join(root, "www", "experiments", name), { root, configFile: false, logLevel: "error" })).module;
  const { EXPERIMENTS } = /** @type {typeof import("../www/experiments/index")} */ (await module("index.ts"));
  const { document } = /** @type {typeof import("../www/experiments/markdown")} */ (await module("markdown.ts"));
  const polygons = /** @type {typeof import("../www/experiments/polygons")} */ (await module("polygons.ts"));
  const { initSync, Registration } = await import("../www/wasm/thinshell.js");
  initSync({ module: readFileSync(join(root, "www", "wasm", "thinshell_bg.wasm")) });
  /** @type {import("../www/experiments/experiment").Context} */
  const context = {
    solver: Registration,
    millis: () => performance.now(),
    progress: (done, doing) => console.log(`${String(Math.round(100 * done)).padStart(3)} %  ${doing}`),
  };
  return { EXPERIMENTS, document, ...polygons, context };
}

/**
 * @param {Awaited<ReturnType<typeof load>>} experiments
 * @param {string} file
 */
function read(experiments, file) {
  try {
    return experiments.readPolygons(readFileSync(file, "utf8"));
  } catch (problem) {
    throw new Obstacle(`${file}: ${problem instanceof Error ? problem.message : problem}.`);
  }
}

/**
 * @param {string} text
 * @param {{ blocks: import("../www/experiments/experiment").Block[] }[]} chapters
 */
function write(text, chapters) {
  const docs = join(root, "docs");
  const figures = join(docs, "figures");
  rmSync(figures, { recursive: true, force: true });
  mkdirSync(figures, { recursive: true });
  writeFileSync(join(docs, "paper.md"), text);
  for (const block of chapters.flatMap(({ blocks }) => blocks))
    if (block.kind === "figure") writeFileSync(join(figures, `${block.name}.svg`), block.svg);
  console.log("\ndocs/paper.md and docs/figures are written.");
}
