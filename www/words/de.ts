/** Deutsch: dieselben Sätze wie auf Englisch, in derselben Gestalt. Kommt erst, wenn es verlangt wird. */

import type { Book } from "./book";
import { batch } from "./de/batch";
import { exchange, guides, outline, pinActions, pinReports, pinsTold, strokes, told, tools } from "./de/drawing";
import { embed } from "./de/embed";
import { experiments, experimentTexts } from "./de/experiments";
import { files, imports, links } from "./de/files";
import { captions, later, memory, offline, recent } from "./de/later";
import { lessons } from "./de/lessons";
import { page } from "./de/page";
import { experimentsFile, indexFile, lessonsFile } from "./de/prose";
import { save } from "./de/save";
import { helps, presets, settings } from "./de/settings";
import { pairsOfSurfaces, space, surfaces, way } from "./de/space";

export const de: Book = {
  en: page,
  later,
  captions,
  embed,
  lessons,
  links,
  save,
  memory,
  recent,
  offline,
  numbers: { point: ",", undefined: "nicht bestimmt", above: "über alle Grenzen", below: "unter alle Grenzen" },
  place: { at: (x, y) => `${x} von links, ${y} von unten` },
  tools,
  exchange,
  guides,
  outline,
  told,
  strokes,
  pinActions,
  pinsTold,
  pinReports,
  files,
  imports,
  batch,
  settings,
  helps,
  presets,
  way,
  space,
  surfaces,
  pairsOfSurfaces,
  experiments,
  experimentTexts,
  indexFile,
  experimentsFile,
  lessonsFile,
};
