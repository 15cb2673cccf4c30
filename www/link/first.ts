/**
 * Loops as links of version 1 had them: base64url of little-endian 16-bit x y x y … in the steps that `pack.ts` has,
 * uncompressed. Only read: such links are still about.
 */

const LOW = -0.5;
const SPAN = 2;
const STEPS = 65535;

/** Throws "damaged" or "cut off". */
export function unpackFirst(text: string): Float64Array {
  let binary: string;
  try {
    binary = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  } catch {
    throw new Error("damaged");
  }
  if (binary.length === 0 || binary.length % 4 !== 0) throw new Error("cut off");
  const view = new DataView(Uint8Array.from(binary, (character) => character.charCodeAt(0)).buffer);
  return Float64Array.from({ length: binary.length / 2 }, (_, i) => LOW + (view.getUint16(2 * i, true) / STEPS) * SPAN);
}
