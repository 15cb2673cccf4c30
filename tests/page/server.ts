/** A plain static server of a built page, at a port of its own. */

import { createReadStream, existsSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";

const TYPES: Record<string, string> = {
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript",
  ".css": "text/css",
  ".wasm": "application/wasm",
  ".svg": "image/svg+xml",
  ".png": "image/png",
  ".webmanifest": "application/manifest+json",
};

export type Server = {
  readonly address: string;
  /** Serves another folder from now on. */
  serve(folder: string): void;
  close(): void;
};

/** Under `path`, which begins and ends by a slash. */
export async function serving(folder: string, path = "/"): Promise<Server> {
  let from = folder;
  const server = createServer((request, response) => {
    const asked = normalize(decodeURIComponent(new URL(request.url ?? "/", "http://localhost").pathname));
    const found = join(from, asked.slice(path.length - 1).replace(/\/$/, "/index.html"));
    if (!asked.startsWith(path) || !existsSync(found) || !statSync(found).isFile()) {
      response.writeHead(404).end();
      return;
    }
    response.setHeader("Content-Type", TYPES[extname(found)] ?? "application/octet-stream");
    createReadStream(found).pipe(response);
  });
  await new Promise<void>((resolve) => server.listen(0, resolve));
  const address = server.address();
  if (address === null || typeof address === "string") throw new Error("a listening server has a port");
  return {
    address: `http://localhost:${address.port}${path}`,
    serve: (folder) => {
      from = folder;
    },
    close: () => {
      server.closeAllConnections();
      server.close();
    },
  };
}
