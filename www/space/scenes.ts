/** What each of the three views shows, made of the session's state. */

import { amounts, clipped, factors, quantile, roundUp, type Scale } from "../view/scales";
import { space as say } from "../words/space";
import { colours, plainColours, scaleColours } from "./colours";
import { nearest } from "./measure";
import type { Result, View } from "./session";
import { cut, gridLines, type Plane } from "./slice";
import { areaRatios, normals, type Solid } from "./solid";
import type { Lines, Scene, Skin } from "./stage";

/** What is measured of a match that is final, one number a vertex of the reference. */
export type Maps = {
  readonly area: Float64Array;
  /** In cells of the grid that was matched. */
  readonly distance: Float64Array;
  /** The template's vertex that is nearest to each moved one. */
  readonly partners: Uint32Array;
};

const measured = new WeakMap<Result, Maps>();

export function mapsOf(result: Result): Maps {
  const known = measured.get(result);
  if (known) return known;
  const { reference, template, frame } = result;
  const { distances, vertices } = nearest(frame.matched, template);
  const cells = 2 ** frame.status.level;
  const maps = {
    area: areaRatios(reference.positions, frame.matched, reference.indices),
    distance: distances.map((distance) => cells * distance),
    partners: vertices,
  };
  measured.set(result, maps);
  return maps;
}

/** Of the view's numbers; null where colours are no numbers, or the match is still moving. */
export function scaleOf(result: Result | null, view: View, dark: boolean, moving: boolean): Scale | null {
  if (!result || moving || view === "colours" || view === "slice") return null;
  const values = mapsOf(result)[view];
  const scale =
    view === "distance"
      ? amounts(say.distance, say.cells, roundUp(quantile(values, 1)))
      : factors(
          say.area,
          dark,
          Math.max(
            0.25,
            quantile(
              values.map((ratio) => Math.abs(Math.log2(ratio))),
              0.98,
            ),
          ),
        );
  const parts = values.map((value) => scale.part(value));
  return clipped(scale, quantile(parts, 0), quantile(parts, 1));
}

export type Paint = {
  readonly result: Result | null;
  readonly view: View;
  readonly plane: Plane;
  readonly scale: Scale | null;
  readonly dark: boolean;
  readonly showsTarget: boolean;
};

export function referenceScene(reference: Solid, { result, view, scale, plane }: Paint): Scene {
  return {
    skins: [still(reference, referenceColours(reference, result, view, scale), { lined: !scale })],
    lines: [],
    cut: view === "slice" ? plane : null,
  };
}

/** Plain until the match says which of its points are partners of which. */
export function templateScene(template: Solid, { result, dark }: Paint): Scene {
  const partners = result?.template === template ? result.frame.partners : null;
  const painted = partners ? colours(partners) : plainColours(template.positions.length / 3, plainOf(dark));
  const seen = still(template, painted);
  return { skins: [{ ...seen, places: partners && Float32Array.from(partners) }], lines: [], cut: null };
}

export function resultScene(reference: Solid, template: Solid, paint: Paint): Scene {
  const { result, view, plane, scale, dark, showsTarget } = paint;
  const slices = view === "slice" && result !== null;
  const from = result?.reference ?? reference;
  const painted = referenceColours(from, result, view, scale);
  const skins = [skin(from, result?.frame.matched ?? from.positions, painted, { lined: !scale })];
  if (showsTarget) {
    const target = result?.template ?? template;
    skins.push(still(target, plainColours(target.positions.length / 3, plainOf(dark)), { opacity: 0.35 }));
  }
  const lines: Lines[] = [];
  if (slices) {
    const { deformation, matched, status } = result.frame;
    const tint: [number, number, number] = dark ? [0.45, 0.5, 0.6] : [0.55, 0.58, 0.65];
    lines.push({ ...gridLines(status.level, deformation, plane), colour: tint });
    const ink: [number, number, number] = dark ? [1, 1, 1] : [0, 0, 0];
    lines.push({ ...cut(from.positions, matched, from.indices, plane), colour: ink });
  }
  return { skins, lines, cut: slices ? plane : null };
}

function referenceColours(solid: Solid, result: Result | null, view: View, scale: Scale | null): Float32Array {
  if (scale && result && result.reference === solid && (view === "area" || view === "distance"))
    return scaleColours(mapsOf(result)[view], scale);
  return colours(solid.positions);
}

function plainOf(dark: boolean): readonly [number, number, number] {
  return dark ? [0.6, 0.52, 0.47] : [0.85, 0.77, 0.71];
}

/** Of a solid, which never changes. */
const known = new WeakMap<Solid, Pick<Skin, "from" | "fromNormals" | "indices">>();

type Finish = { readonly lined?: boolean; readonly opacity?: number };

function still(solid: Solid, painted: Float32Array, { lined = false, opacity = 1 }: Finish = {}): Skin {
  const fixed = known.get(solid) ?? {
    from: Float32Array.from(solid.positions),
    fromNormals: normals(solid.positions, solid.indices),
    indices: solid.indices,
  };
  known.set(solid, fixed);
  const { from, fromNormals } = fixed;
  return { ...fixed, to: from, toNormals: fromNormals, colours: painted, places: lined ? from : null, opacity };
}

function skin(solid: Solid, moved: ArrayLike<number>, painted: Float32Array, finish: Finish): Skin {
  const fixed = still(solid, painted, finish);
  if (moved === solid.positions) return fixed;
  return { ...fixed, to: Float32Array.from(moved), toNormals: normals(moved, solid.indices) };
}
