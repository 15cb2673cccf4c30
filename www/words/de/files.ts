/** Dateien und Links. */

import type { Book } from "../book";
import { brief } from "../links";
import { written } from "../numbers";
import type { Side } from "../sides";
import { again } from "./again";
import { SILHOUETTES } from "./silhouettes";

const NAMES: Readonly<Record<Side, string>> = { reference: "Referenz", template: "Ziel" };

export const links: Book["links"] = {
  unread: (why) =>
    `Der Link konnte nicht gelesen werden: ${why}. Stattdessen sehen Sie, was ohne ihn hier wäre; bitten Sie um einen neuen Link, um die anderen zu sehen.`,
  lost: (why) =>
    `Was hier zuletzt war, konnte nicht gelesen werden: ${why}. Es bleibt unter „Letzte Sitzungen“; stattdessen sehen Sie das erste Beispiel.`,
  kept: (why) => `Der Link konnte nicht gelesen werden: ${why}. Alles bleibt, wie es war.`,
  override: (why) => `Die Adresse verlangt etwas Unmögliches: ${why}. Alles Übrige ist zu sehen.`,
  foreign: "er ist kein Link dieser Seite",
  version: (version) => `die Version „${brief(version)}“ ist unbekannt`,
  noExample: (id) => `es gibt kein Beispiel namens „${brief(id)}“`,
  missing: (side) => `es fehlt: ${NAMES[side]}`,
  loop: (index, side) => `Kurve ${index} (${NAMES[side]})`,
  pins: "Liste der Nadeln",
  damaged: (what) => `beschädigt: ${what}`,
  cutOff: (what) => `abgeschnitten: ${what}`,
  tooLong: (what) => `zu lang: ${what}`,
  tooFew: (what) => `weniger als drei Punkte: ${what}`,
  manyPins: (most) => `es sind mehr als ${most} Nadeln`,
  pinOutside: "eine Nadel liegt außerhalb des Quadrats",
  noView: (view) => `es gibt keine Ansicht namens „${brief(view)}“`,
  noMorph: (text) => `der Übergang ist „${brief(text)}“, muss aber eine Zahl von 0 bis 1 sein`,
  noChoice: (label, given, known) => `${label} ist „${given}“, muss aber eines sein von: ${known}`,
  noNumber: (label, given, least, most) =>
    `${label} ist „${given}“, muss aber eine Zahl von ${written(String(least))} bis ${written(String(most))} sein`,
};

export const files: Book["files"] = {
  noVideo: "Dieser Browser hat kein Video aufgenommen; der Übergang ist als GIF gespeichert.",
  noMatch: "Es gibt noch keinen Abgleich zu speichern; drücken Sie erst „Abgleichen“.",
  empty: "Die Datei ist leer geblieben; versuchen Sie es noch einmal, oder speichern Sie in einem anderen Format.",
  recorder: "die Aufnahme ist gescheitert",
  noPicture: "Der Browser konnte das Bild nicht erzeugen; vielleicht fehlt ihm Speicher.",
  noCanvas: "Der Browser bietet keine Fläche, auf die das Bild gezeichnet werden könnte.",
  matchTitle: "Verformtes Gitter und zugeordnete Kurve",
  shapesTitle: "Referenz und Ziel",

  version: (found, known) => `Die Datei hat die Version ${found}; diese Seite liest die Version ${known}.`,
  setting: (name) => `Die Datei hat eine Einstellung „${name}“, die diese Seite nicht kennt.`,
  deformation: (found, level, needed) =>
    `Die Verformung hat ${found} Zahlen, aber die Stufe ${level} braucht ${needed}; speichern Sie sie neu.`,
  folded: "Die Verformung faltet die Ebene, was kein Abgleich dieser Seite tut; speichern Sie sie neu.",
  unlike: "Die zugeordneten Kurven haben nicht die Punkte der Referenz; speichern Sie den Abgleich neu.",
  damaged: (what) => `Die Datei ist beschädigt: ${what}; speichern Sie sie neu.`,
  manyPins: (most) => `sie hat mehr als ${most} Nadeln`,
  outside: (name) => `${name} ist kein Punkt des Quadrats`,
  manyNumbers: (name) => `${name} hat mehr als zwei Zahlen`,
  missing: (name) => `${name} fehlt oder ist von falscher Art`,
  noList: (name) => `${name} ist keine Liste`,
  noNumber: (name) => `${name} ist keine Zahl`,
  strange: (name, found) => `${name} ist ${found}, was kein Abgleich hat`,
};

export const imports: Book["imports"] = {
  words: again,
  close: "Schließen",
  pastedText: "dem eingefügten Text",
  picture: "dem Bild",
  useAs: (side) => `Als ${NAMES[side]} nehmen`,
  preparing: "Die Form wird vorbereitet …",
  reading: "Wird gelesen …",
  name: "Import",
  stop: "Anhalten",
  choose: "Datei wählen",
  gallery: "Galerie",
  formats:
    "SVG oder dessen Pfaddaten, PNG, JPEG, WebP, JSON, GeoJSON, TPS, CSV oder ein hier gespeicherter Abgleich. Sie können eine Datei auch irgendwo auf der Seite ablegen oder ein Bild oder einen Text einfügen.",
  paste: "Text hier einfügen",
  pasteName: "Text in SVG, Pfaddaten, JSON oder CSV",
  savedMatch: (grid) => `Ein gespeicherter Abgleich auf dem Gitter ${grid}, mit seinen Formen und Einstellungen.`,
  savedShapes: "Zwei gespeicherte Formen mit ihren Einstellungen, noch nicht abgeglichen.",
  openAll: "Alles öffnen",
  only: { reference: "Nur die Referenz", template: "Nur das Ziel" },
  preview: (what) => `Vorschau: ${what}`,
  nothing: "nichts zu zeigen",
  counts: (loops, points) => `${loops} ${loops === 1 ? "Kurve" : "Kurven"}, ${points} Punkte`,
  from: (source) => `Aus: ${source}`,
  options: {
    shape: "Form",
    parts: "Teile",
    holes: "Löcher",
    smoothing: "Glättung",
    place: "Lage",
    inside: "Innen ist",
    threshold: "Schwelle",
    automatic: "Automatische Schwelle",
  },
  parts: { all: "alle", largest: "nur der größte" },
  holes: { keep: "behalten", fill: "füllen" },
  smoothings: { 0: "keine", 0.5: "eine halbe Zelle", 1: "eine Zelle", 2: "zwei Zellen", 4: "vier Zellen" },
  places: { asIs: "wie in der Datei", fit: "skaliert und zentriert" },
  insides: { dark: "was dunkel oder deckend ist", light: "was hell oder durchsichtig ist" },
  galleryWhat: "die Galerie",
  galleryLoading: "Die Galerie wird geladen …",
  silhouette: (english) => SILHOUETTES[english] ?? english,
  collections: { things: "Dinge", countries: "Länder" },
  credits: {
    countries: "Natural Earth, über world-atlas",
    publicDomain: "gemeinfrei; world-atlas: ISC-Lizenz",
    mit: "MIT-Lizenz",
  },
  sourceFrom: "Aus",
};
