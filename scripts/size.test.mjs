import { expect, test } from "vitest";
import { firstLoad } from "./size.mjs";

const page =
  '<script type="module" src="./assets/index-a.js"></script><link rel="stylesheet" href="./assets/index-b.css">';

/** @param {Record<string, string>} files */
const load = (files) => firstLoad(new Map(Object.entries(files)));

test("what the page names, and what that names, is loaded at first", () => {
  const files = {
    "index.html": page,
    "assets/index-a.js": 'import"./shared-c.js";new Worker(new URL("worker-d.js",import.meta.url),{type:"module"})',
    "assets/index-b.css": "body{background:url(./paper-e.svg)}",
    "assets/shared-c.js": "",
    "assets/worker-d.js": 'const m=new URL("thinshell_bg-f.wasm",import.meta.url)',
    "assets/paper-e.svg": "<svg/>",
    "assets/thinshell_bg-f.wasm": "",
  };
  expect(new Set(load(files))).toEqual(new Set(Object.keys(files)));
});

test("what is imported on demand is not, nor what only that names", () => {
  const files = {
    "index.html": page,
    "assets/index-a.js":
      'const __vite__mapDeps=(i,m=__vite__mapDeps,d=(m.f||(m.f=["./gallery-c.js","./gallery-d.css"])))=>i.map(i=>d[i]);p(()=>import("./gallery-c.js"),__vite__mapDeps([0,1]))',
    "assets/index-b.css": "",
    "assets/gallery-c.js": 'fetch(new URL("leaves-e.json",import.meta.url))',
    "assets/gallery-d.css": "",
    "assets/leaves-e.json": "{}",
  };
  expect(load(files)).toEqual(["index.html", "assets/index-a.js", "assets/index-b.css"]);
});

test("a file that is also imported statically counts, whoever else waits for it", () => {
  const files = {
    "index.html": page,
    "assets/index-a.js": 'import{x}from"./both-c.js";p(()=>import("./both-c.js"))',
    "assets/index-b.css": "",
    "assets/both-c.js": "",
  };
  expect(load(files)).toContain("assets/both-c.js");
});

test("another page is not loaded with this one for being linked", () => {
  const files = {
    "index.html": `${page}<p>See <a class="x" href="./experiments.html">more</a>.</p>`,
    "assets/index-a.js": "",
    "assets/index-b.css": "",
    "experiments.html": '<script type="module" src="./assets/experiments-c.js"></script>',
    "assets/experiments-c.js": "",
  };
  expect(load(files)).toEqual(["index.html", "assets/index-a.js", "assets/index-b.css"]);
});

test("the service worker and what is for installing the page are for later, and so is all that they name", () => {
  const files = {
    "index.html": `${page}<link rel="manifest" href="./manifest.webmanifest" />`,
    "assets/index-a.js": 'navigator.serviceWorker.register("./sw.js");import("./gallery-c.js")',
    "assets/index-b.css": "",
    "assets/gallery-c.js": "",
    "manifest.webmanifest": '{"icons":[{"src":"icon-512.png"}]}',
    "icon-512.png": "",
    "sw.js": "index-a.js gallery-c.js icon-512.png",
  };
  expect(load(files)).toEqual(["index.html", "assets/index-a.js", "assets/index-b.css"]);
});
