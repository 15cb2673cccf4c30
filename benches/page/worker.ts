// One worker, as on the page: times each kernel and posts the medians.

/** What scripts/bench.mjs builds into target/ just before; other commands must not need it. */
const KERNELS = "/target/bench-wasm/bench.js";

type Kernels = { names(): string[]; cells(index: number): number; run(index: number): void };

const BUDGET_MILLIS = 1000;
const LEAST_RUNS = 7;

/** The clock of a page may tick in tenths of a millisecond: a sample runs a kernel for at least this long. */
const SAMPLE_MILLIS = 20;

function median(kernels: Kernels, index: number): number {
  const sample = (runs: number) => {
    const start = performance.now();
    for (let run = 0; run < runs; run++) kernels.run(index);
    return (performance.now() - start) / runs;
  };
  sample(1);
  const runs = Math.max(1, Math.ceil(SAMPLE_MILLIS / Math.max(sample(3), 0.01)));
  const times: number[] = [];
  const begin = performance.now();
  while (times.length < LEAST_RUNS || performance.now() - begin < BUDGET_MILLIS) times.push(sample(runs));
  times.sort((a, b) => a - b);
  return times[times.length >> 1] as number;
}

try {
  const built = await import(/* @vite-ignore */ KERNELS);
  await built.default();
  const kernels: Kernels = new built.Kernels();
  const rows = kernels.names().map((name, index) => {
    const millis = median(kernels, index);
    const cells = kernels.cells(index);
    const rounded = (value: number, digits: number) => Number(value.toFixed(digits));
    return { name, "median ms": rounded(millis, 3), "ns a cell": cells > 1 ? rounded((millis * 1e6) / cells, 1) : "" };
  });
  postMessage({ rows });
} catch (error) {
  postMessage({ error: String(error) });
}

export {};
