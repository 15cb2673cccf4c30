/**
 * What the address of an embedded page asks for, and such addresses made: `?embed=result&controls=view,morph#v=2&…`.
 * What stands before the # is how the frame looks, what stands behind it is what the page shows anywhere.
 */

import { FIELDS, parseSetting, type SettingField, withSetting } from "../settings";
import { embed as say } from "../words/embed";

export const KINDS = ["result", "compare", "full"] as const;
export type Kind = (typeof KINDS)[number];

export const CONTROLS = ["view", "morph", "numbers", "terms", "match", "link"] as const;
export type Control = (typeof CONTROLS)[number];

/** One setting with a value of its own, for one side of a comparison. */
export type Change = { readonly field: SettingField; readonly value: number | string | boolean };

export type Asked = {
  readonly kind: Kind;
  readonly controls: ReadonlySet<Control>;
  /** The settings that can be changed in the frame. */
  readonly sliders: readonly SettingField[];
  /** Of a comparison: what is other than in the settings of the link. */
  readonly sides: readonly [Change | null, Change | null];
  /** The only origin that is obeyed; any parent's where none is named. */
  readonly origin: string | null;
};

/** What a frame has where the address does not say. */
export const USUAL: Readonly<Record<Kind, readonly Control[]>> = {
  result: ["view", "morph", "numbers", "link"],
  compare: ["view", "morph", "link"],
  full: ["view", "morph", "numbers", "match", "link"],
};

/** Null where nothing is to be embedded. Throws a sentence for what cannot be asked. */
export function asked(search: string): Asked | null {
  const query = new URLSearchParams(search);
  const text = query.get("embed");
  if (text === null) return null;
  const kind = oneOf(text, KINDS, say.noKind);
  const controls = listed(query.get("controls")) ?? USUAL[kind];
  const origin = query.get("origin");
  if (origin !== null && !isOrigin(origin)) throw new Error(say.noOrigin(origin));
  return {
    kind,
    controls: new Set(controls.map((name) => oneOf(name, CONTROLS, say.noControl))),
    sliders: (listed(query.get("sliders")) ?? []).map(fieldNamed),
    sides: [changeFrom(query.get("a")), changeFrom(query.get("b"))],
    origin,
  };
}

/** What an address of a frame is made of; `link` is what the page would have behind its #. */
export type Wish = {
  readonly kind: Kind;
  readonly controls: readonly Control[];
  readonly sliders?: readonly SettingField[];
  readonly sides?: Asked["sides"];
  /** Whether the match waits for a press. */
  readonly later: boolean;
  readonly link: string;
};

/** The inverse, over the page's own address. */
export function addressFor(page: string, { kind, controls, sliders = [], sides, later, link }: Wish): string {
  const url = new URL(page);
  const query = new URLSearchParams({ embed: kind });
  const usual = USUAL[kind];
  const isUsual = controls.length === usual.length && usual.every((name) => controls.includes(name));
  if (!isUsual) query.set("controls", controls.join(","));
  if (sliders.length > 0) query.set("sliders", sliders.map(({ name }) => name).join(","));
  for (const [index, name] of ["a", "b"].entries()) {
    const change = sides?.[index];
    if (change) query.set(name, `${change.field.name}:${change.value}`);
  }
  if (later) query.set("match", "later");
  // Commas and colons may stand in a query as they are, and are read more easily.
  url.search = query.toString().replaceAll("%2C", ",").replaceAll("%3A", ":");
  url.hash = link;
  return url.href;
}

/** What is put into another page. */
export function snippet(address: string, width: number, height: number): string {
  const source = address.replaceAll("&", "&amp;").replaceAll('"', "&quot;");
  return `<iframe src="${source}" width="${width}" height="${height}" title="${say.title}" loading="lazy" allow="clipboard-write" style="border: 0; max-width: 100%"></iframe>`;
}

/** Settings with the change of one side. */
export function changedBy<T extends Parameters<typeof withSetting>[0]>(settings: T, change: Change | null) {
  return change ? withSetting(settings, change.field, change.value) : settings;
}

function oneOf<T extends string>(text: string, all: readonly T[], words: (text: string, all: string) => string): T {
  const found = all.find((name) => name === text);
  if (!found) throw new Error(words(text, all.join(", ")));
  return found;
}

function listed(text: string | null): readonly string[] | null {
  return text === null ? null : text.split(",").filter((name) => name !== "");
}

function fieldNamed(name: string): SettingField {
  const field = FIELDS.find((candidate) => candidate.name === name);
  if (!field) throw new Error(say.noSetting(name));
  return field;
}

function changeFrom(text: string | null): Change | null {
  if (text === null) return null;
  const [name, value, ...more] = text.split(":");
  if (value === undefined || more.length > 0) throw new Error(say.noChange(text));
  const field = fieldNamed(name);
  return { field, value: parseSetting(field, value) };
}

/** As browsers write origins: nothing after the port. */
function isOrigin(text: string): boolean {
  return URL.canParse(text) && new URL(text).origin === text;
}
