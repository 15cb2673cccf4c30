/**
 * A pair of surfaces, its settings and how it is looked at as text, for the address: `space=1&reference=…&template=…`,
 * then `pins`, the settings that differ from their defaults, and `view`, `morph`, `plane` and `camera` where they do.
 */

import { type Chosen, parseSetting, withSetting } from "../settings";
import { space as say } from "../words/space";
import { type Pose, START } from "./camera";
import { flat, MOST_PINS, type Pin, pinsFrom } from "./pins";
import { FIRST_LOOK, type Look, type Step, VIEWS } from "./session";
import { SPACE_FIELDS } from "./settings";

export type Linked = {
  /** Names of the gallery, or keys of what is kept. */
  readonly reference: string;
  readonly template: string;
  readonly pins: readonly Pin[];
  readonly settings: Chosen;
  readonly look: Look;
};

type Named = Pick<Step, "pins" | "settings"> & Record<"reference" | "template", { readonly id: string }>;

export function encode({ reference, template, pins, settings }: Named, { view, morph, plane, pose }: Look): string {
  const query = new URLSearchParams({ space: "1", reference: reference.id, template: template.id });
  if (pins.length > 0) query.set("pins", Array.from(flat(pins), short).join(","));
  for (const { name } of SPACE_FIELDS) {
    const value = settings[name];
    if (value !== undefined) query.set(name, String(value));
  }
  if (view !== FIRST_LOOK.view) query.set("view", view);
  if (morph !== 1) query.set("morph", short(morph));
  if (view === "slice") query.set("plane", `${plane.axis},${short(plane.part)}`);
  const { azimuth, elevation, zoom, right, up } = pose;
  if (pose !== START) query.set("camera", [azimuth, elevation, zoom, right, up].map(short).join(","));
  return query.toString();
}

/** Throws a sentence's part for what is no such text. */
export function decode(text: string): Linked {
  const query = new URLSearchParams(text);
  let settings: Chosen = {};
  for (const field of SPACE_FIELDS) {
    const value = query.get(field.name);
    if (value !== null) settings = withSetting(settings, field, parseSetting(field, value));
  }
  const view = VIEWS.find((candidate) => candidate === query.get("view")) ?? FIRST_LOOK.view;
  const [morph = 1] = numbers(query.get("morph"), [[0, 1]]);
  const [axis, part] = numbers(query.get("plane"), [
    [0, 2],
    [0, 1],
  ]);
  const plane = part === undefined ? FIRST_LOOK.plane : { axis: Math.round(axis), part };
  return {
    reference: query.get("reference") ?? "sphere",
    template: query.get("template") ?? "ellipsoid",
    pins: pinsOf(query.get("pins")),
    settings,
    look: { view, morph, plane, pose: poseFrom(query.get("camera")) },
  };
}

function pinsOf(text: string | null): Pin[] {
  const count = text === null ? 0 : Math.min(MOST_PINS, Math.ceil(text.split(",").length / 6));
  return pinsFrom(
    numbers(
      text,
      Array.from({ length: 6 * count }, () => [0, 1] as const),
    ),
  );
}

function poseFrom(text: string | null): Pose {
  const [azimuth, elevation, zoom, right, up] = numbers(text, [
    [-4, 4],
    [-1.57, 1.57],
    [0.5, 8],
    [-0.5, 0.5],
    [-0.5, 0.5],
  ]);
  return up === undefined ? START : { azimuth, elevation, zoom, right, up };
}

/** As many numbers as there are ranges, each within its own; else none. */
function numbers(text: string | null, ranges: readonly (readonly [least: number, most: number])[]): readonly number[] {
  if (text === null) return [];
  const found = text.split(",").map((part) => (part.trim() === "" ? Number.NaN : Number(part)));
  const fits =
    found.length === ranges.length && ranges.every(([least, most], k) => found[k] >= least && found[k] <= most);
  if (!fits) throw new Error(say.links.number(text));
  return found;
}

function short(value: number): string {
  return String(Math.round(1000 * value) / 1000);
}
