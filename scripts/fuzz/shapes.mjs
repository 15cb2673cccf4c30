// Shapes of all kinds, good and bad. Every maker says what must become of its shape: "right" if it must be taken,
// "refused" if it must not, "either" where that depends on grid and settings.

/** @typedef {import("./random.mjs").Random} Random */
/** @typedef {"right" | "refused" | "either"} Expected */
/** @typedef {{ name: string, shape: unknown, expected: Expected }} Made */

/** @param {Random} random @returns {Made} */
export function makeShape(random) {
  const kind = random.unit();
  if (kind < 0.3) return goodCurve(random);
  if (kind < 0.55) return random.pick(oddCurves)(random);
  if (kind < 0.72) return random.pick(levelSets)(random);
  if (kind < 0.86) return random.pick(masks)(random);
  return random.pick(poison)(random);
}

/** @param {Random} random @returns {Made} */
export function goodCurve(random) {
  // Two cells of the coarsest of all grids are a quarter of the box.
  const [x, y, a, b] = [random.between(0.49, 0.51), random.between(0.49, 0.51), radius(random), radius(random)];
  const [tips, depth, turn] = [
    random.whole(2, 6),
    random.chance(0.5) ? 0 : random.between(0, 0.2),
    random.between(0, 7),
  ];
  const loop = polar(random.whole(24, 200), (t) => {
    const r = 1 + depth * Math.cos(tips * t);
    return [x + a * r * Math.cos(t + turn), y + b * r * Math.sin(t + turn)];
  });
  return made("smooth curve", curves([loop]), "right");
}

/** @param {Random} random */
const radius = (random) => random.between(0.14, 0.19);

/** @param {number} count @param {(t: number) => number[]} at */
const polar = (count, at) =>
  Float64Array.from(Array.from({ length: count }, (_, k) => at((2 * Math.PI * k) / count)).flat());

/** @param {unknown} loops */
const curves = (loops) => ({ kind: "curves", loops });

/** @param {string} name @param {unknown} shape @param {Expected} expected @returns {Made} */
const made = (name, shape, expected) => ({ name, shape, expected });

/** @param {Random} random @param {number} count @param {number} low @param {number} high */
const points = (random, count, low, high) => Float64Array.from({ length: 2 * count }, () => random.between(low, high));

/** @param {Random} random @param {number} [size] */
function circle(random, size = radius(random)) {
  const [x, y] = [random.between(0.4, 0.6), random.between(0.4, 0.6)];
  return polar(random.whole(3, 60), (t) => [x + size * Math.cos(t), y + size * Math.sin(t)]);
}

/** @type {((random: Random) => Made)[]} */
const oddCurves = [
  (r) => made("random polygon", curves([points(r, r.whole(3, 40), 0.2, 0.8)]), "either"),
  (r) =>
    made("random polygons", curves(Array.from({ length: r.whole(2, 5) }, () => points(r, 4, 0.25, 0.75))), "either"),
  (r) => {
    const lattice = Float64Array.from({ length: 2 * r.whole(3, 20) }, () => r.whole(3, 7) / 10);
    return made("lattice polygon", curves([lattice]), "either");
  },
  (r) => {
    const loop = circle(r);
    const doubled = Float64Array.from(
      [...loop].flatMap((_, k) => (k % 2 ? [] : [loop[k], loop[k + 1], loop[k], loop[k + 1]])),
    );
    return made("repeated points", curves([doubled]), "either");
  },
  (r) => {
    const [x, y, dx, dy] = [r.between(0.3, 0.4), r.between(0.3, 0.4), r.between(-0.1, 0.3), r.between(0.1, 0.3)];
    const at = Array.from({ length: r.whole(3, 9) }, () => r.unit());
    return made("collinear points", curves([Float64Array.from(at.flatMap((t) => [x + t * dx, y + t * dy]))]), "either");
  },
  (r) => made("tiny", curves([circle(r, 10 ** r.between(-14, -1.5))]), "either"),
  (r) => made("huge", curves([circle(r, 10 ** r.between(0, 300))]), "refused"),
  (r) => {
    const loop = circle(r);
    loop[r.whole(0, loop.length - 1)] = r.pick([Number.NaN, Infinity, -Infinity]);
    return made("not finite", curves([loop]), "refused");
  },
  (r) => {
    const edge = r.pick([0, 1e-9, 0.02, 0.05, -0.01]);
    return made("at the border", curves([Float64Array.of(edge, 0.3, 0.6, 0.3, 0.6, 0.7, edge, 0.7)]), "either");
  },
  (r) => made("nested", curves(Array.from({ length: r.whole(2, 6) }, (_, k) => circle(r, 0.3 - 0.05 * k))), "either"),
  (r) => {
    const loop = circle(r);
    return made("equal loops", curves(Array.from({ length: r.whole(2, 50) }, () => loop.slice())), "either");
  },
  (r) => {
    const [y, w] = [r.pick([0.5, 0.46875, r.between(0.3, 0.7)]), 10 ** r.between(-17, -1.5)];
    return made("sliver", curves([Float64Array.of(0.3, y - w, 0.7, y - w, 0.7, y + w, 0.3, y + w)]), "either");
  },
  (r) => {
    const width = 10 ** r.between(-4, -1);
    const [outer, inner] = [0.25, 0.25 - width].map((s) =>
      polar(64, (t) => [0.5 + s * Math.cos(t), 0.5 + s * Math.sin(t)]),
    );
    return made("thin ring", curves([outer, inner]), "either");
  },
  (r) => {
    const teeth = r.whole(3, 60);
    const up = Array.from({ length: 2 * teeth }, (_, k) => [0.3 + (0.4 * k) / (2 * teeth), k % 2 ? 0.7 : 0.4]);
    return made("comb", curves([Float64Array.from([...up, [0.7, 0.3], [0.3, 0.3]].flat())]), "either");
  },
];

