/** What is read off moved vertices, or off a deformation of space. x y z a point. */

const MIDDLE = 0.5;

/** The rotation about the vertical axis through the middle, in degrees, that does best in the least squares sense. */
export function turnFound(before: Float64Array, after: Float64Array): number {
  let [cos, sin] = [0, 0];
  for (let k = 0; k < before.length; k += 3) {
    const [x, z] = [before[k] - MIDDLE, before[k + 2] - MIDDLE];
    const [u, w] = [after[k] - MIDDLE, after[k + 2] - MIDDLE];
    cos += x * u + z * w;
    sin += z * u - x * w;
  }
  return (Math.atan2(sin, cos) * 180) / Math.PI;
}

/** How far the points within `reach` of the middle plane across x have moved along x, on average. */
export function shiftFound(before: Float64Array, after: Float64Array, reach: number): number {
  let [sum, count] = [0, 0];
  for (let k = 0; k < before.length; k += 3)
    if (Math.abs(before[k] - MIDDLE) < reach) {
      sum += after[k] - before[k];
      count += 1;
    }
  return sum / count;
}

/** Mean and largest distance of points from those of the same number. */
export function errors(points: Float64Array, truth: Float64Array): { readonly mean: number; readonly max: number } {
  let [sum, max] = [0, 0];
  for (let k = 0; k < points.length; k += 3) {
    const error = Math.hypot(points[k] - truth[k], points[k + 1] - truth[k + 1], points[k + 2] - truth[k + 2]);
    sum += error;
    max = Math.max(max, error);
  }
  return { mean: (3 * sum) / points.length, max };
}

/** Points and weights of the Gauss rule of order 5 on [0,1]. */
const GAUSS: readonly (readonly [number, number])[] = [
  [0.5 - Math.sqrt(0.15), 5 / 18],
  [0.5, 8 / 18],
  [0.5 + Math.sqrt(0.15), 5 / 18],
];

/**
 * Mean and standard deviation of the area ratio |cof Dφ n| over the layer | |x − c| − radius | < h around the box's
 * middle c, by volume; n is the spheres' normal at x. Three Gauss points an axis in every cell, those inside counted.
 */
export function layerRatio(
  level: number,
  deformation: Float64Array,
  radius: number,
): { readonly mean: number; readonly deviation: number } {
  const side = 2 ** level + 1;
  const h = 1 / (side - 1);
  let [weight, sum, square] = [0, 0, 0];
  const reach = radius + 3 * h;
  const [first, last] = [Math.floor((MIDDLE - reach) / h), Math.ceil((MIDDLE + reach) / h)];
  for (let k = first; k < last; k += 1)
    for (let j = first; j < last; j += 1)
      for (let i = first; i < last; i += 1) {
        const middle = Math.hypot((i + 0.5) * h - MIDDLE, (j + 0.5) * h - MIDDLE, (k + 0.5) * h - MIDDLE);
        if (Math.abs(middle - radius) > 2 * h) continue;
        for (const [w, weightZ] of GAUSS)
          for (const [v, weightY] of GAUSS)
            for (const [u, weightX] of GAUSS) {
              const x = [(i + u) * h - MIDDLE, (j + v) * h - MIDDLE, (k + w) * h - MIDDLE];
              const distance = Math.hypot(...x);
              if (Math.abs(distance - radius) >= h) continue;
              const ratio = areaRatio(
                jacobian(deformation, side, [i, j, k], [u, v, w]),
                x.map((at) => at / distance),
              );
              const share = weightX * weightY * weightZ;
              weight += share;
              sum += share * ratio;
              square += share * ratio ** 2;
            }
      }
  const mean = sum / weight;
  return { mean, deviation: Math.sqrt(square / weight - mean * mean) };
}

/** The columns ∂φ/∂x, ∂φ/∂y, ∂φ/∂z at a place of a cell. */
function jacobian(deformation: Float64Array, side: number, cell: readonly number[], place: readonly number[]) {
  const columns = [0, 1, 2].map(() => [0, 0, 0]);
  for (let corner = 0; corner < 8; corner += 1) {
    const bits = [corner & 1, (corner >> 1) & 1, corner >> 2];
    const node = (((cell[2] + bits[2]) * side + cell[1] + bits[1]) * side + cell[0] + bits[0]) * 3;
    for (let axis = 0; axis < 3; axis += 1) {
      let slope = (bits[axis] === 1 ? 1 : -1) * (side - 1);
      for (let other = 0; other < 3; other += 1)
        if (other !== axis) slope *= bits[other] === 1 ? place[other] : 1 - place[other];
      for (let k = 0; k < 3; k += 1) columns[axis][k] += slope * deformation[node + k];
    }
  }
  return columns;
}

/** |cof A n|: cof A has the products of the other two columns as its own. */
function areaRatio([a, b, c]: readonly number[][], n: readonly number[]): number {
  const cross = (p: readonly number[], q: readonly number[]) =>
    [0, 1, 2].map((k) => p[(k + 1) % 3] * q[(k + 2) % 3] - p[(k + 2) % 3] * q[(k + 1) % 3]);
  const [u, v, w] = [cross(b, c), cross(c, a), cross(a, b)];
  return Math.hypot(...[0, 1, 2].map((k) => u[k] * n[0] + v[k] * n[1] + w[k] * n[2]));
}
