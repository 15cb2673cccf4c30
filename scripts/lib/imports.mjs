// Short names for what a wasm module imports. wasm-bindgen's carry a hash each, which no compression makes smaller, and
// each is sent twice: in the module, and in the JavaScript beside it.

const HEADER = 8;
const IMPORTS = 2;
const FUNCTION = 0;

/**
 * @param {Uint8Array} module as wasm-bindgen made it, whose imports are functions of one name each
 * @param {string} glue the JavaScript that provides them
 * @returns {{ module: Uint8Array, glue: string }}
 */
export function withShortImports(module, glue) {
  for (let at = HEADER; at < module.length; ) {
    const [size, start] = number(module, at + 1);
    if (module[at] !== IMPORTS) {
      at = start + size;
      continue;
    }
    const { section, names } = renamed(module, start);
    const parts = [module.subarray(0, at + 1), bytesOf(section.length), section, module.subarray(start + size)];
    return { module: Buffer.concat(parts), glue: names.reduce(provided, glue) };
  }
  return { module, glue };
}

/**
 * The section of the imports, renamed, and the names that they had.
 * @param {Uint8Array} module @param {number} start
 */
function renamed(module, start) {
  const [count, first] = number(module, start);
  /** @type {string[]} */
  const names = [];
  /** @type {Uint8Array[]} */
  const parts = [bytesOf(count)];
  let at = first;
  while (names.length < count) {
    const [, from] = text(module, at);
    const [name, kind] = text(module, from);
    if (module[kind] !== FUNCTION) throw new Error(`the import ${name} is no function`);
    const [, end] = number(module, kind + 1);
    const short = Buffer.from(nameOf(names.length));
    parts.push(module.subarray(at, from), bytesOf(short.length), short, module.subarray(kind, end));
    names.push(name);
    at = end;
  }
  return { section: Buffer.concat(parts), names };
}

/** @param {string} glue @param {string} name @param {number} i */
function provided(glue, name, i) {
  const key = `\n        ${name}: function`;
  if (glue.split(key).length !== 2) throw new Error(`${name} is not provided once`);
  return glue.replace(key, `\n        ${nameOf(i)}: function`);
}

/** @param {number} i */
function nameOf(i) {
  return `i${i.toString(36)}`;
}

/**
 * An unsigned number in LEB128, and where it ends.
 * @param {Uint8Array} bytes @param {number} at
 * @returns {[value: number, end: number]}
 */
function number(bytes, at) {
  let value = 0;
  for (let shift = 0; ; shift += 7) {
    const byte = bytes[at++];
    value += (byte & 127) * 2 ** shift;
    if (byte < 128) return [value, at];
  }
}

/**
 * @param {Uint8Array} bytes @param {number} at
 * @returns {[value: string, end: number]}
 */
function text(bytes, at) {
  const [length, start] = number(bytes, at);
  return [Buffer.from(bytes.subarray(start, start + length)).toString(), start + length];
}

/** @param {number} value */
function bytesOf(value) {
  const bytes = [];
  for (; value > 127; value >>= 7) bytes.push((value & 127) | 128);
  return Buffer.from([...bytes, value]);
}