/** @param {Random} random @param {number} cells @param {(x: number, y: number) => number} at */
function nodal(random, cells, at) {
  const values = Float64Array.from({ length: (cells + 1) ** 2 }, (_, k) =>
    at((k % (cells + 1)) / cells, Math.floor(k / (cells + 1)) / cells),
  );
  return { kind: "levelSet", cells, dim: 2, values, redistance: random.chance(0.5) };
}

/** @param {Random} random */
function disc(random) {
  const [x0, y0, r] = [random.between(0.49, 0.51), random.between(0.49, 0.51), radius(random)];
  return (/** @type {number} */ x, /** @type {number} */ y) => Math.hypot(x - x0, y - y0) - r;
}

/** @type {((random: Random) => Made)[]} */
const levelSets = [
  (r) => made("disc level set", nodal(r, r.pick([16, 32, 64]), disc(r)), "right"),
  (r) => {
    const at = disc(r);
    const scale = 10 ** r.between(-320, 308);
    const shape = nodal(r, 32, (x, y) => scale * at(x, y));
    return made("scaled level set", shape, "either");
  },
  (r) => {
    const at = disc(r);
    return made(
      "noisy level set",
      nodal(r, 32, (x, y) => at(x, y) + r.between(-0.1, 0.1)),
      "either",
    );
  },
  (r) =>
    made(
      "noise level set",
      nodal(r, r.pick([4, 8, 16, 32]), () => r.between(-1, 1)),
      "either",
    ),
  (r) => {
    const at = disc(r);
    return made(
      "steps",
      nodal(r, 32, (x, y) => Math.sign(at(x, y)) * r.pick([1, 1, 0, -0])),
      "either",
    );
  },
  (r) =>
    made(
      "flat level set",
      nodal(r, 16, () => r.pick([0, -0, 1, -1])),
      "either",
    ),
  (r) =>
    made(
      "constant level set",
      { ...nodal(r, 16, () => 0), values: new Float64Array(289).fill(r.pick([0, -1, 1])) },
      "refused",
    ),
  (r) =>
    made(
      "one node level set",
      nodal(r, 16, (x, y) => (x === 0.5 && y === 0.5 ? -(10 ** r.between(-300, 0)) : 1)),
      "either",
    ),
  (r) => {
    const shape = nodal(r, 32, disc(r));
    shape.values[r.whole(0, shape.values.length - 1)] = r.pick([Number.NaN, Infinity, -Infinity]);
    return made("level set not finite", shape, "refused");
  },
  (r) => {
    const shape = nodal(r, 32, disc(r));
    return made("level set of a wrong length", { ...shape, values: shape.values.slice(r.whole(1, 1000)) }, "refused");
  },
  (r) => {
    const cells = r.pick([0, 1, 2, 12, 33, -4, 1.5, Number.NaN, 2 ** 31, 1e300, "32", null]);
    return made("level set of wrong cells", { ...nodal(r, 32, disc(r)), cells }, "refused");
  },
  (r) =>
    made("level set of wrong dim", { ...nodal(r, 32, disc(r)), dim: r.pick([0, 1, 3, 4, "2", Number.NaN]) }, "refused"),
  (r) =>
    made(
      "level set with a hint",
      { ...nodal(r, 32, disc(r)), redistance: r.pick([1, "true", null, undefined]) },
      "refused",
    ),
  (r) =>
    made(
      "level set at the border",
      nodal(r, 16, (x) => x - 0.5),
      "refused",
    ),
];

/** @param {number} width @param {number} height @param {(column: number, row: number) => number} at */
function pixels(width, height, at) {
  const data = Uint8Array.from({ length: width * height }, (_, k) => at(k % width, Math.floor(k / width)));
  return { kind: "mask", width, height, data };
}

