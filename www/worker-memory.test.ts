// The worker lives as long as the page: a hundred matches must not leave its memory larger than a few do.

import { readFileSync } from "node:fs";
import { expect, test } from "vitest";
import { initSync, Registration } from "./wasm/thinshell.js";

const CIRCLE = loop(128, 0.18, 0.18);
const ELLIPSE = loop(128, 0.28, 0.2);

function loop(count: number, a: number, b: number): Float64Array {
  return Float64Array.from({ length: 2 * count }, (_, k) => {
    const angle = (2 * Math.PI * (k >> 1)) / count;
    return 0.5 + (k % 2 === 0 ? a * Math.cos(angle) : b * Math.sin(angle));
  });
}

async function match(): Promise<void> {
  const curve = (points: Float64Array) => ({ kind: "curves" as const, loops: [points] });
  const registration = await Registration.create(curve(CIRCLE), curve(ELLIPSE), { finest: 5 });
  let status = await registration.step(8);
  while (!status.finished) status = await registration.step(8);
  registration.deformation();
  registration.curves();
  await registration.update({ template: curve(CIRCLE) });
  registration.free();
}

test("a hundred matches leave the memory as five have left it", async () => {
  const { memory } = initSync({ module: readFileSync("www/wasm/thinshell_bg.wasm") });
  for (let run = 0; run < 5; run++) await match();
  const settled = memory.buffer.byteLength;
  for (let run = 0; run < 95; run++) await match();
  expect(memory.buffer.byteLength).toBe(settled);
}, 120_000);
