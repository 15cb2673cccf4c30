// Starts the worker that runs the kernels, and leaves its table where scripts/bench.mjs looks for it.

const worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
worker.onmessage = ({ data }) => Reflect.set(window, "__bench", data);
worker.onerror = ({ message }) => Reflect.set(window, "__bench", { error: message });
