/**
 * Everything on the page as text, for its address and for the browser's storage.
 *
 * The text is a query string: `v=2&preset=star` for an untouched preset, else `v=2&reference=…&template=…`, then `pins`,
 * then the settings that differ from their defaults, then `view` and `morph` where they do. A shape is its loops as
 * `pack.ts` writes them, joined by dots; pins are one such list, x y on the reference and x y on the template. Version 1
 * had its loops uncompressed, and is still read.
 */

import { type Chosen, FIELDS, parseSetting, withSetting } from "../settings";
import type { Loop, Shape } from "../shapes/geometry";
import { flat, isInBox, MOST_PINS, type Pin, pinsFrom, type Shapes } from "../shapes/pins";
import { PRESETS } from "../shapes/presets";
import { VIEWS, type View } from "../view/names";
import { links as say } from "../words/links";
import { unpackFirst } from "./first";
import { pack, unpack } from "./pack";

export type Saved = Shapes & {
  readonly settings: Chosen;
  /** The preset that the shapes are, untouched; else null. */
  readonly preset: string | null;
  readonly view: View;
  /** 0 shows the identity, 1 the match. */
  readonly morph: number;
};

const VERSION = "2";

/** How loops were and are written. */
const READERS: Readonly<Record<string, (text: string) => Float64Array>> = { "1": unpackFirst, [VERSION]: unpack };

/** Parts of the morph that a link tells apart. */
const MORPH_STEPS = 1000;

/** Of loops that are in use; they never change. A morph that plays is written many times over the same two. */
const packed = new WeakMap<Loop, string>();

function packedOnce(loop: Loop): string {
  const text = packed.get(loop) ?? pack(loop);
  packed.set(loop, text);
  return text;
}

/** Whoever has no look of its own leaves it to the page's. */
type Written = Omit<Saved, "view" | "morph"> & Partial<Saved>;

export function encode(saved: Written): string {
  const { reference, template, pins, settings, preset, view = "grid", morph = 1 } = saved;
  const query = new URLSearchParams({ v: VERSION });
  if (preset) query.set("preset", preset);
  else {
    query.set("reference", reference.map(packedOnce).join("."));
    query.set("template", template.map(packedOnce).join("."));
  }
  if (pins.length > 0) query.set("pins", pack(flat(pins)));
  for (const field of FIELDS) {
    const value = settings[field.name];
    if (value !== undefined) query.set(field.name, String(value));
  }
  if (view !== "grid") query.set("view", view);
  const part = Math.round(MORPH_STEPS * morph) / MORPH_STEPS;
  if (part !== 1) query.set("morph", String(part));
  return query.toString();
}

/** Throws a sentence's part when the text is not what `encode` writes or has written. */
export function decode(text: string): Saved {
  const query = new URLSearchParams(text);
  const version = query.get("v");
  if (version === null) throw new Error(say.foreign);
  const read = Object.hasOwn(READERS, version) ? READERS[version] : undefined;
  if (!read) throw new Error(say.version(version));
  const shapes = shapesFrom(query, read);
  const look = { view: "grid" as const, morph: 1 };
  return { ...shapes, pins: pinsOf(query.get("pins") ?? "", read), ...overridden({ settings: {}, ...look }, query) };
}

/** Settings and look with what a query says instead. Throws a sentence's part for what it cannot be. */
export function overridden<T extends Pick<Saved, "settings" | "view" | "morph">>(saved: T, query: URLSearchParams): T {
  let { settings, view, morph } = saved;
  for (const field of FIELDS) {
    const value = query.get(field.name);
    if (value !== null) settings = withSetting(settings, field, parseSetting(field, value));
  }
  const name = query.get("view");
  if (name !== null) {
    const known = VIEWS.find((candidate) => candidate === name);
    if (!known) throw new Error(say.noView(name));
    view = known;
  }
  const part = query.get("morph");
  if (part !== null) {
    morph = part.trim() === "" ? Number.NaN : Number(part);
    if (!(morph >= 0 && morph <= 1)) throw new Error(say.noMorph(part));
  }
  return { ...saved, settings, view, morph };
}

type Reader = (text: string) => Float64Array;

function shapesFrom(query: URLSearchParams, read: Reader): Pick<Saved, "reference" | "template" | "preset"> {
  const id = query.get("preset");
  if (id === null) {
    const reference = shapeFrom(query.get("reference"), "reference", read);
    return { reference, template: shapeFrom(query.get("template"), "template", read), preset: null };
  }
  const preset = PRESETS.find((candidate) => candidate.id === id);
  if (!preset) throw new Error(say.noExample(id));
  return { reference: preset.reference, template: preset.template, preset: id };
}

function shapeFrom(text: string | null, side: "reference" | "template", read: Reader): Shape {
  if (text === null) throw new Error(say.missing(side));
  if (text === "") return [];
  return text.split(".").map((part, index) => {
    const loop = named(say.loop(index, side), part, read);
    if (loop.length < 6) throw new Error(say.tooFew(say.loop(index, side)));
    return loop;
  });
}

function pinsOf(text: string, read: Reader): readonly Pin[] {
  if (text === "") return [];
  const numbers = named(say.pins, text, read);
  if (numbers.length % 4 !== 0) throw new Error(say.cutOff(say.pins));
  if (numbers.length > 4 * MOST_PINS) throw new Error(say.manyPins(MOST_PINS));
  if (!numbers.every(isInBox)) throw new Error(say.pinOutside);
  return pinsFrom(numbers);
}

function named(what: string, text: string, read: Reader): Float64Array {
  try {
    return read(text);
  } catch (error) {
    const why = error instanceof Error ? error.message : "";
    if (why === "cut off") throw new Error(say.cutOff(what));
    throw new Error(why === "too long" ? say.tooLong(what) : say.damaged(what));
  }
}
