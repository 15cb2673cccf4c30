import { expect, test } from "vitest";
import type { GridMap } from "./field";
import { carried, type Picture, pulledBack, type Raster, sample } from "./raster";

const CELLS = 8;
const RASTER: Raster = { left: -0.5, bottom: -0.5, scale: 40, width: 80, height: 80 };

function map(f: (x: number, y: number) => readonly [number, number]): GridMap {
  const side = CELLS + 1;
  const deformation = new Float64Array(2 * side * side);
  for (let node = 0; node < side * side; node += 1) {
    deformation.set(f((node % side) / CELLS, Math.floor(node / side) / CELLS), 2 * node);
  }
  return { cells: CELLS, deformation };
}

/** The middle of a pixel, domain units. */
function middle(pixel: number): [number, number] {
  const { left, bottom, scale, width, height } = RASTER;
  const column = pixel % width;
  return [left + (column + 0.5) / scale, bottom + (height - Math.floor(pixel / width) - 0.5) / scale];
}

const turned = (x: number, y: number) => [0.5 + 0.8 * (y - 0.5), 0.5 - 0.8 * (x - 0.5)] as const;

test("a pixel that is carried comes from the point that the map takes to its middle", () => {
  let seen = 0;
  carried(RASTER, map(turned), (pixel, x, y) => {
    const [u, v] = turned(x, y);
    expect([u, v]).toEqual(middle(pixel).map((value) => expect.closeTo(value, 10)));
    seen += 1;
  });
  expect(seen).toBeGreaterThan(0);
});

test("no pixel inside the image of the box is left out", () => {
  const seen = new Set<number>();
  carried(
    RASTER,
    map((x, y) => [x + 0.1 * y * y, y + 0.3 * y * (1 - y) * Math.sin(6 * x)]),
    (pixel) => seen.add(pixel),
  );
  // Along every row the pixels follow one another without a gap.
  for (let row = 0; row < RASTER.height; row += 1) {
    const columns = [...seen].filter((p) => Math.floor(p / RASTER.width) === row).map((p) => p % RASTER.width);
    if (columns.length > 0) expect(Math.max(...columns) - Math.min(...columns) + 1).toBe(new Set(columns).size);
  }
  expect(seen.size).toBeGreaterThan(1000);
});

test("pulled back, a pixel of the box is given where the map takes it", () => {
  let seen = 0;
  pulledBack(RASTER, map(turned), (pixel, x, y) => {
    const [u, v] = middle(pixel);
    expect([x, y]).toEqual(turned(u, v).map((value) => expect.closeTo(value, 10)));
    seen += 1;
  });
  expect(seen).toBe(1600);
});

test("a picture is read between its pixels, its top row at the top, and nowhere beyond", () => {
  const picture: Picture = {
    width: 2,
    height: 2,
    data: Uint8ClampedArray.of(200, 0, 0, 255, 100, 0, 0, 255, 0, 0, 0, 255, 50, 0, 0, 255),
  };
  const read = (x: number, y: number) => {
    const into = new Uint8ClampedArray(4);
    sample(picture, x, y, into, 0);
    return [...into];
  };
  expect(read(0.25, 0.75)).toEqual([200, 0, 0, 255]);
  expect(read(0.5, 0.75)).toEqual([150, 0, 0, 255]);
  expect(read(0.25, 0.5)).toEqual([100, 0, 0, 255]);
  expect(read(1, 0)).toEqual([50, 0, 0, 255]);
  expect(read(1.01, 0.5)).toEqual([0, 0, 0, 0]);
});
