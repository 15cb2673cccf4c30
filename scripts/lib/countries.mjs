// The gallery's countries, cut out of world-atlas while the page is built: nobody loads a whole world for thirty of them.

import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { feature } from "topojson-client";

const NAMES = [
  "Argentina",
  "Australia",
  "Austria",
  "Brazil",
  "Bulgaria",
  "Czechia",
  "Egypt",
  "Ethiopia",
  "Finland",
  "France",
  "Germany",
  "Hungary",
  "Iceland",
  "India",
  "Ireland",
  "Italy",
  "Kenya",
  "Madagascar",
  "Mongolia",
  "Nigeria",
  "Peru",
  "Poland",
  "Romania",
  "South Africa",
  "Spain",
  "Sri Lanka",
  "Switzerland",
  "Turkey",
  "Ukraine",
  "Uruguay",
];

const MODULE = "virtual:countries";

/**
 * A Vite plugin: `virtual:countries` is the text of a GeoJSON collection.
 *
 * @returns {import("vite").Plugin}
 */
export function countries() {
  return {
    name: "thinshell-countries",
    resolveId: (id) => (id === MODULE ? `\0${MODULE}` : undefined),
    load: (id) => (id === `\0${MODULE}` ? `export default ${JSON.stringify(geoJson())};` : undefined),
  };
}

function geoJson() {
  const file = fileURLToPath(import.meta.resolve("world-atlas/countries-50m.json"));
  /** @type {import("topojson-specification").Topology<{ countries: import("topojson-specification").GeometryCollection<{ name: string }> }>} */
  const world = JSON.parse(readFileSync(file, "utf8"));
  const { features } = feature(world, world.objects.countries);
  const chosen = NAMES.map((name) => {
    const found = features.find(({ properties }) => properties.name === name);
    if (!found) throw new Error(`world-atlas has no country called ${name}`);
    return { type: "Feature", properties: { name }, geometry: found.geometry };
  });
  // A thousandth of a degree is a hundred metres: finer than the atlas itself.
  return JSON.stringify({ type: "FeatureCollection", features: chosen }, (_, value) =>
    typeof value === "number" ? Math.round(1000 * value) / 1000 : value,
  );
}
