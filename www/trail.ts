/** A run's iterations, kept so compactly that all of them can be looked at again. */

/** Level of the kept deformations: what a picture shows of a grid. 33² nodes in single precision are 9 kB. */
export const KEPT_LEVEL = 5;

/** Iterations of which all are kept; of those after them, that take small steps, every so manieth. */
const ALL = 1000;
const EVERY = 10;

/** Whether the n-th iteration of a run, from 0, is kept: a run of ten thousand has 16 MB. */
export function isKept(n: number): boolean {
  return n < ALL || n % EVERY === 0;
}

/** Every so manieth node of φ, at most those of the kept level. x y a node, x fastest. */
export function kept(deformation: Float64Array, level: number): Float32Array {
  const stride = 2 ** Math.max(0, level - KEPT_LEVEL);
  const from = 2 ** level + 1;
  const side = 2 ** Math.min(level, KEPT_LEVEL) + 1;
  const out = new Float32Array(2 * side * side);
  for (let j = 0; j < side; j += 1) {
    for (let i = 0; i < side; i += 1) {
      const node = 2 * stride * (j * from + i);
      out[2 * (j * side + i)] = deformation[node];
      out[2 * (j * side + i) + 1] = deformation[node + 1];
    }
  }
  return out;
}
