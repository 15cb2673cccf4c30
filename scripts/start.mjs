// `npm start`: everything from a fresh clone to the running page. `npm run dev` serves the sources instead of the
// build and reloads when they change.

import { buildPage } from "./build.mjs";
import { main, root } from "./lib/process.mjs";
import { checkNode, ensurePackages } from "./lib/setup.mjs";
import { buildGpuWasm, buildSolidWasm, buildWasm } from "./wasm.mjs";

await main(async () => {
  checkNode();
  await ensurePackages();
  // Not above: on a fresh clone there is no Vite before the line before this one.
  const { createServer, preview } = await import("vite");

  let urls;
  if (process.argv.includes("--dev")) {
    await buildWasm();
    await buildSolidWasm();
    await buildGpuWasm();
    const server = await createServer({ root });
    await server.listen();
    urls = server.resolvedUrls;
  } else {
    await buildPage();
    const server = await preview({ root });
    urls = server.resolvedUrls;
  }
  console.log(`\nthinshell is at ${urls?.local[0]} (Ctrl+C ends it)`);
});
