/** Volumes as NRRD: one number a voxel, raw, as text, or packed by gzip. No DOM. */

import { space as say } from "../words/space";
import { zeroSet } from "./nets";
import { dot, type Vector } from "./solid";

type Read = (view: DataView, at: number, little: boolean) => number;

const TYPES: readonly (readonly [names: RegExp, size: number, read: Read])[] = [
  [/^(signed char|int8(_t)?)$/, 1, (view, at) => view.getInt8(at)],
  [/^(unsigned char|uchar|uint8(_t)?)$/, 1, (view, at) => view.getUint8(at)],
  [/^((signed )?short( int)?|int16(_t)?)$/, 2, (view, at, little) => view.getInt16(at, little)],
  [/^(unsigned short( int)?|ushort|uint16(_t)?)$/, 2, (view, at, little) => view.getUint16(at, little)],
  [/^((signed )?int|int32(_t)?)$/, 4, (view, at, little) => view.getInt32(at, little)],
  [/^(unsigned int|uint|uint32(_t)?)$/, 4, (view, at, little) => view.getUint32(at, little)],
  [/^float$/, 4, (view, at, little) => view.getFloat32(at, little)],
  [/^double$/, 8, (view, at, little) => view.getFloat64(at, little)],
];

const MOST_VOXELS = 8_000_000;

export function isNrrd(bytes: Uint8Array): boolean {
  return /^NRRD\d/.test(new TextDecoder().decode(bytes.subarray(0, 8)));
}

type Head = { readonly fields: ReadonlyMap<string, string>; readonly data: Uint8Array };

function head(bytes: Uint8Array): Head {
  const begin = new TextDecoder("latin1").decode(bytes.subarray(0, 65_536));
  const end = /\r?\n\r?\n/.exec(begin);
  if (!end) throw new Error(say.files.nrrd);
  const fields = new Map<string, string>();
  for (const line of begin.slice(0, end.index).split(/\r?\n/).slice(1)) {
    const [, name, value] = /^([^#:]+): (.*)$/.exec(line) ?? [];
    if (name) fields.set(name.trim().toLowerCase(), value.trim());
  }
  return { fields, data: bytes.subarray(end.index + end[0].length) };
}

/** The same file without gzip, which only browsers' own streams undo. Anything else is left as it is. */
export async function unpacked(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array<ArrayBuffer>> {
  if (!isNrrd(bytes)) return bytes;
  const { fields, data } = head(bytes);
  if (!/^(gz|gzip)$/i.test(fields.get("encoding") ?? "")) return bytes;
  const packed = new Blob([data as Uint8Array<ArrayBuffer>]).stream().pipeThrough(new DecompressionStream("gzip"));
  const plain = await new Response(packed).arrayBuffer().catch(() => {
    throw new Error(say.files.cut);
  });
  const lines = [...fields].map(([name, value]) => `${name}: ${name === "encoding" ? "raw" : value}\n`);
  const text = new TextEncoder().encode(`NRRD0004\n${lines.join("")}\n`);
  const whole = new Uint8Array(text.length + plain.byteLength);
  whole.set(text);
  whole.set(new Uint8Array(plain), text.length);
  return whole;
}

/**
 * The surface of a level set, negative inside, where there are both signs; of anything else that half way between its
 * least and its greatest number, with what is greater inside.
 */
export function readNrrd(bytes: Uint8Array) {
  const { fields, data } = head(bytes);
  const sizes = words(fields, "sizes").map(Number);
  const type = TYPES.find(([names]) => names.test((fields.get("type") ?? "").toLowerCase()));
  const isBox = sizes.length === 3 && sizes.every((size) => Number.isInteger(size) && size >= 2);
  if (!isBox || !type || fields.get("dimension") !== "3" || fields.has("data file") || fields.has("datafile"))
    throw new Error(say.files.nrrd);
  const count = sizes[0] * sizes[1] * sizes[2];
  if (count > MOST_VOXELS) throw new Error(say.files.manyVoxels(MOST_VOXELS));
  const values = numbers(fields, data, type, count);
  let [least, most] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (const value of values) {
    if (!Number.isFinite(value)) throw new Error(say.files.number);
    least = Math.min(least, value);
    most = Math.max(most, value);
  }
  const isSigned = least < 0 && most > 0;
  const middle = least / 2 + most / 2;
  return zeroSet({
    sizes: sizes as [number, number, number],
    spacings: spacings(fields),
    values: isSigned ? values : values.map((value) => middle - value),
  });
}

function words(fields: Head["fields"], name: string): string[] {
  return (fields.get(name) ?? "").split(/\s+/).filter(Boolean);
}

function numbers(fields: Head["fields"], data: Uint8Array, [, size, read]: (typeof TYPES)[number], count: number) {
  const encoding = (fields.get("encoding") ?? "").toLowerCase();
  if (/^(ascii|text|txt)$/.test(encoding)) {
    const list = new TextDecoder().decode(data).split(/\s+/).filter(Boolean);
    if (list.length < count) throw new Error(say.files.cut);
    return Float64Array.from(list.slice(0, count), Number);
  }
  if (encoding !== "raw") throw new Error(say.files.nrrd);
  if (data.length < size * count) throw new Error(say.files.cut);
  const view = new DataView(data.buffer, data.byteOffset, data.byteLength);
  const little = (fields.get("endian") ?? "little").toLowerCase() !== "big";
  return Float64Array.from({ length: count }, (_, k) => read(view, size * k, little));
}

/** Lengths of the steps; where none are given, or not all of them, cubes. */
function spacings(fields: Head["fields"]): [number, number, number] {
  const given = words(fields, "spacings").map(Number);
  const directions = [...(fields.get("space directions") ?? "").matchAll(/\(([^)]*)\)/g)].map(([, inner]) => {
    const [x = 0, y = 0, z = 0] = inner.split(",").map(Number);
    const direction: Vector = [x, y, z];
    return Math.sqrt(dot(direction, direction));
  });
  const [x, y, z] = [given, directions].find((all) => all.length === 3 && all.every((one) => one > 0)) ?? [1, 1, 1];
  return [x, y, z];
}
