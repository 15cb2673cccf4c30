/** A run's iterations, kept so compactly that all of them can be looked at again. */

/** Level of the kept deformations: what a picture shows of a grid. 33² nodes in single precision are 9 kB. */
export const KEPT_LEVEL = 5;

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
