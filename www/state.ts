/**
 * Shapes and settings as text: in the address, so that a link brings everything back, and in the browser's storage, so
 * that closing the page loses nothing.
 *
 * The text is a query string: `v=1&preset=star` for an untouched preset, else `v=1&reference=…&template=…`, then the
 * settings that differ from their defaults. A loop is base64url of little-endian 16-bit x y x y … in units of 2⁻¹⁵ of
 * the box from −0.5 to 1.5 (2 · 10⁻⁵ of the box at most off); loops are joined by dots. Pins are one such list, x y on
 * the reference and x y on the template.
 */

import { type Chosen, FIELDS, parseSetting, withSetting } from "./settings";
import type { Shape } from "./shapes/geometry";
import { flat, isInBox, MOST_PINS, type Pin, pinsFrom, type Shapes } from "./shapes/pins";
import { PRESETS } from "./shapes/presets";

export type Saved = Shapes & {
  readonly settings: Chosen;
  /** The preset that the shapes are, untouched; else null. */
  readonly preset: string | null;
};

const VERSION = "1";
const KEY = "thinshell";
const STEPS = 65535;
const LOW = -0.5;
const SPAN = 2;

export function encode(saved: Saved): string {
  const query = new URLSearchParams({ v: VERSION });
  if (saved.preset) query.set("preset", saved.preset);
  else {
    query.set("reference", encodeShape(saved.reference));
    query.set("template", encodeShape(saved.template));
  }
  if (saved.pins.length > 0) query.set("pins", encodeShape([flat(saved.pins)]));
  for (const field of FIELDS) {
    const value = saved.settings[field.name];
    if (value !== undefined) query.set(field.name, String(value));
  }
  return query.toString();
}

/** Throws a sentence when the text is not what `encode` writes. */
export function decode(text: string): Saved {
  const query = new URLSearchParams(text);
  const version = query.get("v");
  if (version !== VERSION) throw new Error(`version “${version ?? ""}” is not known`);
  let settings: Chosen = {};
  for (const field of FIELDS) {
    const value = query.get(field.name);
    if (value !== null) settings = withSetting(settings, field, parseSetting(field, value));
  }
  const pins = decodePins(query.get("pins") ?? "");
  const id = query.get("preset");
  if (id !== null) {
    const preset = PRESETS.find((candidate) => candidate.id === id);
    if (!preset) throw new Error(`there is no example called “${id}”`);
    return { reference: preset.reference, template: preset.template, pins, settings, preset: id };
  }
  return {
    reference: decodeShape(query.get("reference"), "reference"),
    template: decodeShape(query.get("template"), "template"),
    pins,
    settings,
    preset: null,
  };
}

function encodeShape(shape: Shape): string {
  return shape
    .map((loop) => {
      const bytes = new Uint8Array(2 * loop.length);
      const view = new DataView(bytes.buffer);
      loop.forEach((value, i) => {
        const part = Math.round(((value - LOW) / SPAN) * STEPS);
        view.setUint16(2 * i, Math.min(STEPS, Math.max(0, part)), true);
      });
      const binary = Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
      return btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
    })
    .join(".");
}

function decodeShape(text: string | null, name: string): Shape {
  if (text === null) throw new Error(`the ${name} is missing`);
  if (text === "") return [];
  return text.split(".").map((part, index) => decodeLoop(part, `loop ${index} of the ${name}`));
}

function decodeLoop(text: string, name: string): Float64Array {
  let binary: string;
  try {
    binary = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  } catch {
    throw new Error(`${name} is damaged`);
  }
  if (binary.length === 0 || binary.length % 4 !== 0) throw new Error(`${name} is cut off`);
  const view = new DataView(Uint8Array.from(binary, (character) => character.charCodeAt(0)).buffer);
  return Float64Array.from({ length: binary.length / 2 }, (_, i) => LOW + (view.getUint16(2 * i, true) / STEPS) * SPAN);
}

function decodePins(text: string): readonly Pin[] {
  if (text === "") return [];
  const numbers = decodeLoop(text, "the list of pins");
  if (numbers.length % 4 !== 0) throw new Error("the list of pins is cut off");
  if (numbers.length > 4 * MOST_PINS) throw new Error(`there are more than ${MOST_PINS} pins`);
  if (!numbers.every(isInBox)) throw new Error("a pin lies outside the box");
  return pinsFrom(numbers);
}

export type Opened = {
  readonly saved: Saved;
  /** Why the link was not read. */
  readonly problem: string | null;
  /** The shapes come from the storage, so that the address does not hold them yet. */
  readonly remembered: boolean;
  /** The link asks for the match to be left to a press: `match=later`, for those who are to guess it first. */
  readonly later: boolean;
};

/**
 * What the page starts with: the link, else what was stored, else the first example. A link that cannot be read is
 * reported and takes nothing away.
 */
export function open(hash: string, stored: string | null): Opened {
  const remembered = fromStorage(stored);
  const text = hash.replace(/^#/, "");
  // An anchor of the page itself, such as #method, is no link to shapes.
  if (!text.includes("=")) return { saved: remembered, problem: null, remembered: stored !== null, later: false };
  try {
    const later = new URLSearchParams(text).get("match") === "later";
    return { saved: decode(text), problem: null, remembered: false, later };
  } catch (error) {
    const why = error instanceof Error ? error.message : String(error);
    return {
      saved: remembered,
      problem: `The link could not be read: ${why}. Your last shapes are shown instead; ask for a fresh link to see the others.`,
      remembered: false,
      later: false,
    };
  }
}

export function fallback(): Saved {
  const [first] = PRESETS;
  return { reference: first.reference, template: first.template, pins: [], settings: {}, preset: first.id };
}

function fromStorage(stored: string | null): Saved {
  if (stored === null) return fallback();
  try {
    return decode(stored);
  } catch {
    // Written by another version of this page: there is nobody to ask, and the example is a good start.
    return fallback();
  }
}

export function readStorage(): string | null {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null; // Storage is switched off in this browser; the link still keeps everything.
  }
}

/** Keeps the text in the address and in storage. */
export function remember(text: string): void {
  history.replaceState(null, "", `#${text}`);
  try {
    localStorage.setItem(KEY, text);
  } catch {
    // Storage is full or switched off; the address holds the same text.
  }
}
