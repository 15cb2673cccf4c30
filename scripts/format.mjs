// `npm run format`: rustfmt and Biome, writing what they find.

import { main, must, root } from "./lib/process.mjs";
import { checkNode, ensurePackages, ensureRust } from "./lib/setup.mjs";

await main(async () => {
  checkNode();
  await ensurePackages();
  await ensureRust({ lints: true });
  await must("cargo", ["fmt"]);
  await must(process.execPath, [`${root}/node_modules/@biomejs/biome/bin/biome`, "check", "--write"]);
});
