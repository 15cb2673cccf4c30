/**
 * Real silhouettes to try: countries and things. They come as GeoJSON and SVG and go through the same readers as
 * anybody's files. Loaded only when the gallery is opened.
 */

import countries from "virtual:countries";
import { prepared } from "../shapes/import/fit";
import type { FoundShapes } from "../shapes/import/found";
import { readGeoJson } from "../shapes/import/geojson";
import { readSvg } from "../shapes/import/svg";
import { imports } from "../words/imports";
import { ICONS } from "./icons";

export type Silhouette = {
  readonly name: string;
  readonly found: FoundShapes;
  /** As path data for a small picture: where the import puts it in the box, y down. */
  readonly path: string;
};

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
      title: imports.collections.things,
      source: "Phosphor Icons",
      address: "https://phosphoricons.com",
      licence: imports.credits.mit,
      silhouettes: ICONS.map(({ name, svg }) => silhouette(name, readSvg(svg))),
    },
    {
      title: imports.collections.countries,
      source: imports.credits.countries,
      address: "https://www.naturalearthdata.com",
      licence: imports.credits.publicDomain,
      // Mainland only; “All parts” brings the islands.
      silhouettes: features.map((feature) => silhouette(feature.properties.name, readGeoJson(feature, true))),
    },
  ];
}

function silhouette(name: string, found: FoundShapes): Silhouette {
  const [choice] = found.choices;
  const { shape } = prepared(choice.loops, {
    parts: choice.mainPart ? "largest" : "all",
    holes: "keep",
    placement: "fit",
    smoothing: choice.smoothing,
  });
  const path = shape
    .map((loop) => {
      let text = "";
      for (let i = 0; i < loop.length; i += 4) {
        text += `${i === 0 ? "M" : "L"}${loop[i].toFixed(3)} ${(1 - loop[i + 1]).toFixed(3)}`;
      }
      return `${text}Z`;
    })
    .join("");
  return { name, found, path };
}
