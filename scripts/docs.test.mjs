// What the documents point to is there.

import { execFileSync } from "node:child_process";
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { dirname, join, posix } from "node:path";
import { expect, test } from "vitest";
import { root } from "./lib/process.mjs";

const DOCUMENTS = [
  "README.md",
  "CONTRIBUTING.md",
  "CHANGELOG.md",
  ...readdirSync(join(root, "docs"))
    .filter((name) => name.endsWith(".md"))
    .map((name) => `docs/${name}`),
];

/** What is packed, by who packs it. Only what is packed anyway is looked for, so nothing has to be built. */
const PACKAGES = {
  npm: () => {
    const said = execute("npm", ["pack", "--dry-run", "--json", "--ignore-scripts"]);
    return JSON.parse(said)[0].files.map((/** @type {{ path: string }} */ { path }) => path);
  },
  cargo: () => execute("cargo", ["package", "--list", "--allow-dirty"]).trim().split(/\r?\n/),
};

/** @param {string} command @param {string[]} args */
function execute(command, args) {
  return execFileSync(command, args, { cwd: root, encoding: "utf8", shell: process.platform === "win32" });
}

/** They take their time to start. */
const PATIENCE_MILLIS = 60_000;

/** Folders whose files are named in the prose as they lie in the repository. */
const PLACES = /^(src|www|tests|scripts|examples|benches|command|docs|shaders|\.github)\//;

/** Made by commands, or yet to be made. */
const ABSENT = /^www\/wasm(-\w+)?\/|\/yours\./;

/** Links within the repository. @param {string} name */
function linksIn(name) {
  const text = readFileSync(join(root, name), "utf8").replace(/```[\s\S]*?```/g, "");
  return [...text.matchAll(/\]\((?!\w+:)([^)\s]*)\)/g)].map(([, link = ""]) => link);
}

/** @param {string} title as GitHub makes an anchor of it */
function anchor(title) {
  return title
    .trim()
    .toLowerCase()
    .replace(/[^\p{L}\p{N} _-]/gu, "")
    .replaceAll(" ", "-");
}

test.each(DOCUMENTS)("%s: every link within the repository leads somewhere", (name) => {
  const lost = linksIn(name).filter((link) => {
    const [path = "", part] = link.split("#");
    const file = path === "" ? join(root, name) : join(root, dirname(name), path);
    if (!existsSync(file)) return true;
    if (part === undefined) return false;
    const titles = [...readFileSync(file, "utf8").matchAll(/^#+ (.*)$/gm)].map(([, title = ""]) => anchor(title));
    return !titles.includes(part);
  });
  expect(lost).toEqual([]);
});

test.each(Object.entries(PACKAGES))(
  "what the documents that %s packs point to is packed too",
  (_, list) => {
    /** @type {string[]} */
    const packed = list().map((/** @type {string} */ path) => path.replaceAll("\\", "/"));
    const documents = DOCUMENTS.filter((name) => packed.includes(name));
    expect(documents).toContain("README.md");
    const lost = documents.flatMap((name) =>
      linksIn(name)
        .map((link) => posix.join(posix.dirname(name), link.split("#")[0] || posix.basename(name)))
        .filter((path) => !packed.some((file) => file === path || file.startsWith(`${path}/`)))
        .map((path) => `${name}: ${path}`),
    );
    expect(lost).toEqual([]);
  },
  PATIENCE_MILLIS,
);

test.each(DOCUMENTS)("%s: every file that it names is there", (name) => {
  const text = readFileSync(join(root, name), "utf8").replace(/```[\s\S]*?```/g, "");
  const lost = [...text.matchAll(/`([\w./-]+\/[\w./-]*)`/g)]
    .map(([, path = ""]) => path)
    .filter((path) => PLACES.test(path) && !ABSENT.test(path) && !existsSync(join(root, path)));
  expect(lost).toEqual([]);
});

test("the version is the same everywhere", () => {
  const { version } = JSON.parse(readFileSync(join(root, "package.json"), "utf8"));
  const found = (/** @type {string} */ file, /** @type {RegExp} */ pattern) =>
    pattern.exec(readFileSync(join(root, file), "utf8"))?.[1];
  expect(found("Cargo.toml", /^version = "(.*)"/m)).toBe(version);
  expect(found("CITATION.cff", /^version: (.*)$/m)).toBe(version);
  expect(found("CHANGELOG.md", /^## (\d.*)$/m)).toBe(version);
});
