/**
 * GeoJSON polygons, each feature a choice. Coordinates are longitudes and latitudes (RFC 7946) and are drawn in
 * Lambert's azimuthal equal-area projection about the middle of the feature, so that areas keep their proportions and
 * nothing is torn at the date line or sheared far north.
 */

import type { Loop } from "../geometry";
import { type Choice, type FoundShapes, ImportError } from "./found";
import { shapeFromLoops } from "./loops";

/** The smoothing that coasts begin with, in cells. */
const COAST = 1;

type Json = { readonly [key: string]: unknown };
type Ring = readonly (readonly number[])[];

const DEGREE = Math.PI / 180;
const AREAL = new Set(["Polygon", "MultiPolygon", "GeometryCollection"]);
const OTHERS = new Set(["Point", "MultiPoint", "LineString", "MultiLineString"]);

export function isGeoJson(value: unknown): value is Json {
  if (typeof value !== "object" || value === null) return false;
  const { type } = value as Json;
  return typeof type === "string" && (/^Feature(Collection)?$/.test(type) || AREAL.has(type) || OTHERS.has(type));
}

/** `mainPart` asks for each feature's largest part, unless the reader says otherwise. */
export function readGeoJson(content: Json, mainPart = false): FoundShapes {
  const features = content.type === "FeatureCollection" ? list(content.features, "features") : [content];
  const choices: Choice[] = [];
  features.forEach((feature, index) => {
    const bare =
      (feature as Json)?.type === "Feature" ? ((feature as Json).geometry as Json | null) : (feature as Json);
    const name = nameOf(feature as Json, index);
    const polygons = polygonsOf(bare, name);
    if (polygons.length > 0)
      choices.push(shapeFromLoops(name, projected(polygons.flat(), name), { mainPart, smoothing: COAST }));
  });
  if (choices.length === 0) {
    throw new ImportError("The GeoJSON has no polygons, only points or lines; choose a file with areas.");
  }
  const left = features.length - choices.length;
  return { kind: "shapes", choices, notes: left > 0 ? [`Features without an area are left out: ${left}.`] : [] };
}

function polygonsOf(geometry: Json | null, name: string): readonly Ring[][] {
  switch (geometry?.type) {
    case "Polygon":
      return [list(geometry.coordinates, name) as Ring[]];
    case "MultiPolygon":
      return list(geometry.coordinates, name) as Ring[][];
    case "GeometryCollection":
      return list(geometry.geometries, name).flatMap((part) => polygonsOf(part as Json, name));
    default:
      return [];
  }
}

function list(value: unknown, name: string): readonly unknown[] {
  if (!Array.isArray(value)) throw new ImportError(`The GeoJSON is damaged: ${name} is not a list.`);
  return value;
}

function nameOf(feature: Json, index: number): string {
  const properties = (feature.properties ?? {}) as Json;
  for (const key of ["name", "NAME", "Name", "admin", "ADMIN", "title", "id"]) {
    if (typeof properties[key] === "string") return properties[key];
  }
  return typeof feature.id === "string" ? feature.id : `Feature ${index + 1}`;
}

/** Rings without their repeated last point, projected about the mean direction of all their points. */
function projected(rings: readonly Ring[], name: string): Loop[] {
  const directions = rings.map((ring) =>
    ring.map((point, i) => {
      const [longitude, latitude] = Array.isArray(point) ? point : [];
      if (!Number.isFinite(longitude) || !Number.isFinite(latitude)) {
        throw new ImportError(`Position ${i + 1} of ${name} is not [longitude, latitude].`);
      }
      if (Math.abs(latitude) > 90 || Math.abs(longitude) > 360) {
        throw new ImportError(
          `Position ${i + 1} of ${name} is ${longitude}, ${latitude}, which are no degrees; GeoJSON needs WGS 84.`,
        );
      }
      return direction(longitude, latitude);
    }),
  );
  // The sum over edges, weighted by length: long coasts do not outweigh their smooth opposite side by their points.
  const sum = [0, 0, 0];
  for (const ring of directions) {
    ring.forEach((here, i) => {
      const next = ring[(i + 1) % ring.length];
      const weight = Math.hypot(next[0] - here[0], next[1] - here[1], next[2] - here[2]);
      for (let k = 0; k < 3; k += 1) sum[k] += weight * here[k];
    });
  }
  const size = Math.hypot(sum[0], sum[1], sum[2]);
  if (!(size > 0)) throw new ImportError(`${name} encloses no area.`);
  const centre = sum.map((part) => part / size);
  const east = unit([-centre[1], centre[0], 0]);
  const north = [
    centre[1] * east[2] - centre[2] * east[1],
    centre[2] * east[0] - centre[0] * east[2],
    centre[0] * east[1] - centre[1] * east[0],
  ];
  return directions.map((ring) => {
    const last = ring[ring.length - 1];
    const repeats = ring.length > 1 && last.every((part, k) => Math.abs(part - ring[0][k]) < 1e-12);
    const open = repeats ? ring.slice(0, -1) : ring;
    return Float64Array.from(
      open.flatMap((at) => {
        const cosine = Math.max(-1, dot(at, centre));
        // ρ = √(2 / (1 + cos c)): areas on the plane are areas on the unit sphere.
        const scale = Math.sqrt(2 / Math.max(1e-9, 1 + cosine));
        return [scale * dot(at, east), scale * dot(at, north)];
      }),
    );
  });
}

function direction(longitude: number, latitude: number): readonly number[] {
  const cosine = Math.cos(latitude * DEGREE);
  return [cosine * Math.cos(longitude * DEGREE), cosine * Math.sin(longitude * DEGREE), Math.sin(latitude * DEGREE)];
}

function dot(a: readonly number[], b: readonly number[]): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** At a pole every direction is south; any will do. */
function unit(v: readonly number[]): readonly number[] {
  const size = Math.hypot(v[0], v[1], v[2]);
  return size > 1e-12 ? v.map((part) => part / size) : [1, 0, 0];
}
