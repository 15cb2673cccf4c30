// Settings within their ranges, beyond them, and of wrong types, on grids small enough for thousands of cases.

/** @typedef {import("./random.mjs").Random} Random */
/** @typedef {import("./shapes.mjs").Expected} Expected */

/** @type {Record<string, (random: Random) => unknown>} */
const WITHIN = {
  membrane: (r) => r.between(0.01, 2),
  membraneModel: (r) => r.pick(["intrinsic", "projected"]),
  bending: (r) => r.between(0, 1),
  bendingModel: (r) => r.pick(["shape-operator", "mean-curvature"]),
  thickness: (r) => r.between(0.1, 1),
  penalty: (r) => 10 ** r.between(1, 4),
  volume: (r) => 10 ** r.between(-3, 0),
  interior: (r) => r.between(0.1, 1),
  cutoff: (r) => r.pick(["quartic", "cosine", "bump"]),
  fitRadius: (r) => r.between(1.5, 3),
  vertexShare: (r) => r.between(0.1, 0.9),
  halving: (r) => r.chance(0.5),
  align: (r) => r.pick(["none", "similarity"]),
  minimizer: (r) => r.pick(["newton", "newton", "ncg"]),
  sobolev: (r) => r.between(0.1, 1),
  tolerance: (r) => 10 ** r.between(-8, -2),
  backend: (r) => r.pick(["cpu", "auto"]),
};

/** Fields whose range depends on others, or on the grid. */
const OTHERS = ["lambda", "mu", "bandwidth", "coarsest", "finest", "tangency", "pins", "pinWeight"];

/** @type {((random: Random) => unknown)[]} */
const ODD = [
  (r) => (r.chance(0.5) ? 1 : -1) * 10 ** r.between(-320, 308),
  (r) => r.between(0, 4),
  (r) => r.whole(-3, 40),
  (r) => r.pick([Number.NaN, Infinity, -Infinity, -0, 0, 1e308, 2 ** 53, -1]),
  (r) => r.pick(["", "newton", "none", "0.5", "x".repeat(50_000), "🦉"]),
  (r) => r.pick([null, undefined, true, false, 7n, Symbol("s")]),
  (r) => r.pick([{}, [], [1], () => 1, new Date(0), new Map(), new Float64Array(4), new Proxy({}, {})]),
  () => ({
    valueOf() {
      throw new Error("a value");
    },
  }),
];

/** @param {Random} random @returns {{ name: string, settings: unknown, expected: Expected }} */
export function makeSettings(random) {
  const levels = random.pick([
    { coarsest: 3, finest: 3 },
    { coarsest: 3, finest: 4 },
    { coarsest: 4, finest: 4 },
    { coarsest: 4, finest: 5 },
  ]);
  const kind = random.unit();
  if (kind < 0.35) return { name: "plain", settings: levels, expected: "right" };
  if (kind < 0.7) {
    const chosen = Object.entries(WITHIN).filter(() => random.chance(0.3));
    const settings = Object.fromEntries(chosen.map(([name, value]) => [name, value(random)]));
    return { name: "within", settings: { ...settings, ...levels }, expected: "either" };
  }
  if (kind < 0.93) {
    const names = [...Object.keys(WITHIN), ...OTHERS, "weight", "__proto__", ""];
    const odd = Array.from({ length: random.whole(1, 3) }, () => [random.pick(names), random.pick(ODD)(random)]);
    return { name: "odd", settings: { ...levels, ...Object.fromEntries(odd) }, expected: "either" };
  }
  return { name: "no settings", ...random.pick(POISON)(random) };
}

/** @type {((random: Random) => { settings: unknown, expected: Expected })[]} */
const POISON = [
  (r) => ({
    settings: r.pick([5, "newton", true, [1, 2], Symbol("s"), new Float64Array(3), () => {}]),
    expected: "either",
  }),
  () => {
    const settings = {
      get finest() {
        throw new Error("a getter");
      },
    };
    return { settings, expected: "refused" };
  },
  () => {
    const trap = () => {
      throw new Error("a trap");
    };
    return {
      settings: new Proxy({}, { ownKeys: trap, get: trap, getOwnPropertyDescriptor: trap }),
      expected: "refused",
    };
  },
  () => ({ settings: new Proxy({ finest: 4 }, {}), expected: "right" }),
  // A band as wide as the box: every cell carries the shell.
  () => ({ settings: { finest: 6, coarsest: 6, bandwidth: 1, fitRadius: 4 }, expected: "either" }),
];
