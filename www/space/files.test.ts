import { describe, expect, test } from "vitest";
import { json, ply } from "./export";
import { openSolid, readSolid } from "./files";
import { surface } from "./gallery";
import type { Result } from "./session";
import { type Solid, volume } from "./solid";

/** A tetrahedron, seen from outside. */
const CORNERS = [
  [0, 0, 0],
  [2, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];
const FACES = [
  [0, 2, 1],
  [0, 1, 3],
  [1, 2, 3],
  [0, 3, 2],
];

const bytes = (text: string) => new TextEncoder().encode(text);

function plyHead(format: string): string {
  return `ply\nformat ${format} 1.0\ncomment of a test\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n`;
}

function binaryPly(little: boolean): Uint8Array {
  const head = bytes(plyHead(little ? "binary_little_endian" : "binary_big_endian"));
  const body = new DataView(new ArrayBuffer(4 * 12 + 4 * 13));
  for (const [k, value] of CORNERS.flat().entries()) body.setFloat32(4 * k, value, little);
  FACES.forEach((face, i) => {
    body.setUint8(48 + 13 * i, 3);
    for (const [k, vertex] of face.entries()) body.setInt32(49 + 13 * i + 4 * k, vertex, little);
  });
  const all = new Uint8Array(head.length + body.byteLength);
  all.set(head);
  all.set(new Uint8Array(body.buffer), head.length);
  return all;
}

function binaryStl(): Uint8Array {
  const body = new DataView(new ArrayBuffer(84 + 4 * 50));
  body.setUint32(80, 4, true);
  FACES.forEach((face, i) => {
    for (const [k, value] of face.flatMap((vertex) => CORNERS[vertex]).entries())
      body.setFloat32(84 + 50 * i + 12 + 4 * k, value, true);
  });
  return new Uint8Array(body.buffer);
}

const corner = (vertex: number) => CORNERS[vertex].join(" ");
const asciiPly = `${plyHead("ascii")}${CORNERS.map((point) => point.join(" ")).join("\n")}\n${FACES.map((face) => `3 ${face.join(" ")}`).join("\n")}\n`;
const obj = `# a test\n${CORNERS.map((point) => `v ${point.join(" ")}`).join("\n")}\n${FACES.map((face) => `f ${face.map((k) => `${k + 1}/1/1`).join(" ")}`).join("\n")}\n`;
const stl = `solid test\n${FACES.map((face) => `facet normal 0 0 0\nouter loop\n${face.map((k) => `vertex ${corner(k)}`).join("\n")}\nendloop\nendfacet`).join("\n")}\nendsolid\n`;

function expectTetrahedron({ positions, indices }: Solid): void {
  expect(positions).toHaveLength(12);
  expect(indices).toHaveLength(12);
  // The longest side is 0.6, and the whole keeps its proportions.
  expect(volume(positions, indices)).toBeCloseTo((2 / 6) * 0.3 ** 3, 7);
  for (let axis = 0; axis < 3; axis += 1) {
    const along = [0, 1, 2, 3].map((k) => positions[3 * k + axis]);
    expect((Math.min(...along) + Math.max(...along)) / 2).toBeCloseTo(0.5, 6);
  }
}

test.each([
  ["a.ply", bytes(asciiPly)],
  ["a.ply", binaryPly(true)],
  ["a.ply", binaryPly(false)],
  ["a.obj", bytes(obj)],
  ["a.stl", bytes(stl)],
  ["a.stl", binaryStl()],
  ["without an ending", bytes(asciiPly)],
])("a tetrahedron in %s is read, scaled and centred", (name, file) => {
  expectTetrahedron(readSolid(name, file));
});

test("triangles that face inward are turned", () => {
  const inward = obj.replace(/^f (\S+) (\S+) (\S+)$/gm, "f $1 $3 $2");
  expectTetrahedron(readSolid("a.obj", bytes(inward)));
});

test("polygons become triangles, and corners may be counted backwards", () => {
  const cube = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";
  const faces = "f -5 -6 -7 -8\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  const { positions, indices } = readSolid("cube.obj", bytes(cube + faces));
  expect(indices).toHaveLength(36);
  expect(volume(positions, indices)).toBeCloseTo(0.6 ** 3, 9);
});

test("a level set becomes its zero set", () => {
  const cells = 20;
  const values = Array.from({ length: 21 ** 3 }, (_, k) => {
    const at = [k % 21, Math.floor(k / 21) % 21, Math.floor(k / 441)].map((i) => i / cells - 0.5);
    return Math.hypot(...at) - 0.3;
  });
  const { positions, indices } = readSolid("ball.json", bytes(JSON.stringify({ cells, values })));
  expect(volume(positions, indices)).toBeCloseTo((4 / 3) * Math.PI * 0.3 ** 3, 2);
  for (let k = 0; k < positions.length; k += 3)
    expect(Math.abs(Math.hypot(...[0, 1, 2].map((i) => positions[k + i] - 0.5)) - 0.3)).toBeLessThan(0.015);
});

describe("a volume", () => {
  const [width, height, depth] = [24, 20, 16];
  /** A ball of radius 3 in a box of unlike sizes and steps. */
  const values = Array.from({ length: width * height * depth }, (_, k) => {
    const at = [k % width, Math.floor(k / width) % height, Math.floor(k / (width * height))];
    return Math.hypot(0.5 * (at[0] - 11), 0.5 * (at[1] - 9), at[2] - 7) - 3;
  });
  const head = (type: string, encoding: string, more = "spacings: 0.5 0.5 1\n") =>
    `NRRD0004\n# of a test\ntype: ${type}\ndimension: 3\nsizes: ${width} ${height} ${depth}\nencoding: ${encoding}\n${more}\n`;
  const joined = (text: string, data: Uint8Array) => new Uint8Array([...bytes(text), ...data]);
  const floats = (little: boolean) => {
    const view = new DataView(new ArrayBuffer(4 * values.length));
    for (const [k, value] of values.entries()) view.setFloat32(4 * k, value, little);
    return new Uint8Array(view.buffer);
  };
  const expectBall = ({ positions, indices }: Solid) => {
    expect(volume(positions, indices) / ((Math.PI / 6) * 0.6 ** 3)).toBeGreaterThan(0.94);
    expect(volume(positions, indices) / ((Math.PI / 6) * 0.6 ** 3)).toBeLessThan(1.06);
  };

  test.each([
    ["raw, little", joined(head("float", "raw", "spacings: 0.5 0.5 1\nendian: little\n"), floats(true))],
    ["raw, big", joined(head("float", "raw", "spacings: 0.5 0.5 1\nendian: big\n"), floats(false))],
    ["text", bytes(head("double", "ascii") + values.join(" "))],
    [
      "directions",
      bytes(head("double", "text", "space directions: (0.5,0,0) (0,0.5,0) (0,0,1)\n") + values.join("\n")),
    ],
    ["a mask", bytes(head("uchar", "txt") + values.map((value) => (value < 0 ? 255 : 0)).join(" "))],
  ])("as NRRD is its zero set: %s", (name, file) => {
    if (name === "a mask") expect(readSolid("ball.nrrd", file).indices.length).toBeGreaterThan(100);
    else expectBall(readSolid("ball.nrrd", file));
  });

  test("may be packed", async () => {
    const stream = new Blob([floats(true)]).stream().pipeThrough(new CompressionStream("gzip"));
    const packed = new Uint8Array(await new Response(stream).arrayBuffer());
    expectBall(await openSolid("ball.nrrd", joined(head("float", "gzip"), packed)));
    await expect(openSolid("ball.nrrd", joined(head("float", "gzip"), packed.slice(0, 60)))).rejects.toThrow(
      "“ball.nrrd” was not taken: it ends too early.",
    );
  });

  test.each([
    ["no header", "NRRD0004\ntype: float\n", "is no NRRD"],
    ["four sizes", head("float", "raw").replace("dimension: 3", "dimension: 4"), "is no NRRD"],
    ["an unknown packing", head("float", "bzip2"), "is no NRRD"],
    ["elsewhere", head("float", "raw", "data file: ball.raw\n"), "is no NRRD"],
    ["cut", `${head("float", "raw")}abc`, "ends too early"],
    ["cut text", `${head("float", "ascii")}1 2 3`, "ends too early"],
    [
      "words",
      head("float", "ascii") + values.fill(1, 0, 1).join(" ").replace("1", "one"),
      "where a number was expected",
    ],
    ["nothing inside", head("float", "ascii") + values.map(() => 1).join(" "), "no triangles"],
    ["too many", head("uchar", "raw").replace(/sizes: .*/, "sizes: 4096 4096 4096"), "more than 8000000 voxels"],
  ])("is refused: %s", (_, text, why) => {
    expect(() => readSolid("ball.nrrd", bytes(text))).toThrow(why);
  });
});

describe("what exporters write, too, is read:", () => {
  test("a small mesh far from the origin keeps its vertices apart", () => {
    const far = obj.replace(/^v (\S+) (\S+) (\S+)$/gm, (_, x, y, z) =>
      ["v", 4_500_000 + Number(x) / 64, 600_000 + Number(y) / 64, Number(z) / 64].join(" "),
    );
    expectTetrahedron(readSolid("survey.obj", bytes(far)));
  });

  test.each([1e-60, 1e-12, 1e60, 1e300])("a mesh of the size %s", (size) => {
    const scaled = obj.replace(/^v (\S+) (\S+) (\S+)$/gm, (_, ...xyz) =>
      ["v", ...xyz.slice(0, 3).map((x) => size * Number(x))].join(" "),
    );
    expectTetrahedron(readSolid("a.obj", bytes(scaled)));
  });

  test("a binary STL with something after its triangles", () => {
    expectTetrahedron(readSolid("a.stl", new Uint8Array([...binaryStl(), 0, 0, 7])));
  });

  test("an STL in capitals", () => {
    expectTetrahedron(readSolid("part", bytes(stl.toUpperCase())));
  });

  test("an OBJ whose lines go on in the next one, or end as on old Macs", () => {
    expectTetrahedron(readSolid("a.obj", bytes(obj.replace(/^(f \S+) /gm, "$1 \\\n"))));
    expectTetrahedron(readSolid("a.obj", bytes(obj.replaceAll("\n", "\r"))));
  });
});

test("nothing takes for ever: blanks without end, and elements of nothing", () => {
  expect(() => readSolid("blank", bytes(`${" \n".repeat(150)}x`))).toThrow("none of PLY");
  const nothing = asciiPly.replace("element face", "element ghost 4000000000\nelement face");
  expect(() => readSolid("a.ply", bytes(nothing))).toThrow("no PLY header");
});

test("the same bytes have the same key, others another", () => {
  const key = (text: string) => readSolid("a.obj", bytes(text)).id;
  expect(key(obj)).toBe(key(obj));
  expect(key(obj.replace("v 2", "v 3"))).not.toBe(key(obj));
});

describe("what cannot be read is refused by a sentence:", () => {
  test.each([
    ["text", "a.txt", "hello", "none of PLY"],
    ["no triangles", "a.obj", "v 0 0 0\n", "no triangles"],
    ["a vertex that is not there", "a.obj", `${obj}f 1 2 9\n`, "a vertex that it does not have"],
    ["words for numbers", "a.obj", obj.replace("v 2", "v two"), "something else where a number was expected"],
    ["a cut PLY", "a.ply", asciiPly.slice(0, -12), "ends too early"],
    ["an unknown PLY", "a.ply", asciiPly.replace("ascii", "morse"), "the unknown format “morse”"],
    ["a PLY without a header", "a.ply", "ply\nformat ascii 1.0\n", "no PLY header"],
    ["a vertex between two", "a.obj", `${obj}f 1.5 2 3\n`, "a vertex that it does not have"],
    [
      "a facet without its last number",
      "a.stl",
      stl.replace("vertex 0 0 0\n", "vertex 0 0\n"),
      "a number was expected",
    ],
    ["a mesh beyond all numbers", "a.obj", "v -1.7e308 0 0\nv 1.7e308 0 0\nv 0 1 0\nf 1 2 3\n", "than numbers do"],
    ["one point", "a.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n", "no extent"],
    ["other JSON", "a.json", '{"cells": 3}', "is no JSON with “cells”"],
    ["broken JSON", "a.json", "{", "is no JSON with “cells”"],
  ])("%s", (_, name, text, why) => {
    expect(() => readSolid(name, bytes(text))).toThrow(why);
    expect(() => readSolid(name, bytes(text))).toThrow(/^“a\..*” was not taken: it .*\.$/);
  });

  test("a cut binary STL", () => {
    expect(() => readSolid("a.stl", binaryStl().slice(0, -5))).toThrow("ends too early");
  });

  test("a cut binary PLY", () => {
    expect(() => readSolid("a.ply", binaryPly(true).slice(0, -5))).toThrow("ends too early");
  });
});

test("what is exported as PLY is read again, with φ as its vertices", () => {
  const [reference, template] = [surface("sphere"), surface("ellipsoid")];
  if (!reference || !template) throw new Error("the gallery has both");
  const frame = { matched: template.positions, deformation: new Float64Array(3), status: { level: 4, finished: true } };
  const result = { reference, template, settings: {}, frame } as unknown as Result;
  const text = ply(result);
  const { positions, indices } = readSolid("again.ply", bytes(text));
  expect(indices).toEqual(reference.indices);
  const extent = (list: ArrayLike<number>, axis: number) => {
    const along = Array.from({ length: list.length / 3 }, (_, k) => list[3 * k + axis]);
    return Math.max(...along) - Math.min(...along);
  };
  const scale = 0.6 / extent(template.positions, 0);
  for (const axis of [0, 1, 2])
    expect(extent(positions, axis)).toBeCloseTo(scale * extent(template.positions, axis), 6);
  const [first] = text.slice(text.indexOf("end_header\n") + 11).split("\n");
  const [, , , ox, , , ratio, distance, partner] = first.split(" ").map(Number);
  expect(ox).toBe(reference.positions[0]);
  expect(ratio).toBeGreaterThan(0.5);
  expect(distance).toBeLessThan(1e-9);
  expect(partner).toBe(0);
  const whole = JSON.parse(json(result, result));
  expect(whole.match.matched).toHaveLength(reference.positions.length);
  expect(whole.template.indices).toHaveLength(template.indices.length);
});
