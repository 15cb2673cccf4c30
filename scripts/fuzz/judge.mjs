// What a right answer is, and what a clear refusal.

/** Words of which a refusal has at least one: what it is about. */
const ABOUT =
  /reference|template|settings|change|update|deformation|points|step|freed|under way|energy|membrane|bending|thickness|penalty|volume|interior|lambda|mu\b|bandwidth|cutoff|fitRadius|vertexShare|coarsest|finest|halving|align|minimizer|sobolev|tolerance|backend|tangency|pins|pinWeight/;
/** Words of the engine and of what lies beneath. */
const ENGINE =
  /unreachable|recursive use|null pointer|aliasing|borrow|RuntimeError|out of bounds|panicked|invalid type|invalid value|unknown variant|unknown field|missing field|expected |is not a function|not iterable|Cannot (read|convert)|undefined is|serde|wasm|\[object/;
const LONGEST = 400;

/** What is unclear about a refusal; null if nothing is. @param {unknown} problem @returns {string | null} */
export function unclear(problem) {
  if (!(problem instanceof Error)) return `no Error but ${typeof problem}`;
  const { name, message } = problem;
  if (name !== "Error") return `a ${name}: ${message}`;
  if (ENGINE.test(message)) return `the engine's words: ${message}`;
  if (!ABOUT.test(message)) return `names nothing: ${message}`;
  if (message.length > LONGEST) return `${message.length} characters: ${message.slice(0, 200)}…`;
  return null;
}

/** @param {boolean} fine @param {string} claim @param {unknown[]} values */
export function demand(fine, claim, ...values) {
  if (!fine) throw new Defect(`${claim}: ${values.map((value) => JSON.stringify(value) ?? String(value)).join(", ")}`);
}

export class Defect extends Error {}

/** @param {any} energies */
function judgeEnergies(energies) {
  const { total, ...terms } = energies;
  const sum = Object.values(terms).reduce((a, b) => a + b, 0);
  demand(Math.abs(sum - total) <= 1e-9 * Math.max(Math.abs(sum), 1e-300), "the energies add up", energies);
  demand(
    Object.values(terms).every((value) => value >= 0),
    "no energy is negative",
    energies,
  );
}

/** Every number in it, at any depth, is finite. @param {unknown} value @param {string} path */
function finite(value, path) {
  if (typeof value === "number") demand(Number.isFinite(value), `${path} is finite`, String(value));
  else if (value !== null && typeof value === "object")
    for (const [key, part] of Object.entries(value)) finite(part, `${path}.${key}`);
}

/** @param {any} status */
export function judgeStatus(status) {
  finite(status, "status");
  judgeEnergies(status.energies);
  demand(status.leastDeterminant > 0, "nothing folds", status.leastDeterminant);
  demand(status.finished === (status.stop !== null), "finished says why", status.finished, status.stop);
  demand(status.stop === null || /^[A-Z].*\.$/s.test(status.stop), "why is a sentence", status.stop);
  demand(status.mismatch.mean <= status.mismatch.max + 1e-9, "a mean is no more than the greatest", status.mismatch);
  demand(status.mismatch.max >= 0 && status.stretch.deviation >= 0, "no size is negative", status);
}

/** The map, its inverse, the curves and the energies agree with the nodes. @param {any} registration @param {any} status */
export function judgeAnswers(registration, status) {
  const deformation = registration.deformation();
  const side = Math.round(Math.sqrt(deformation.length / 2));
  demand(side === 2 ** status.level + 1, "there are as many nodes as the level has", side, status.level);
  demand(deformation.every(Number.isFinite), "the deformation is finite");
  const nodes = Float64Array.from(deformation, (_, k) =>
    k % 2 ? Math.floor(k / 2 / side) / (side - 1) : ((k / 2) % side) / (side - 1),
  );
  demand(farthest(registration.map(nodes), deformation) < 1e-9, "the map is the deformation at the nodes");
  const back = registration.inverseMap(deformation);
  demand(farthest(registration.map(back), deformation) < 1e-9, "the map undoes the inverse");
  // The image of a box that is much inflated may lie over itself: then a point has preimages a cell apart or more.
  const isBack = (/** @type {number} */ _, /** @type {number} */ k) => {
    const away = Math.max(...[k & ~1, k | 1].map((axis) => Math.abs(back[axis] - nodes[axis])));
    return away < 1e-5 || away > 0.5 / (side - 1);
  };
  demand(back.every(isBack), "the inverse undoes the map");
  const away = registration.inverseMap(Float64Array.of(50, 50));
  demand(away.length === 2 && away.every(Number.isNaN), "outside of the image there is no inverse", [...away]);

  const { reference, template, matched } = registration.curves();
  for (const loop of [...reference, ...template, ...matched]) {
    demand(loop.length >= 6 && loop.length % 2 === 0, "a curve has three points or more", loop.length);
    demand(loop.every(Number.isFinite), "curves are finite");
  }
  demand(reference.length > 0 && template.length > 0, "there are curves");
  demand(matched.length === reference.length, "every curve is matched");
  reference.forEach((/** @type {Float64Array} */ loop, /** @type {number} */ k) => {
    demand(farthest(registration.map(loop), matched[k]) < 1e-12, "the matched curve is the map of the reference");
  });

  const evaluation = registration.evaluate(deformation);
  judgeEnergies(evaluation.energies);
  demand(evaluation.gradient.length === deformation.length, "the gradient has the deformation's form");
  demand(evaluation.gradient.every(Number.isFinite), "the gradient is finite");
  demand(evaluation.leastDeterminant > 0, "what does not fold does not fold", evaluation.leastDeterminant);
}

/** @param {Float64Array} a @param {Float64Array} b */
function farthest(a, b) {
  demand(a.length === b.length, "as many numbers come out as go in", a.length, b.length);
  // What is no number stays in the maximum.
  return a.reduce((most, value, k) => Math.max(most, Math.abs(value - b[k])), 0);
}
