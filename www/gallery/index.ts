/**
 * Real silhouettes to try: countries and things. They come as GeoJSON and SVG and go through the same readers as
 * anybody's files. Loaded only when the gallery is opened.
 */

import countries from "virtual:countries";
import type { Found } from "../shapes/import/found";
import { readGeoJson } from "../shapes/import/geojson";
import { readSvg } from "../shapes/import/svg";
import { ICONS } from "./icons";

export type Silhouette = { readonly name: string; readonly found: Found };

export type Collection = {
  readonly title: string;
  readonly source: string;
  readonly address: string;
  readonly licence: string;
  readonly silhouettes: readonly Silhouette[];
};

export function collections(): readonly Collection[] {
  const { features } = JSON.parse(countries) as { features: readonly { properties: { name: string } }[] };
  return [
    {
      title: "Things",
      source: "Phosphor Icons",
      address: "https://phosphoricons.com",
      licence: "MIT licence",
      silhouettes: ICONS.map(({ name, svg }) => ({ name, found: readSvg(svg) })),
    },
    {
      title: "Countries",
      source: "Natural Earth, through world-atlas",
      address: "https://www.naturalearthdata.com",
      licence: "public domain; world-atlas: ISC licence",
      // Mainland only; “All parts” brings the islands.
      silhouettes: features.map((feature) => ({ name: feature.properties.name, found: readGeoJson(feature, true) })),
    },
  ];
}
