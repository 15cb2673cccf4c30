import { describe, expect, test } from "vitest";
import {
  about,
  bounds,
  centroid,
  contains,
  FITTED_SIZE,
  fitted,
  type Loop,
  nearestVertex,
  perimeter,
  resampled,
  reversed,
  signedArea,
  smoothed,
  transformed,
  winding,
} from "./geometry";

const SQUARE = Float64Array.of(0.2, 0.2, 0.6, 0.2, 0.6, 0.6, 0.2, 0.6);

function circle(radius: number, count = 200): Loop {
  return Float64Array.from({ length: 2 * count }, (_, i) => {
    const t = (2 * Math.PI * Math.floor(i / 2)) / count;
    return 0.5 + radius * (i % 2 === 0 ? Math.cos(t) : Math.sin(t));
  });
}

describe("measures", () => {
  test("the area is positive counter-clockwise and changes sign with the direction", () => {
    expect(signedArea(SQUARE)).toBeCloseTo(0.16, 14);
    expect(signedArea(reversed(SQUARE))).toBeCloseTo(-0.16, 14);
  });

  test("a polygon of many points has the perimeter and the area of the circle, to second order", () => {
    const error = (count: number) => Math.abs(perimeter(circle(0.3, count)) - 0.6 * Math.PI);
    expect(error(100) / error(200)).toBeCloseTo(4, 1);
    expect(signedArea(circle(0.3, 2000))).toBeCloseTo(Math.PI * 0.09, 5);
  });

  test("a hole moves the centre of gravity away from it", () => {
    const hole = reversed(Float64Array.of(0.5, 0.3, 0.55, 0.3, 0.55, 0.5, 0.5, 0.5));
    expect(centroid([SQUARE])).toEqual({ x: expect.closeTo(0.4, 12), y: expect.closeTo(0.4, 12) });
    expect(centroid([SQUARE, hole]).x).toBeLessThan(0.4);
  });

  test("a shape without area still has a centre, and one without points the middle of the box", () => {
    expect(centroid([Float64Array.of(0.2, 0.2, 0.4, 0.2)])).toEqual({ x: expect.closeTo(0.3, 12), y: 0.2 });
    expect(centroid([])).toEqual({ x: 0.5, y: 0.5 });
    expect(bounds([])).toBeNull();
  });
});

describe("inside and outside", () => {
  test("the hole of a ring is outside", () => {
    const ring = [circle(0.3), reversed(circle(0.1))];
    expect(contains(ring, { x: 0.7, y: 0.5 })).toBe(true);
    expect(contains(ring, { x: 0.5, y: 0.5 })).toBe(false);
    expect(contains(ring, { x: 0.9, y: 0.5 })).toBe(false);
  });

  test("a curve that runs round twice winds twice", () => {
    const twice = Float64Array.of(...circle(0.3), ...circle(0.2));
    expect(winding([twice], { x: 0.5, y: 0.5 })).toBe(2);
  });
});

describe("maps", () => {
  test("a turn about a point leaves the point where it is and every length as it is", () => {
    const turned = transformed([SQUARE], about({ x: 0.2, y: 0.2 }, 1, 0.7))[0];
    expect(turned[0]).toBeCloseTo(0.2, 14);
    expect(turned[1]).toBeCloseTo(0.2, 14);
    expect(perimeter(turned)).toBeCloseTo(perimeter(SQUARE), 14);
    expect(signedArea(turned)).toBeCloseTo(signedArea(SQUARE), 14);
  });

  test("a fitted shape is centred, keeps its proportions and fills the wanted part of the box", () => {
    const [loop] = fitted([Float64Array.of(0.05, 0.9, 0.25, 0.9, 0.25, 0.99, 0.05, 0.99)]);
    expect(bounds([loop])).toEqual({
      left: expect.closeTo(0.5 - FITTED_SIZE / 2, 12),
      right: expect.closeTo(0.5 + FITTED_SIZE / 2, 12),
      bottom: expect.closeTo(0.5 - (FITTED_SIZE * 0.45) / 2, 12),
      top: expect.closeTo(0.5 + (FITTED_SIZE * 0.45) / 2, 12),
    });
  });

  test("fitting nothing gives nothing, and a single place moves to the middle", () => {
    expect(fitted([])).toEqual([]);
    expect([...fitted([Float64Array.of(0.1, 0.1, 0.1, 0.1)])[0]]).toEqual([0.5, 0.5, 0.5, 0.5]);
  });
});

describe("sampling", () => {
  test("points lie at equal arc length and on the polygon", () => {
    const loop = resampled(SQUARE, 16);
    for (let i = 0; i < 16; i += 1) {
      const j = (i + 1) % 16;
      expect(Math.hypot(loop[2 * j] - loop[2 * i], loop[2 * j + 1] - loop[2 * i + 1])).toBeCloseTo(0.1, 12);
    }
    expect(signedArea(loop)).toBeCloseTo(0.16, 12);
  });

  test("a loop whose points coincide does not become NaN", () => {
    expect([...resampled(Float64Array.of(0.3, 0.4, 0.3, 0.4), 3)]).toEqual([0.3, 0.4, 0.3, 0.4, 0.3, 0.4]);
  });

  test("smoothing takes the tremor out and keeps the circle's size", () => {
    const calm = circle(0.3);
    const trembling = calm.map((value, i) => value + 0.003 * (i % 4 < 2 ? 1 : -1));
    const roughness = (loop: Loop) => loop.reduce((most, value, i) => Math.max(most, Math.abs(value - calm[i])), 0);
    const result = smoothed(trembling, 3);
    expect(roughness(result)).toBeLessThan(0.1 * roughness(trembling));
    expect(signedArea(result)).toBeCloseTo(signedArea(calm), 3);
  });

  test("the nearest vertex is found on any loop", () => {
    const near = nearestVertex([SQUARE, circle(0.05)], { x: 0.56, y: 0.5 });
    expect(near).toEqual({ loop: 1, vertex: 0, distance: expect.closeTo(0.01, 12) });
    expect(nearestVertex([], { x: 0, y: 0 })).toBeNull();
  });
});
