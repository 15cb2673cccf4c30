/** Meshes from files: PLY (ascii and binary), OBJ, STL (ascii and binary), and level sets as NRRD or JSON. No DOM. */

import { space as say } from "../words/space";
import { zeroSetOfBox } from "./nets";
import { isNrrd, readNrrd, unpacked } from "./nrrd";
import { box, fitted, type Solid } from "./solid";
import { keyOf } from "./store";

/** Vertices and triangles as a file numbers them. */
export type Soup = { readonly positions: Float64Array; readonly indices: Uint32Array };

export const ACCEPTED = ".ply,.obj,.stl,.nrrd,.json";

const MOST_TRIANGLES = 400_000;

/** The mesh, scaled and centred. Throws a sentence for what cannot be read. */
export function readSolid(name: string, bytes: Uint8Array): Solid {
  return read(name, bytes, (soup) => ({ id: keyOf(bytes), name: name.slice(0, 60), ...fitted(welded(soup)) }));
}

/** The same of a file that may be packed. */
export async function openSolid(name: string, bytes: Uint8Array<ArrayBuffer>): Promise<Solid> {
  const plain = await unpacked(bytes).catch((error) => {
    throw refused(name, error);
  });
  return readSolid(name, plain);
}

/** The mesh with its own coordinates and numbering. Throws a sentence for what cannot be read. */
export function readSoup(name: string, bytes: Uint8Array): Soup {
  return read(name, bytes, (soup) => soup);
}

function read<T>(name: string, bytes: Uint8Array, made: (soup: Soup) => T): T {
  try {
    const soup = reader(name, bytes)(bytes);
    const triangles = soup.indices.length / 3;
    if (triangles === 0) throw new Error(say.files.empty);
    if (triangles > MOST_TRIANGLES) throw new Error(say.files.large(MOST_TRIANGLES));
    if (!soup.positions.every(Number.isFinite)) throw new Error(say.files.number);
    const vertices = soup.positions.length / 3;
    if (soup.indices.some((vertex) => vertex >= vertices)) throw new Error(say.files.index);
    return made(soup);
  } catch (error) {
    throw refused(name, error);
  }
}

function refused(name: string, error: unknown): Error {
  const why = error instanceof RangeError ? say.files.cut : error instanceof Error ? error.message : String(error);
  return new Error(say.files.notRead(name.slice(0, 60), why));
}

