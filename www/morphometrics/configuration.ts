/** Configurations of corresponding points, x y x y …: their size, and how far two of them differ in shape. */

/** The root of the summed squared distances to their centre. Units: length. */
export function centroidSize(points: Float64Array): number {
  const [x, y] = centre(points);
  let sum = 0;
  for (let i = 0; i < points.length; i += 2) sum += (points[i] - x) ** 2 + (points[i + 1] - y) ** 2;
  return Math.sqrt(sum);
}

/**
 * The (partial) Procrustes distance: that of both at centroid size 1 with a common centre, turned onto each other as well
 * as can be. With the points as complex numbers z, w it is √(2 − 2 |Σ z̄ₖ wₖ|). No reflection. 0 for one shape, at most √2.
 */
export function procrustesDistance(a: Float64Array, b: Float64Array): number {
  const [z, w] = [normal(a), normal(b)];
  let [real, imaginary] = [0, 0];
  for (let i = 0; i < z.length; i += 2) {
    real += z[i] * w[i] + z[i + 1] * w[i + 1];
    imaginary += z[i] * w[i + 1] - z[i + 1] * w[i];
  }
  // Turned by that angle and subtracted: exact near 0, where 2 − 2 |…| has lost its digits.
  const size = Math.hypot(real, imaginary);
  const [cos, sin] = size > 0 ? [real / size, imaginary / size] : [1, 0];
  let sum = 0;
  for (let i = 0; i < z.length; i += 2) {
    sum += (cos * z[i] - sin * z[i + 1] - w[i]) ** 2 + (sin * z[i] + cos * z[i + 1] - w[i + 1]) ** 2;
  }
  return Math.sqrt(sum);
}

function normal(points: Float64Array): Float64Array {
  const [x, y] = centre(points);
  const size = centroidSize(points);
  return points.map((value, i) => (value - (i % 2 === 0 ? x : y)) / size);
}

function centre(points: Float64Array): readonly [number, number] {
  const count = points.length / 2;
  let [x, y] = [0, 0];
  for (let i = 0; i < points.length; i += 2) {
    x += points[i] / count;
    y += points[i + 1] / count;
  }
  return [x, y];
}
