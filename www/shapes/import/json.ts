/** JSON: polygons by name, this page's own files, and GeoJSON. */

import { FORMAT } from "./format";
import { type Choice, type Found, ImportError } from "./found";
import { isGeoJson, readGeoJson } from "./geojson";
import { choicesFrom, shapeFromLoops } from "./loops";

export function readJson(text: string): Found {
  let content: unknown;
  try {
    content = JSON.parse(text);
  } catch (error) {
    const why = error instanceof Error ? error.message : String(error);
    throw new ImportError(`The JSON is broken (${why}); save it again, whole.`);
  }
  if (isRecord(content) && content.format === FORMAT) return { kind: "saved", content };
  if (isRecord(content) && content.type === "Topology") {
    throw new ImportError("This is TopoJSON; convert it to GeoJSON first.");
  }
  if (isGeoJson(content)) return readGeoJson(content);
  const list = Array.isArray(content) && !isPoint(content[0]) && !isPoints(content[0]) ? content : [content];
  if (list.length === 0) throw new ImportError("The list in the JSON is empty.");
  return { kind: "shapes", choices: choicesFrom(list, nameOf, choice), notes: [] };
}

function nameOf(item: unknown, index: number): string {
  return isRecord(item) && typeof item.name === "string" ? item.name : `Shape ${index + 1}`;
}

/** `{name, class?, points}` or `{name, loops}`, or bare points or loops. */
function choice(item: unknown, named: string): Choice {
  const content = isRecord(item) ? (item.points ?? item.loops ?? item.polygon) : item;
  if (!Array.isArray(content) || content.length === 0) {
    throw new ImportError(
      `${named} has no points; the JSON should be a list of {"name": …, "points": [[x, y], …]}, GeoJSON, or a file saved here.`,
    );
  }
  const loops = isPoint(content[0]) ? [content] : content;
  return shapeFromLoops(
    named,
    loops.map((loop: unknown) => flat(loop, named)),
  );
}

function flat(loop: unknown, name: string): Float64Array {
  if (!Array.isArray(loop)) throw new ImportError(`${name} has something that is no list of points.`);
  const out = new Float64Array(2 * loop.length);
  loop.forEach((point: unknown, i) => {
    if (!isPoint(point)) throw new ImportError(`Point ${i + 1} of ${name} is not [x, y] with two finite numbers.`);
    out[2 * i] = point[0];
    out[2 * i + 1] = point[1];
  });
  return out;
}

function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

function isPoint(value: unknown): value is readonly [number, number] {
  return Array.isArray(value) && value.length >= 2 && value.slice(0, 2).every((part) => Number.isFinite(part));
}

function isPoints(value: unknown): boolean {
  return Array.isArray(value) && value.length > 0 && isPoint(value[0]);
}
