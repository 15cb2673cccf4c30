import { describe, expect, test } from "vitest";
import { keyed, lensOf, orbited, panned, projected, rayThrough, START, sight, spoken, zoomed } from "./camera";
import { colours } from "./colours";
import { PAIRS, SURFACES, surface } from "./gallery";
import { decode, encode } from "./link";
import { nearest } from "./measure";
import { picked, pointOf } from "./pick";
import { FIRST_LOOK } from "./session";
import { cut, gridLines } from "./slice";
import { areaRatios, normals, type Solid, volume } from "./solid";

const all = SURFACES.map(({ id }) => [id, made(id)] as const);

function made(id: string): Solid {
  const solid = surface(id);
  if (!solid) throw new Error(`no ${id}`);
  return solid;
}

describe("the gallery", () => {
  test("holds at least eight surfaces, and pairs of them", () => {
    expect(SURFACES.length).toBeGreaterThanOrEqual(8);
    expect(PAIRS.length).toBeGreaterThanOrEqual(8);
    for (const { reference, template } of PAIRS) expect([surface(reference), surface(template)]).not.toContain(null);
    expect(surface("klein")).toBeNull();
  });

  test.each(all)("%s is closed, outward, and well inside the box", (_, { positions, indices }) => {
    expect(volume(positions, indices)).toBeGreaterThan(0.002);
    expect(Math.min(...positions)).toBeGreaterThan(0.1);
    expect(Math.max(...positions)).toBeLessThan(0.9);
    // Each edge is passed once in either direction.
    const edges = new Set<number>();
    const vertices = positions.length / 3;
    for (let k = 0; k < indices.length; k += 1) {
      const next = k % 3 === 2 ? k - 2 : k + 1;
      edges.add(indices[k] * vertices + indices[next]);
    }
    expect(edges.size).toBe(indices.length);
    const isSingle = (edge: number) => !edges.has((edge % vertices) * vertices + Math.floor(edge / vertices));
    expect([...edges].filter(isSingle)).toEqual([]);
  });

  test.each([
    ["octahedron", "octahedron-turned"],
    ["bar", "bar-twisted"],
    ["bar", "bar-bent"],
    ["torus", "torus-bent"],
  ])("%s and %s have the same numbering", (one, other) => {
    expect(made(other).indices).toEqual(made(one).indices);
  });

  test("an unduloid has constant mean curvature between its caps", () => {
    const { positions } = made("unduloid");
    // Rings of 48 vertices between the poles; caps of 16 rings at either end, without the pole 15.
    const corners = 48;
    const rings = (positions.length / 3 - 2) / corners;
    const profile = Array.from({ length: rings }, (_, ring) => {
      const at = 3 * (1 + ring * corners);
      return [positions[at], Math.hypot(positions[at + 1] - 0.5, positions[at + 2] - 0.5)];
    }).slice(15, -15);
    const curvatures = profile.slice(2, -2).map((_, i) => {
      const [[x0, r0], [x1, r1], [x2, r2]] = profile.slice(i + 1, i + 4);
      const [before, after] = [(r1 - r0) / (x1 - x0), (r2 - r1) / (x2 - x1)];
      const [slope, bend] = [(r2 - r0) / (x2 - x0), (2 * (after - before)) / (x2 - x0)];
      return (1 / (r1 * Math.sqrt(1 + slope ** 2)) - bend / (1 + slope ** 2) ** 1.5) / 2;
    });
    const mean = curvatures.reduce((sum, value) => sum + value) / curvatures.length;
    for (const curvature of curvatures) expect(Math.abs(curvature / mean - 1)).toBeLessThan(0.01);
  });
});

test("normals of a sphere point away from its middle", () => {
  const { positions, indices } = made("sphere");
  const all = normals(positions, indices);
  for (let k = 0; k < all.length; k += 3) {
    const along = [0, 1, 2].reduce((sum, i) => sum + all[k + i] * (positions[k + i] - 0.5), 0);
    expect(along).toBeCloseTo(0.24, 3);
  }
});

test("areas grow with the square of lengths", () => {
  const { positions, indices } = made("bumpy");
  const ratios = areaRatios(
    positions,
    positions.map((at) => 3 * at),
    indices,
  );
  for (const ratio of ratios) expect(ratio).toBeCloseTo(9, 6);
});

test("the distance to a sphere is that to its radius, near and far", () => {
  const points = [0.5, 0.5, 0.5, 0.5, 0.9, 0.5, 1.4, 0.5, 0.5, 0.5, 0.5, 0.27];
  const { distances, vertices } = nearest(points, made("sphere"));
  for (const [i, expected] of [0.24, 0.16, 0.66, 0.01].entries()) expect(distances[i]).toBeCloseTo(expected, 2);
  const far = made("sphere").positions.subarray(3 * vertices[2], 3 * vertices[2] + 3);
  expect(far[0]).toBeGreaterThan(0.72);
});

test("a vertex of the surface has no distance to it and is its own partner", () => {
  const { positions, indices } = made("torus");
  const { distances, vertices } = nearest(positions, { positions, indices });
  expect(Math.max(...distances)).toBeLessThan(1e-12);
  expect([...vertices]).toEqual(Array.from({ length: positions.length / 3 }, (_, k) => k));
});

test("equal places have equal colours, and what has no partner is grey", () => {
  const [a, b, none] = [
    [0.2, 0.3, 0.4],
    [0.2, 0.3, 0.41],
    [Number.NaN, 0, 0],
  ].map((place) => [...colours(place)]);
  expect([...colours([0.2, 0.3, 0.4])]).toEqual(a);
  expect(b).not.toEqual(a);
  expect(none).toEqual([0.5, 0.5, 0.5]);
});

