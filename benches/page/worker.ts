// One worker, as on the page: times each kernel and posts the medians.

import init, { Kernels } from "../../target/bench-wasm/bench.js";

const BUDGET_MILLIS = 1000;
const LEAST_RUNS = 7;

function median(kernels: Kernels, index: number): number {
  kernels.run(index);
  const times: number[] = [];
  const begin = performance.now();
  while (times.length < LEAST_RUNS || performance.now() - begin < BUDGET_MILLIS) {
    const start = performance.now();
    kernels.run(index);
    times.push(performance.now() - start);
  }
  times.sort((a, b) => a - b);
  return times[times.length >> 1] as number;
}

try {
  await init();
  const kernels = new Kernels();
  const rows = kernels.names().map((name, index) => {
    const millis = median(kernels, index);
    const cells = kernels.cells(index);
    return { name, "median ms": millis, "ns a cell": cells > 1 ? (millis * 1e6) / cells : "" };
  });
  postMessage({ rows });
} catch (error) {
  postMessage({ error: String(error) });
}
