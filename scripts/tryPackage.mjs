// `npm test -- package`: what `npm pack` makes, installed in empty folders and used as README.md says: in Node, in a page,
// in a worker, and with Vite, built and while developing. The examples that run are the README's own.

import { spawn, spawnSync } from "node:child_process";
import { once } from "node:events";
import {
  copyFileSync,
  createReadStream,
  mkdirSync,
  readdirSync,
  readFileSync,
  rmSync,
  statSync,
  writeFileSync,
} from "node:fs";
import { createServer } from "node:http";
import { dirname, extname, join } from "node:path";
import { pathToFileURL } from "node:url";
import { gzipSync } from "node:zlib";
import { chromiumFlags, ensureChromium } from "./lib/chromium.mjs";
import { freePort } from "./lib/drivers.mjs";
import { heading, main, Obstacle, root } from "./lib/process.mjs";
import { readland } from "./lib/readland.mjs";

const TRIED = join(root, "target", "tried");
const PATIENCE_MILLIS = 120_000;
/** By how much a documented size may be off before it has to be written anew. */
const ELEMENT_SPREAD = 0.05;

/** @typedef {{ folder: string, open: (address: string) => Promise<string> }} Place */

/** @type {readonly (readonly [string, (place: Place) => Promise<void>])[]} */
const CHECKS = [
  [
    "two polygons are matched in Node",
    async ({ folder }) => {
      write(folder, "match.mjs", example("match.mjs"));
      matched(program(folder, process.execPath, ["match.mjs"]));
    },
  ],
  [
    "two meshes are matched in Node",
    async ({ folder }) => {
      write(folder, "solid.mjs", example("solid.mjs"));
      solid(program(folder, process.execPath, ["solid.mjs"]));
    },
  ],
  [
    "two polygons are matched by the package for graphics cards, which says who computed",
    async ({ folder }) => {
      write(folder, "card.mjs", example("card.mjs"));
      const said = program(folder, process.execPath, ["card.mjs"]);
      expect(said.startsWith("cpu: there is no WebGPU here"), `Node has no graphics card, but this says: ${said}`);
    },
  ],
  [
    "the command line matches 20 silhouettes of the gallery, whatever lies among them",
    async ({ folder }) => {
      const { version } = JSON.parse(read(root, "package.json"));
      expect(program(folder, "npx", ["--offline", "thinshell", "--version"]).trim() === version, "it is not there");
      silhouettes(folder);
      write(folder, "targets/broken.svg", "<svg><path d='M0 0");
      const { status, stdout } = thinshell(folder, ["--outline", "--points", "60"]);
      expect(status === 1, `the end's code is ${status}, though a file could not be read`);
      expect(/^broken\.svg .*The SVG is broken/m.test(stdout), `nothing tells of the broken file:\n${stdout}`);
      const lines = read(folder, "matches/table.csv").trim().split("\n");
      expect(lines.length === 22, `the table has ${lines.length} lines`);
      const fitting = lines.filter((line) => /,"?Fits: [^,]*/.test(line)).length;
      expect(
        stdout.includes(`20 of 21 matched, ${fitting} of them fit; `),
        `the table has ${fitting} that fit:\n${stdout}`,
      );
      const distances = lines.slice(1).map((line) => Number(line.split(",")[4]));
      expect(distances.filter((each) => each > 0.01 && each < 1).length === 20, `the distances are ${distances}`);
      const specimens = readland(read(folder, "matches/semilandmarks.tps"));
      expect(specimens.length === 21, `there are semilandmarks of ${specimens.length} shapes`);
      expect(
        specimens.every(({ points }) => points.length === 60),
        "these are not 60 points each",
      );
      const files = readdirSync(join(folder, "matches")).filter((name) => name.endsWith(".json"));
      expect(files.length === 20, `${files.length} matches are written`);
      const { format, match } = JSON.parse(read(folder, "matches/anchor.json"));
      expect(format === "thinshell" && match.report.finished, "the match of the anchor is no file of the page");
    },
  ],
  [
    "Ctrl-C ends the command line, and what is finished is kept",
    async ({ folder }) => {
      silhouettes(folder);
      rmSync(join(folder, "matches"), { recursive: true, force: true });
      const running = spawn(process.execPath, [COMMAND, ...MATCH], { cwd: folder });
      let printed = "";
      running.stdout.on("data", (text) => {
        printed += text;
      });
      running.stderr.on("data", (text) => {
        // The third line tells that two are done, and the next is under way.
        if (String(text).includes("2/")) running.kill("SIGINT");
      });
      const [code] = await once(running, "close");
      expect(code === 130, `the end's code is ${code}`);
      expect(
        /(\d+) of \1 matched, \d+ of them fit, then cancelled/.test(printed),
        `nothing tells what was finished:\n${printed}`,
      );
      const lines = read(folder, "matches/table.csv").trim().split("\n").length - 1;
      expect(lines >= 2 && lines < 20, `the table has ${lines} matches`);
      const files = readdirSync(join(folder, "matches")).filter((name) => name.endsWith(".json"));
      expect(files.length === lines, `${files.length} matches are written, ${lines} are in the table`);
    },
  ],
  [
    "the types are there for what the examples use",
    async ({ folder }) => {
      write(folder, "typed.ts", TYPED);
      const tsc = join(root, "node_modules", "typescript", "bin", "tsc");
      const strict = ["--noEmit", "--strict", "--module", "nodenext", "--target", "es2022", "--ignoreConfig"];
      program(folder, process.execPath, [tsc, ...strict, "typed.ts"]);
    },
  ],
  [
    "two polygons are matched in a page",
    async ({ folder, open }) => {
      write(folder, "index.html", `${example("index.html")}<link rel="icon" href="data:,">`);
      await serving(folder, async (address) => matched(await open(address)));
    },
  ],
  [
    "two polygons are matched in a worker",
    async ({ folder, open }) => {
      write(folder, "worker.mjs", example("worker.mjs"));
      write(folder, "worker/index.html", `<link rel="icon" href="data:,"><script type="module">${ASKED}</script>`);
      await serving(folder, async (address) => matched(await open(`${address}worker/`)));
    },
  ],
  ["the element matches two polygons with Vite", async (place) => withVite(place, example("element.js"), fits)],
  [
    "the element is as large as docs/element.md says",
    async ({ folder }) => {
      const bytes = readFileSync(join(folder, "node_modules", "thinshell", "lib", "element", "thin-shell-match.js"));
      const said = /\((\d+) kB, (\d+) kB compressed\)/.exec(read(root, "docs/element.md")) ?? [];
      for (const [i, { length }] of [bytes, gzipSync(bytes)].entries()) {
        const kilobytes = length / 1000;
        const off = Math.abs(kilobytes - Number(said[i + 1]));
        expect(
          off < ELEMENT_SPREAD * kilobytes,
          `it has ${kilobytes.toFixed(0)} kB, and is said to have ${said[i + 1]}`,
        );
      }
    },
  ],
  ["two polygons are matched with Vite", async (place) => withVite(place, example("main.js"), fits)],
  [
    "two meshes are matched with Vite",
    async (place) => {
      const named = `import wasm from "thinshell/solid/thinshell_bg.wasm?url";\nawait init({ module_or_path: wasm });`;
      await withVite(place, example("solid.mjs").replace("await init();", named), solid);
    },
  ],
];

/** @returns {Promise<{ passed: number, failed: number }>} */
export async function tryPackage() {
  rmSync(TRIED, { recursive: true, force: true });
  mkdirSync(TRIED, { recursive: true });
  program(root, "npm", ["pack", "--silent", "--pack-destination", TRIED]);
  const { version } = JSON.parse(readFileSync(join(root, "package.json"), "utf8"));
  const folder = join(TRIED, "project");
  write(folder, "package.json", JSON.stringify({ private: true, type: "module" }));
  // It needs no other package, so nothing is to be asked of anybody.
  program(folder, "npm", ["install", "--offline", "--no-audit", "--no-fund", `../thinshell-${version}.tgz`]);

  const { chromium } = await import("@playwright/test");
  const browser = await chromium.launch({ executablePath: await ensureChromium(), args: chromiumFlags() });
  const count = { passed: 0, failed: 0 };
  const open = (/** @type {string} */ address) => firstWords(browser, address);
  try {
    for (const [title, check] of CHECKS) {
      try {
        await check({ folder, open });
        console.log(`  ✓ ${title}`);
        count.passed += 1;
      } catch (error) {
        console.log(`  ✗ ${title}\n    ${error instanceof Error ? error.message : String(error)}`);
        count.failed += 1;
      }
    }
  } finally {
    await browser.close();
  }
  return count;
}

const COMMAND = join("node_modules", "thinshell", "lib", "command.js");
const MATCH = ["match", "heart.svg", "targets", "--set", "finest=5"];

/** @param {string} folder @param {readonly string[]} options */
function thinshell(folder, options) {
  return spawnSync(process.execPath, [COMMAND, ...MATCH, ...options], { cwd: folder, encoding: "utf8" });
}

/** The first twenty of the gallery as files, and its heart. @param {string} folder */
function silhouettes(folder) {
  rmSync(join(folder, "targets"), { recursive: true, force: true });
  mkdirSync(join(folder, "targets"), { recursive: true });
  const gallery = readFileSync(join(root, "www", "gallery", "icons.ts"), "utf8");
  const names = gallery.match(/\{(\w[\w,-]+)\}-fill\.svg/)?.[1]?.split(",") ?? [];
  const icon = (/** @type {string} */ name) =>
    join(root, "node_modules", "@phosphor-icons", "core", "assets", "fill", `${name}-fill.svg`);
  for (const name of names.slice(0, 20)) copyFileSync(icon(name), join(folder, "targets", `${name}.svg`));
  copyFileSync(icon("heart"), join(folder, "heart.svg"));
}

/** @param {string} folder @param {string} name */
function read(folder, name) {
  return readFileSync(join(folder, name), "utf8");
}

const TYPED = `import init, { Registration, type Settings, type Shape, type Status } from "thinshell";
import { SETTINGS } from "thinshell/settings";
import * as card from "thinshell/gpu";
import * as solid from "thinshell/solid";
import widget, { type Report, ThinShellMatch } from "thinshell/element";
const settings: Partial<Settings> = { finest: 5 };
const shape: Shape = { kind: "curves", loops: [] };
export async function once(): Promise<Status> {
  await init();
  return (await Registration.create(shape, shape, settings)).step(1);
}
export const vertices = (made: solid.Registration): Float32Array => made.surfaces().matched.positions;
export const computing = async (made: card.Registration): Promise<string> => (await made.step(1)).backend;
export const element: ThinShellMatch = document.createElement("thin-shell-match");
element.settings = settings;
element.addEventListener("match", ({ detail }) => console.log(detail.verdict satisfies Report["verdict"]));
element.addEventListener("click", ({ clientX }) => console.log(clientX));
export const render: (given: never) => () => void = widget.render;
// @ts-expect-error: there is no such setting
export const wrong: Partial<Settings> = { finesse: 5 };
export default SETTINGS;
`;

/** Asks the README's worker, and says what the README's page says. */
const ASKED = `
  const shape = (...points) => ({ kind: "curves", loops: [Float64Array.from(points)] });
  const worker = new Worker("../worker.mjs", { type: "module" });
  worker.onmessage = ({ data: { status, deformation } }) => console.log(status.stop, status.mismatch.max, deformation);
  worker.postMessage({
    reference: shape(0.4, 0.4, 0.6, 0.4, 0.5, 0.6),
    template: shape(0.35, 0.4, 0.65, 0.4, 0.6, 0.65),
    settings: { finest: 5 },
  });
`;

/**
 * A code block of README.md, by the name that its first line gives it.
 *
 * @param {string} name
 */
function example(name) {
  const text = readFileSync(join(root, "README.md"), "utf8");
  const found = text.split(/(?<=\n)(?=```)/).find((part) => {
    const [, first] = part.split("\n", 2);
    return [`// ${name}`, `<!-- ${name}`].some((begin) => first?.startsWith(begin));
  });
  if (found === undefined) throw new Error(`README.md has no example that begins with its name, ${name}.`);
  return found.replace(/^```\w+\n/, "");
}

/** @param {string} said */
function matched(said) {
  const most = Number(/^[A-Z].*\.\s+([\d.e-]+)\s/.exec(said)?.[1]);
  expect(most < 0.5, `the largest distance is ${most} cells: ${said}`);
}

/** @param {string} said */
function solid(said) {
  const [, least, numbers] = /\.\s+([\d.e-]+)\s+(\d+)\s*$/.exec(said) ?? [];
  expect(Number(least) > 0 && Number(numbers) > 300, `this tells of no surface: ${said}`);
}

/** @param {string} said */
function fits(said) {
  expect(said.startsWith("Fits"), `this tells of no match that fits: ${said}`);
}

/**
 * A project of one script, built and looked at, and looked at while developing: Vite bundles packages differently then.
 *
 * @param {Place} place
 * @param {string} script
 * @param {(said: string) => void} judge
 */
async function withVite({ folder, open }, script, judge) {
  write(folder, "vite/index.html", `<link rel="icon" href="data:,"><script type="module" src="/main.js"></script>`);
  write(folder, "vite/main.js", script);
  const { build, createServer: developing, preview } = await import("vite");
  const project = {
    root: join(folder, "vite"),
    configFile: /** @type {const} */ (false),
    logLevel: /** @type {const} */ ("warn"),
  };
  const port = await freePort();
  await build({ ...project, build: { target: "es2022" } });
  const built = await preview({ ...project, preview: { port, strictPort: true } });
  try {
    judge(await open(`http://localhost:${port}/`));
  } finally {
    await built.close();
  }
  const served = await developing({ ...project, server: { port, strictPort: true, hmr: false, watch: null } });
  try {
    await served.listen();
    judge(await open(`http://localhost:${port}/`));
  } finally {
    await served.close();
  }
}

/**
 * What the page at the address says first in its console; rejects where something goes wrong in it.
 *
 * @param {import("@playwright/test").Browser} browser
 * @param {string} address
 * @returns {Promise<string>}
 */
async function firstWords(browser, address) {
  const page = await browser.newPage();
  try {
    const said = new Promise((resolve, reject) => {
      page.on("console", (message) => {
        if (message.type() === "log") resolve(message.text());
        if (message.type() === "error") reject(new Error(message.text()));
      });
      page.on("pageerror", reject);
      setTimeout(() => reject(new Error(`${address} said nothing`)), PATIENCE_MILLIS).unref();
    });
    await page.goto(address);
    return await said;
  } finally {
    await page.close();
  }
}

const TYPES = {
  ".html": "text/html",
  ".js": "text/javascript",
  ".mjs": "text/javascript",
  ".wasm": "application/wasm",
};

/**
 * A static server for a folder, while something is done with it.
 *
 * @param {string} folder
 * @param {(address: string) => Promise<void>} work
 */
async function serving(folder, work) {
  const server = createServer((request, response) => {
    const { pathname } = new URL(request.url ?? "/", "http://localhost");
    const file = join(folder, pathname.endsWith("/") ? `${pathname}index.html` : pathname);
    if (!statSync(file, { throwIfNoEntry: false })?.isFile()) {
      response.writeHead(404).end();
      return;
    }
    response.setHeader("Content-Type", Reflect.get(TYPES, extname(file)) ?? "application/octet-stream");
    createReadStream(file).pipe(response);
  });
  const port = await freePort();
  await new Promise((resolve) => server.listen(port, () => resolve(undefined)));
  try {
    await work(`http://localhost:${port}/`);
  } finally {
    server.close();
    server.closeAllConnections();
  }
}

/**
 * @param {string} folder
 * @param {string} name
 * @param {string} text
 */
function write(folder, name, text) {
  const file = join(folder, name);
  mkdirSync(dirname(file), { recursive: true });
  writeFileSync(file, text);
}

/**
 * Runs a program and gives what it prints; throws it where it fails.
 *
 * @param {string} folder
 * @param {string} command
 * @param {readonly string[]} args
 */
function program(folder, command, args) {
  const shell = process.platform === "win32" && /^np[mx]$/.test(command);
  const { status, stdout, stderr } = spawnSync(command, args, { cwd: folder, encoding: "utf8", shell });
  if (status !== 0) throw new Error(`\`${[command, ...args].join(" ")}\` failed:\n${stdout}${stderr}`);
  return stdout;
}

/**
 * @param {boolean} holds
 * @param {string} otherwise
 */
function expect(holds, otherwise) {
  if (!holds) throw new Error(otherwise);
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href)
  await main(async () => {
    heading("the package");
    const { failed } = await tryPackage();
    if (failed > 0) throw new Obstacle("The package does not do what README.md says; the list is above.");
  });