describe("a slice", () => {
  const level = 3;
  const side = 9;
  const doubled = Float64Array.from({ length: 3 * side ** 3 }, (_, k) => {
    const node = Math.floor(k / 3);
    return [(2 * (node % side)) / 8, (2 * (Math.floor(node / side) % side)) / 8, (2 * Math.floor(node / 81)) / 8][
      k % 3
    ];
  });

  test.each([0, 1, 2])("across axis %i shows the plane where the deformation takes it", (axis) => {
    const { from, to } = gridLines(level, doubled, { axis, part: 0.3 });
    expect(from.length).toBe(2 * 3 * 2 * 9 * 8);
    for (let k = 0; k < from.length; k += 1) {
      if (k % 3 === axis) expect(from[k]).toBeCloseTo(0.3, 6);
      expect(to[k]).toBeCloseTo(2 * from[k], 6);
    }
  });

  test("cuts a circle out of a sphere", () => {
    const { positions, indices } = made("sphere");
    const { from } = cut(positions, positions, indices, { axis: 2, part: 0.5 + 0.12 });
    expect(from.length).toBeGreaterThan(300);
    const radius = Math.sqrt(0.24 ** 2 - 0.12 ** 2);
    for (let k = 0; k < from.length; k += 3)
      expect(Math.abs(Math.hypot(from[k] - 0.5, from[k + 1] - 0.5) - radius)).toBeLessThan(0.002);
  });
});

describe("the camera", () => {
  test("keeps its distance while it turns", () => {
    const poses = [START, orbited(START, 1, 0.3), orbited(START, -2, -5), panned(START, 0.2, 0.1)];
    for (const pose of poses) {
      const { eye, aim } = sight(pose);
      expect(Math.hypot(...eye.map((at, k) => at - aim[k]))).toBeCloseTo(2, 9);
    }
    const { eye, aim } = sight(zoomed(START, 2));
    expect(Math.hypot(...eye.map((at, k) => at - aim[k]))).toBeCloseTo(1, 9);
  });

  test("comes back by the opposite key, and Home goes to the start", () => {
    for (const [key, back] of [
      ["ArrowLeft", "ArrowRight"],
      ["ArrowUp", "ArrowDown"],
      ["+", "-"],
    ]) {
      const there = keyed(START, key, false);
      if (!there) throw new Error(`${key} does nothing`);
      expect(there).not.toEqual(START);
      expect(spoken(keyed(there, back, false) ?? there)).toBe(spoken(START));
    }
    expect(keyed(zoomed(START, 3), "Home", false)).toBe(START);
    expect(keyed(START, "a", false)).toBeNull();
  });

  test("is said in words", () => {
    expect(spoken({ ...START, azimuth: 0, elevation: 0 })).toBe("Seen from the front, zoom 1.0");
    expect(spoken(START)).toBe("Seen 34° from the right, 23° from above, zoom 1.0");
  });
});

describe("what is under the pointer", () => {
  const lens = lensOf(START);
  const { positions, indices } = made("ellipsoid");

  test("is the point that is seen there, not the one behind it", () => {
    for (const [x, y] of [
      [0, 0],
      [0.2, 0.1],
      [-0.3, -0.15],
    ]) {
      const hit = picked(lens.eye, rayThrough(lens, x, y), positions, indices);
      if (!hit) throw new Error("the ellipsoid is in the middle");
      const point = pointOf(hit, positions, indices);
      const [right, up, depth] = projected(lens, point);
      expect(right).toBeCloseTo(x, 9);
      expect(up).toBeCloseTo(y, 9);
      expect(depth).toBeLessThan(2);
      expect(hit.weights.reduce((sum, weight) => sum + weight)).toBeCloseTo(1, 12);
    }
    expect(picked(lens.eye, rayThrough(lens, 0.95, 0.95), positions, indices)).toBeNull();
  });

  test("goes where its triangle goes", () => {
    const hit = picked(lens.eye, rayThrough(lens, 0.1, 0), positions, indices);
    if (!hit) throw new Error("the ellipsoid is in the middle");
    const [x, y, z] = pointOf(hit, positions, indices);
    const doubled = positions.map((at) => 2 * at);
    for (const [k, at] of pointOf(hit, doubled, indices).entries()) expect(at).toBeCloseTo(2 * [x, y, z][k], 9);
  });
});

describe("a link", () => {
  const step = { reference: made("torus"), template: made("cube"), pins: [], settings: { finest: 4, bending: 0 } };
  const look = {
    view: "slice",
    morph: 0.25,
    plane: { axis: 1, part: 0.4 },
    pose: { azimuth: -1.25, elevation: 0.5, zoom: 2, right: 0.1, up: -0.2 },
  } as const;

  test("brings back surfaces, settings, view and camera", () => {
    const { settings, look: read, ...ids } = decode(encode(step, look));
    expect(ids).toEqual({ reference: "torus", template: "cube", pins: [] });
    expect(settings).toEqual(step.settings);
    expect(read).toEqual(look);
  });

  test("says nothing of what is as it was", () => {
    expect(encode({ ...step, settings: {} }, FIRST_LOOK)).toBe("space=1&reference=torus&template=cube");
  });

  test.each(["camera=1,2", "camera=0,0,1e9,0,0", "morph=2", "plane=0,x", "finest=9", "bending=-1"])(
    "with %s is refused",
    (part) => {
      expect(() => decode(`space=1&${part}`)).toThrow(/“/);
    },
  );
});
