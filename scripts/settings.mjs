// `npm run settings`: writes docs/settings.md from the settings' declarations.

import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { main, root } from "./lib/process.mjs";
import { settingsDocument } from "./lib/settings.mjs";
import { checkNode, ensurePackages } from "./lib/setup.mjs";
import { buildWasm } from "./wasm.mjs";

await main(async () => {
  checkNode();
  await ensurePackages();
  await buildWasm();
  // Not above: before the package is built there is nothing to import.
  const { SETTINGS } = await import(pathToFileURL(join(root, "www", "wasm", "settings.js")).href);
  writeFileSync(join(root, "docs", "settings.md"), settingsDocument(SETTINGS));
  console.log("docs/settings.md is written.");
});