/** By what the file holds, not only by what it is called. */
function reader(name: string, bytes: Uint8Array): (bytes: Uint8Array) => Soup {
  const begin = text(bytes.subarray(0, 400));
  const ending = name.toLowerCase().match(/\.(\w+)$/)?.[1];
  if (/^ply\s/.test(begin)) return readPly;
  if (isNrrd(bytes)) return readNrrd;
  if (ending === "obj" || /^v\s+[-\d]/m.test(begin)) return readObj;
  if (ending === "stl" || /^\s*solid\s/i.test(begin)) return readStl;
  if (ending === "json" || /^\s*\{/.test(begin)) return readLevelSet;
  throw new Error(say.files.unknown);
}

function text(bytes: Uint8Array): string {
  return new TextDecoder().decode(bytes);
}

/** Vertices at one place are one: STL and others repeat them in each triangle. Triangles without area go. */
function welded({ positions, indices }: Soup): Soup {
  const first = new Map<string, number>();
  const kept: number[] = [];
  const { least, extent } = box({ positions, indices });
  const to = Uint32Array.from({ length: positions.length / 3 }, (_, vertex) => {
    const point = [positions[3 * vertex], positions[3 * vertex + 1], positions[3 * vertex + 2]];
    // In single precision of the mesh's own size: far from the origin that of its coordinates would join what is apart.
    const key = point.map((at, axis) => Math.fround((at - least[axis]) / extent)).join(" ");
    const known = first.get(key);
    if (known !== undefined) return known;
    first.set(key, kept.length / 3);
    kept.push(...point);
    return kept.length / 3 - 1;
  });
  const triangles: number[] = [];
  for (let k = 0; k < indices.length; k += 3) {
    const [a, b, c] = [to[indices[k]], to[indices[k + 1]], to[indices[k + 2]]];
    if (a !== b && b !== c && c !== a) triangles.push(a, b, c);
  }
  return { positions: Float64Array.from(kept), indices: Uint32Array.from(triangles) };
}

/** Polygons as fans of triangles. */
function fan(corners: readonly number[], into: number[]): void {
  for (let k = 2; k < corners.length; k += 1) into.push(corners[0], corners[k - 1], corners[k]);
}

type Read = (view: DataView, at: number, little: boolean) => number;

const TYPES: Readonly<Record<string, readonly [size: number, read: Read]>> = {
  char: [1, (view, at) => view.getInt8(at)],
  uchar: [1, (view, at) => view.getUint8(at)],
  short: [2, (view, at, little) => view.getInt16(at, little)],
  ushort: [2, (view, at, little) => view.getUint16(at, little)],
  int: [4, (view, at, little) => view.getInt32(at, little)],
  uint: [4, (view, at, little) => view.getUint32(at, little)],
  float: [4, (view, at, little) => view.getFloat32(at, little)],
  double: [8, (view, at, little) => view.getFloat64(at, little)],
};
const ALIASES: Readonly<Record<string, string>> = {
  int8: "char",
  uint8: "uchar",
  int16: "short",
  uint16: "ushort",
  int32: "int",
  uint32: "uint",
  float32: "float",
  float64: "double",
};

type Property = { readonly name: string; readonly type: string; readonly count: string | null };
type Element = { readonly name: string; readonly count: number; readonly properties: Property[] };

function readPly(bytes: Uint8Array): Soup {
  const head = text(bytes.subarray(0, 65_536));
  const end = head.match(/end_header\r?\n/);
  if (end?.index === undefined) throw new Error(say.files.plyHeader);
  const elements: Element[] = [];
  let format = "";
  for (const line of head.slice(0, end.index).split(/\r?\n/)) {
    const words = line.trim().split(/\s+/);
    const typed = (type: string) => ALIASES[type] ?? type;
    if (words[0] === "format") format = words[1];
    else if (words[0] === "element") elements.push({ name: words[1], count: Number(words[2]), properties: [] });
    else if (words[0] === "property" && words[1] === "list")
      elements.at(-1)?.properties.push({ name: words[4], type: typed(words[3]), count: typed(words[2]) });
    else if (words[0] === "property")
      elements.at(-1)?.properties.push({ name: words[2], type: typed(words[1]), count: null });
  }
  if (!["ascii", "binary_little_endian", "binary_big_endian"].includes(format))
    throw new Error(say.files.plyFormat(format));
  const types = elements.flatMap(({ properties }) => properties.flatMap(({ type, count }) => [type, count ?? type]));
  const isSound = ({ count, properties }: Element) => count >= 0 && (count === 0 || properties.length > 0);
  if (!types.every((type) => type in TYPES) || !elements.every(isSound)) throw new Error(say.files.plyHeader);
  // The header is plain ASCII: as many bytes as letters.
  const next = tokens(bytes.subarray(end.index + end[0].length), format);
  const positions: number[] = [];
  const indices: number[] = [];
  for (const { name, count, properties } of elements)
    for (let i = 0; i < count; i += 1) {
      const point = [0, 0, 0];
      for (const property of properties) {
        const length = property.count === null ? 1 : next(property.count);
        const values: number[] = [];
        for (let k = 0; k < length; k += 1) values.push(next(property.type));
        if (name === "vertex" && property.count === null) {
          const axis = ["x", "y", "z"].indexOf(property.name);
          if (axis >= 0) point[axis] = values[0];
        } else if (name === "face" && /^vertex_ind(ex|ices)$/.test(property.name)) fan(values, indices);
      }
      if (name === "vertex") positions.push(...point);
    }
  return { positions: Float64Array.from(positions), indices: Uint32Array.from(indices) };
}

/** The next value of a type. */
function tokens(bytes: Uint8Array, format: string): (type: string) => number {
  if (format === "ascii") {
    const words = text(bytes).split(/\s+/).filter(Boolean);
    let at = 0;
    return () => {
      if (at >= words.length) throw new Error(say.files.cut);
      at += 1;
      return number(words[at - 1]);
    };
  }
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let at = 0;
  return (type) => {
    const [size, read] = TYPES[type];
    at += size;
    return read(view, at - size, format === "binary_little_endian");
  };
}

function number(word: string): number {
  const value = Number(word);
  if (word === "" || !Number.isFinite(value)) throw new Error(say.files.number);
  return value;
}

function readObj(bytes: Uint8Array): Soup {
  const positions: number[] = [];
  const indices: number[] = [];
  // A backslash goes on in the next line.
  const lines = text(bytes)
    .replace(/\\\r?\n/g, " ")
    .split(/\r\n?|\n/);
  for (const line of lines) {
    const [word, ...rest] = line.trim().split(/\s+/);
    if (word === "v") positions.push(...[0, 1, 2].map((axis) => number(rest[axis] ?? "")));
    else if (word === "f") {
      const count = positions.length / 3;
      fan(
        rest.map((corner) => {
          // From 1, or backwards from the last one.
          const named = number(corner.split("/")[0]);
          const vertex = named < 0 ? count + named : named - 1;
          if (!(vertex >= 0 && Number.isInteger(vertex))) throw new Error(say.files.index);
          return vertex;
        }),
        indices,
      );
    }
  }
  return { positions: Float64Array.from(positions), indices: Uint32Array.from(indices) };
}

const STL_HEADER = 84;
const STL_TRIANGLE = 50;

function readStl(bytes: Uint8Array): Soup {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const count = bytes.length >= STL_HEADER ? view.getUint32(80, true) : 0;
  const positions: number[] = [];
  // Binary files may begin with “solid”, too, and end with more than their triangles: what tells is a text's own words.
  const length = STL_HEADER + STL_TRIANGLE * count;
  if (bytes.length === length || (count > 0 && !/facet/i.test(text(bytes.subarray(0, 4096))))) {
    if (bytes.length < length) throw new Error(say.files.cut);
    for (let i = 0; i < count; i += 1)
      for (let k = 0; k < 9; k += 1) positions.push(view.getFloat32(STL_HEADER + STL_TRIANGLE * i + 12 + 4 * k, true));
  } else {
    for (const [, x, y, z] of text(bytes).matchAll(/vertex\s+(\S+)\s+(\S+)\s+(\S+)/gi))
      positions.push(number(x), number(y), number(z));
  }
  const whole = positions.length - (positions.length % 9);
  return {
    positions: Float64Array.from(positions.slice(0, whole)),
    indices: Uint32Array.from({ length: whole / 3 }, (_, k) => k),
  };
}

const MOST_CELLS = 128;

function readLevelSet(bytes: Uint8Array): Soup {
  let given: { cells?: unknown; values?: unknown };
  try {
    given = JSON.parse(text(bytes));
  } catch {
    throw new Error(say.files.json);
  }
  const { cells, values } = given ?? {};
  const isCells = typeof cells === "number" && Number.isInteger(cells) && cells >= 2 && cells <= MOST_CELLS;
  if (!isCells || !Array.isArray(values) || values.length !== (cells + 1) ** 3) throw new Error(say.files.json);
  return zeroSetOfBox(
    cells,
    Float64Array.from(values, (value) => number(String(value))),
  );
}
