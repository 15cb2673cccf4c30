// `npm run reproduce`: runs the paper's experiments and writes docs/paper.md, docs/surfaces.md and docs/figures/*.svg.
//
//   npm run reproduce -- --only curves          … or surfaces: one of the two documents
//   npm run reproduce -- strain octahedron      only the experiments named; prints, writes nothing
//   npm run reproduce -- --shapes FILE.json     adds a table of the consecutive polygons of a file
//                                               [{ "name": …, "points": [[x, y], …] }, …]
//   … --shapes FILE.json --about "…"            what the document says of the file: its source, its terms
//   npm run reproduce -- --meshes ONE OTHER     two mesh files of one numbering: how far each vertex ends from its
//                                               namesake, on 33³ and 65³ nodes; prints, writes nothing

import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { parseArgs } from "node:util";
import { heading, main, Obstacle, root } from "./lib/process.mjs";
import { checkNode, ensurePackages } from "./lib/setup.mjs";
import { buildSolidWasm, buildWasm } from "./wasm.mjs";

const PARTS = ["curves", "surfaces"];

await main(async () => {
  const { values, positionals } = parseArgs({
    options: {
      only: { type: "string" },
      shapes: { type: "string" },
      about: { type: "string" },
      meshes: { type: "boolean" },
    },
    allowPositionals: true,
  });
  for (const file of [values.shapes, ...(values.meshes ? positionals : [])])
    if (file !== undefined && !existsSync(file)) throw new Obstacle(`There is no file ${file}.`);
  if (values.only !== undefined && !PARTS.includes(values.only))
    throw new Obstacle(`--only takes one of ${PARTS.join(" and ")}, not "${values.only}".`);
  if (values.meshes && positionals.length !== 2) throw new Obstacle("--meshes takes the paths of two mesh files.");
  checkNode();
  await ensurePackages();
  await buildWasm();
  await buildSolidWasm();
  const parts = await load();
  if (values.meshes) return matchMeshes(parts.surfaces, positionals);
  const all = Object.values(parts).flatMap(({ studies }) => studies.map(({ id }) => id));
  const unknown = positionals.find((id) => !all.includes(id));
  if (unknown !== undefined) throw new Obstacle(`There is no experiment "${unknown}"; there are ${all.join(", ")}.`);
  const polygons = values.shapes === undefined ? null : read(parts.curves, values.shapes);

  for (const [name, part] of Object.entries(parts)) {
    if (values.only !== undefined && values.only !== name) continue;
    const chosen = part.studies.filter(({ id }) => positionals.length === 0 || positionals.includes(id));
    const chapters = [];
    for (const { run, ...about } of chosen) {
      heading(about.title);
      chapters.push({ ...about, blocks: await run(part.context, "full") });
    }
    if (polygons && name === "curves") {
      const title = `Real shapes: ${basename(values.shapes ?? "")}`;
      heading(title);
      const blocks = await parts.curves.matchPolygons(part.context, polygons);
      chapters.push({ id: "shapes", title, paper: "", setup: values.about ?? "", blocks });
    }
    if (chapters.length === 0) continue;
    const text = part.document(part.head, chapters);
    if (positionals.length > 0) console.log(`\n${text}`);
    else write(part, text, chapters);
  }
});

/** Prints the table of two meshes. @param {Awaited<ReturnType<typeof load>>["surfaces"]} part @param {string[]} files */
async function matchMeshes(part, files) {
  try {
    const [reference, template] = files.map((file) => part.readSoup(basename(file), readFileSync(file)));
    const blocks = await part.matchMeshes(part.context, part.fittedTogether(reference, template), 6);
    console.log(
      part.document("", [
        { id: "", title: files.map((file) => basename(file)).join(" → "), paper: "", setup: "", blocks },
      ]),
    );
  } catch (problem) {
    throw new Obstacle(problem instanceof Error ? problem.message : String(problem));
  }
}

/** The experiments' modules, compiled by Vite, and the solvers they run on. */
async function load() {
  // Not above: on a fresh clone there is no Vite before the packages are installed.
  const { runnerImport } = await import("vite");
  const module = async (/** @type {string} */ name) =>
    (await runnerImport(join(root, "www", name), { root, configFile: false, logLevel: "error" })).module;
  const { document, OF_CURVES, OF_SURFACES } = /** @type {typeof import("../www/experiments/markdown")} */ (
    await module("experiments/markdown.ts")
  );
  const { EXPERIMENTS } = /** @type {typeof import("../www/experiments/index")} */ (
    await module("experiments/index.ts")
  );
  const { SOLID_EXPERIMENTS } = /** @type {typeof import("../www/experiments/solids/index")} */ (
    await module("experiments/solids/index.ts")
  );
  const polygons = /** @type {typeof import("../www/experiments/polygons")} */ (
    await module("experiments/polygons.ts")
  );
  const truth = /** @type {typeof import("../www/experiments/solids/truth")} */ (
    await module("experiments/solids/truth.ts")
  );
  const files = /** @type {typeof import("../www/space/files")} */ (await module("space/files.ts"));
  /**
   * @param {import("../www/experiments/experiment").Solver} solver
   * @returns {import("../www/experiments/experiment").Context}
   */
  const context = (solver) => ({
    solver,
    millis: () => performance.now(),
    progress: (done, doing) => console.log(`${String(Math.round(100 * done)).padStart(3)} %  ${doing}`),
  });
  const plane = await import("../www/wasm/thinshell.js");
  plane.initSync({ module: readFileSync(join(root, "www", "wasm", "thinshell_bg.wasm")) });
  const space = await import("../www/wasm-solid/thinshell.js");
  space.initSync({ module: readFileSync(join(root, "www", "wasm-solid", "thinshell_bg.wasm")) });
  return {
    curves: {
      ...polygons,
      studies: EXPERIMENTS,
      document,
      head: OF_CURVES,
      file: "paper.md",
      owns: (/** @type {string} */ figure) => !figure.startsWith("surface-"),
      context: context(plane.Registration),
    },
    surfaces: {
      ...truth,
      readSoup: files.readSoup,
      studies: SOLID_EXPERIMENTS,
      document,
      head: OF_SURFACES,
      file: "surfaces.md",
      owns: (/** @type {string} */ figure) => figure.startsWith("surface-"),
      context: context(space.Registration),
    },
  };
}

/**
 * @param {Awaited<ReturnType<typeof load>>["curves"]} experiments
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
 * @param {{ file: string, owns: (figure: string) => boolean }} part
 * @param {string} text
 * @param {{ blocks: import("../www/experiments/experiment").Block[] }[]} chapters
 */
function write({ file, owns }, text, chapters) {
  const docs = join(root, "docs");
  const figures = join(docs, "figures");
  mkdirSync(figures, { recursive: true });
  for (const figure of readdirSync(figures)) if (owns(figure)) rmSync(join(figures, figure));
  writeFileSync(join(docs, file), text);
  for (const block of chapters.flatMap(({ blocks }) => blocks))
    if (block.kind === "figure") writeFileSync(join(figures, `${block.name}.svg`), block.svg);
  console.log(`\ndocs/${file} and its figures are written.`);
}
