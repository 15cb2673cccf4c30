// The licences of everything that the built page carries: npm packages, crates in the wasm, and Rust's own library.

import { createHash } from "node:crypto";
import { readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { output, root } from "./process.mjs";

/** @typedef {{ name: string, version: string, licence: string, text: string }} Part */

/** Packages that the page carries: their code, or data cut out of them while it is built. */
const CARRIED = [
  "@phosphor-icons/core",
  "@preact/signals",
  "clipper2-ts",
  "gifenc",
  "ogl",
  "preact",
  "svgpath",
  "uplot",
  "world-atlas",
];

const FILE = "licences.html";

const STYLE =
  "html{background:#fffefb;color:#1b2130}a{color:#2f3f9e}body{max-width:50rem;margin:2rem auto;padding:0 1rem;font-family:system-ui;overflow-wrap:anywhere}pre{white-space:pre-wrap}@media(prefers-color-scheme:dark){html{background:#181c24;color:#e7e9ef}a{color:#9fb0ff}}";

/** @returns {Part[]} */
export function parts() {
  return [...packages(CARRIED), ...crates(), STANDARD_LIBRARY];
}

/**
 * The packages of these names, with those that they need in turn.
 *
 * @param {readonly string[]} names
 * @returns {Part[]}
 */
export function packages(names) {
  /** @type {{ packages: Record<string, { version: string, license?: string, dependencies?: Record<string, string> }> }} */
  const lock = JSON.parse(readFileSync(join(root, "package-lock.json"), "utf8"));
  const needed = new Set(names);
  for (const name of needed)
    for (const other of Object.keys(lock.packages[`node_modules/${name}`]?.dependencies ?? {})) needed.add(other);
  return [...needed].sort().map((name) => {
    const path = `node_modules/${name}`;
    const entry = lock.packages[path];
    if (entry === undefined) throw new Error(`package-lock.json has no ${name}: run \`npm install\`.`);
    return { name, version: entry.version, licence: entry.license ?? "", text: textIn(join(root, path), name) };
  });
}

/**
 * Every crate that is linked into one of the modules. What only runs while they are built (macros, build scripts) is in none.
 *
 * @returns {Part[]}
 */
export function crates() {
  // The module for graphics cards has what the others have, and more.
  const built = ["--locked", "--features", "surfaces,gpu"];
  const edges = ["--edges", "normal,no-proc-macro", "--prefix", "none", "--format", "{p}"];
  // Which crates, `tree` knows: `metadata` also has those that only other platforms ask for.
  const tree = asked(["tree", ...built, "--target", "wasm32-unknown-unknown", ...edges]);
  const linked = new Set(tree.split("\n").map((line) => line.split(" ").slice(0, 2).join(" ")));
  /** @type {{ packages: { name: string, version: string, license: string | null, manifest_path: string }[] }} */
  const { packages } = JSON.parse(asked(["metadata", "--format-version", "1", ...built]));
  return packages
    .filter(({ name, version }) => linked.has(`${name} v${version}`))
    .map(({ name, version, license, manifest_path }) => ({
      name,
      version,
      licence: license ?? "",
      text: textIn(dirname(manifest_path), name),
    }))
    .sort((a, b) => a.name.localeCompare(b.name));
}

/** @param {string[]} words what cargo is asked */
function asked(words) {
  const answer = output("cargo", words);
  if (answer === null) throw new Error(`\`cargo ${words.join(" ")}\` failed: the crates' licences cannot be listed.`);
  return answer;
}

/** @param {string} holder */
function mit(holder) {
  return `Copyright (c) ${holder}

Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated
documentation files (the "Software"), to deal in the Software without restriction, including without limitation the
rights to use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and to permit
persons to whom the Software is furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all copies or substantial portions of the
Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE
WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR
COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR
OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.`;
}

/** Of packages that name their licence and bring no file of it. @type {Record<string, string>} */
const TEXTS = {
  ogl: `This is free and unencumbered software released into the public domain.

Anyone is free to copy, modify, publish, use, compile, sell, or distribute this software, either in source code form or
as a compiled binary, for any purpose, commercial or non-commercial, and by any means.

In jurisdictions that recognize copyright laws, the author or authors of this software dedicate any and all copyright
interest in the software to the public domain. We make this dedication for the benefit of the public at large and to the
detriment of our heirs and successors. We intend this dedication to be an overt act of relinquishment in perpetuity of
all present and future rights to this software under copyright law.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE
WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS BE
LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM, OUT
OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.

For more information, please refer to <https://unlicense.org>`,
  // MIT; the author as its Cargo.toml names him.
  profiling: mit("Philip Degarmo"),
};

/**
 * The licence files of a package. Where it may be taken under MIT, that is enough.
 *
 * @param {string} folder
 * @param {string} name
 */
function textIn(folder, name) {
  const files = readdirSync(folder).filter((file) => /^(licen[cs]e|copying|notice|unlicense)/i.test(file));
  const chosen = files.some((file) => /mit/i.test(file)) ? files.filter((file) => !/apache|zlib/i.test(file)) : files;
  if (chosen.length === 0 && name in TEXTS) return TEXTS[name];
  if (chosen.length === 0)
    throw new Error(`${name} brings no licence file: add its text to scripts/lib/licences.mjs, or do without it.`);
  return chosen
    .sort()
    .map((file) => readFileSync(join(folder, file), "utf8").trim())
    .join("\n\n");
}

/** @param {readonly Part[]} all */
export function pageOf(all) {
  const sections = all.map(
    ({ name, version, licence, text }) =>
      `<section><h2>${escaped(`${name} ${version}`)}</h2><p>${escaped(licence)}</p><pre>${escaped(text)}</pre></section>`,
  );
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'sha256-${createHash("sha256").update(STYLE).digest("base64")}'">
<link rel="icon" href="data:,">
<title>thinshell: licences</title>
<style>${STYLE}</style>
</head>
<body>
<main>
<h1>Licences</h1>
<p>What this page is made of, and the terms of each part. <a href="./index.html">Back to the page</a></p>
${sections.join("\n")}
</main>
</body>
</html>
`;
}

/** @param {readonly Part[]} all */
export function textOf(all) {
  return all
    .map(({ name, version, licence, text }) => `${[name, version].filter(Boolean).join(" ")} (${licence})\n\n${text}\n`)
    .join(`\n${"-".repeat(72)}\n\n`);
}

/** @param {string} text */
function escaped(text) {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");
}

/** @typedef {Record<string, { type: string, moduleIds?: string[] }>} Bundle */

/**
 * The packages that have code in the bundle.
 *
 * @param {Bundle} bundle
 * @returns {string[]}
 */
export function bundledIn(bundle) {
  const names = Object.values(bundle)
    .flatMap(({ moduleIds = [] }) => moduleIds)
    .filter((id) => !id.startsWith("\0"))
    .map((id) => id.match(/^.*\/node_modules\/((?:@[^/]+\/)?[^/]+)/)?.[1]);
  return [...new Set(names.filter((name) => name !== undefined))];
}

/**
 * Vite plugins: the page's writes `licences.html`, and refuses to build when a package is bundled that is not in it. The
 * workers are bundled by themselves; theirs only looks.
 *
 * @returns {{ page: import("vite").Plugin, worker: import("vite").Plugin }}
 */
export function licences() {
  /** @type {Set<string>} */
  const bundled = new Set();
  /** @param {Bundle} bundle */
  const look = (bundle) => {
    for (const name of bundledIn(bundle)) bundled.add(name);
  };
  return {
    page: {
      name: "thinshell-licences",
      generateBundle(_, bundle) {
        look(bundle);
        const all = parts();
        const missing = [...bundled].filter((name) => !all.some((part) => part.name === name));
        if (missing.length > 0)
          this.error(`dist would carry ${missing.join(", ")} without a licence: name it in scripts/lib/licences.mjs.`);
        this.emitFile({ type: "asset", fileName: FILE, source: pageOf(all) });
      },
      configureServer(server) {
        server.middlewares.use(`/${FILE}`, (_, response) => {
          response.setHeader("Content-Type", "text/html; charset=utf-8");
          response.end(pageOf(parts()));
        });
      },
    },
    worker: {
      name: "thinshell-licences-of-workers",
      generateBundle: (_, bundle) => look(bundle),
    },
  };
}

/** @type {Part} */
export const STANDARD_LIBRARY = {
  name: "Rust's standard library",
  version: "",
  licence: "MIT OR Apache-2.0",
  text: mit("The Rust Project Contributors"),
};
