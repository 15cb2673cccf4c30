/**
 * The service worker: keeps the whole page in the browser, so that it works without the network after the first visit.
 *
 * The build writes the list of files with the SHA-256 of each into this one (scripts/lib/offline.mjs): another build is
 * another worker. It fetches its files while the version before still serves, checks them, and waits until it is asked to
 * take over or until nobody looks at the old one. One version before is kept: a tab that still shows it finds its parts.
 */

type Ending = Event & { waitUntil(work: Promise<unknown>): void };
type Fetching = Event & { readonly request: Request; respondWith(answer: Promise<Response>): void };
type Telling = Event & { readonly data: unknown };
/** What TypeScript knows of it stands beside the page's types only at the price of both. */
type Scope = {
  readonly registration: { readonly scope: string };
  readonly clients: { claim(): Promise<void> };
  skipWaiting(): Promise<void>;
  addEventListener(type: "install" | "activate", work: (event: Ending) => void): void;
  addEventListener(type: "fetch", work: (event: Fetching) => void): void;
  addEventListener(type: "message", work: (event: Telling) => void): void;
};

const scope = self as unknown as Scope;
const FILES = JSON.parse("__FILES__") as Readonly<Record<string, string>>;

const root = scope.registration.scope;
const PREFIX = `thinshell ${root} `;
const CACHE = `${PREFIX}__VERSION__`;
/** This version's cache, and the last one's for tabs that still show it. */
const KEPT = 2;

scope.addEventListener("install", (event) => event.waitUntil(fill()));
scope.addEventListener("activate", (event) => event.waitUntil(begin()));
scope.addEventListener("message", ({ data }) => {
  if (data === "take over") void scope.skipWaiting();
});
scope.addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method !== "GET" || !request.url.startsWith(root)) return;
  event.respondWith(answer(request));
});

/** One after the other, so that whoever uses the page meanwhile does not notice. What is there stays. */
async function fill(): Promise<void> {
  const cache = await caches.open(CACHE);
  for (const [path, digest] of Object.entries(FILES)) {
    const address = new URL(path, root).href;
    if (await cache.match(address)) continue;
    const known = named(path) ? await caches.match(address) : undefined;
    await cache.put(address, known ?? (await fetched(address, path, digest)));
  }
}

/** Throws when it is not the file that this version was built with: then the next visit tries again. */
async function fetched(address: string, path: string, digest: string): Promise<Response> {
  const response = await fetch(address, { cache: named(path) ? "default" : "no-cache" });
  if (!response.ok) throw new Error(`${path}: ${response.status}`);
  const content = await response.arrayBuffer();
  const found = new Uint8Array(await crypto.subtle.digest("SHA-256", content));
  const hex = Array.from(found, (byte) => byte.toString(16).padStart(2, "0")).join("");
  if (hex !== digest) throw new Error(`${path} is of another version`);
  // A new one: a browser takes no answer to a navigation that came by a redirection.
  return new Response(content, { headers: { "Content-Type": response.headers.get("Content-Type") ?? "" } });
}

/** A file whose name changes with its content is never another. */
function named(path: string): boolean {
  return path.startsWith("assets/");
}

async function begin(): Promise<void> {
  const all = (await caches.keys()).filter((name) => name.startsWith(PREFIX) && name !== CACHE);
  // They come in the order in which they were made.
  for (const name of all.slice(0, Math.max(0, all.length - KEPT + 1))) await caches.delete(name);
  await scope.clients.claim();
}

async function answer(request: Request): Promise<Response> {
  const address = new URL(request.url);
  // Queries and fragments are the page's own affair.
  address.search = "";
  address.hash = "";
  if (address.href === root) address.pathname += "index.html";
  const cache = await caches.open(CACHE);
  const kept = (await cache.match(address.href)) ?? (await caches.match(address.href));
  return kept ?? fetch(request);
}