/** @param {Random} random */
function blob(random) {
  const [width, height] = [random.whole(30, 120), random.whole(30, 120)];
  const r = 0.3 * Math.min(width, height);
  return pixels(width, height, (x, y) => (Math.hypot(x - width / 2, y - height / 2) < r ? 255 : 0));
}

/** @type {((random: Random) => Made)[]} */
const masks = [
  (r) => {
    const size = r.whole(40, 100);
    const shape = pixels(size, size, (x, y) => (Math.hypot(x - size / 2, y - size / 2) < 0.2 * size ? 255 : 0));
    return made("disc mask", shape, "right");
  },
  (r) => made("blob mask", blob(r), "either"),
  (r) =>
    made(
      "empty mask",
      pixels(r.whole(1, 50), r.whole(1, 50), () => r.whole(0, 127)),
      "refused",
    ),
  (r) =>
    made(
      "full mask",
      pixels(r.whole(1, 50), r.whole(1, 50), () => 255),
      "refused",
    ),
  (r) => {
    const [size, x0, y0] = [r.whole(3, 200), r.whole(0, 199), r.whole(0, 199)];
    return made(
      "one pixel",
      pixels(size, size, (x, y) => (x === x0 % size && y === y0 % size ? 255 : 0)),
      "either",
    );
  },
  (r) => {
    const [size, share] = [r.whole(10, 120), r.unit()];
    const inner = (/** @type {number} */ x) => x > 0.2 * size && x < 0.8 * size;
    return made(
      "noise mask",
      pixels(size, size, (x, y) => (inner(x) && inner(y) && r.chance(share) ? 255 : 0)),
      "either",
    );
  },
  (r) =>
    made(
      "grey mask",
      pixels(40, 40, () => r.whole(100, 150)),
      "either",
    ),
  (r) =>
    made(
      "mask of wrong size",
      { ...blob(r), width: r.pick([-1, 1.5, 1e9, Number.NaN, 7, "40", 0, 2 ** 53]) },
      "refused",
    ),
  (r) =>
    made(
      "mask of wrong data",
      { ...blob(r), data: r.pick([null, [1, 2], new Uint8ClampedArray(4), new Float64Array(4), "x"]) },
      "refused",
    ),
  () =>
    made(
      "mask of nothing",
      pixels(0, 0, () => 0),
      "refused",
    ),
];

const thrower = {
  get() {
    throw new TypeError("a trap");
  },
};

/** @type {((random: Random) => Made)[]} */
const poison = [
  (r) => made("no shape", r.pick([null, undefined, 5, "curves", true, Symbol("x"), () => {}, [], {}]), "refused"),
  (r) => made("unknown kind", { kind: r.pick(["blob", "x".repeat(100_000), 3, null, {}]) }, "refused"),
  (r) => made("mesh", { kind: "mesh", positions: points(r, 6, 0, 1), indices: new Uint32Array(12) }, "refused"),
  (r) =>
    made(
      "no loops",
      curves(r.pick([undefined, null, [], 7, "loops", {}, { length: 3 }, [null], [[0.1, 0.2]]])),
      "refused",
    ),
  (r) => made("short loops", curves([points(r, r.whole(0, 2), 0.3, 0.7)]), "refused"),
  (r) => made("odd loop", curves([points(r, 4, 0.3, 0.7).slice(1)]), "refused"),
  (r) =>
    made(
      "other numbers",
      curves([r.pick([new Float32Array(8), new Int8Array(8), new ArrayBuffer(64), "0.1 0.2"])]),
      "refused",
    ),
  () => made("proxy that throws", new Proxy({}, thrower), "refused"),
  () => made("loops that throw", curves(new Proxy([], thrower)), "refused"),
  (r) => made("proxied numbers", curves([new Proxy(circle(r), {})]), "refused"),
  () => {
    const shape = {
      kind: "curves",
      get loops() {
        throw new Error("a getter");
      },
    };
    return made("getter that throws", shape, "refused");
  },
  () => {
    const { proxy, revoke } = Proxy.revocable([], {});
    revoke();
    return made("revoked loops", curves(proxy), "refused");
  },
  (r) => {
    const loop = circle(r);
    structuredClone(loop.buffer, { transfer: [loop.buffer] });
    return made("transferred loop", curves([loop]), "refused");
  },
  (r) => {
    class Liar extends Float64Array {
      /** @override @returns {number} */
      get length() {
        throw new Error("a length");
      }
    }
    return made("loop without a length", curves([Liar.from(circle(r))]), "either");
  },
  (r) => {
    const loops = [circle(r)];
    Object.defineProperty(loops, 1, { get: () => r.pick([undefined, circle(r)]), enumerable: true });
    return made("loops by getter", curves(loops), "either");
  },
  (r) => made("proxied curve", new Proxy(curves([circle(r, 0.2)]), {}), "either"),
];
