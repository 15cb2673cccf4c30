/** Die Seite innerhalb einer anderen. */

import type { Book } from "../book";

export const embed: Book["embed"] = {
  title: "Elastischer Abgleich zweier Kurven",
  begin: "In eine andere Seite einbetten …",
  what: "Das Einbetten",
  open: "In der Seite öffnen",
  openHelp: "Dieselben Formen und Einstellungen mit allem, was es gibt, in einem eigenen Tab",
  compare: "Vergleichen",

  noKind: (text, all) => `Die Adresse verlangt embed=${text}; möglich sind ${all}.`,
  noControl: (text, all) => `Die Adresse verlangt das Bedienelement „${text}“; möglich sind ${all}.`,
  noSetting: (text) => `Die Adresse verlangt die Einstellung „${text}“, die diese Seite nicht hat.`,
  noChange: (text) => `Die Adresse verlangt die Änderung „${text}“; sie muss wie bending:0 aussehen.`,
  noOrigin: (text) => `Die Adresse nennt „${text}“ als Ursprung (origin); er muss wie https://example.org aussehen.`,
  onlyCurves: "Nebeneinander vergleichen lassen sich in einem Rahmen nur Kurven.",

  dialog: {
    title: "In eine andere Seite einbetten",
    close: "Schließen",
    kind: "Was gezeigt wird",
    kinds: {
      result: "Das Ergebnis",
      compare: "Zwei Einstellungen nebeneinander",
      full: "Alles zum Zeichnen und Abgleichen",
    },
    size: "Größe",
    width: "Breite, Pixel",
    height: "Höhe, Pixel",
    controls: "Was man darin tun kann",
    names: {
      view: "Die Ansicht wählen",
      morph: "Den Übergang abspielen",
      numbers: "Die Zahlen lesen",
      terms: "Die Energien sehen, Terme weglassen",
      match: "Abgleichen, rückgängig machen, mitführen",
      link: "In der Seite öffnen",
    },
    setting: "Im zweiten anders",
    value: "Der Wert dort",
    run: "Sofort abgleichen, ohne Knopfdruck",
    snippet: "In die Seite zu kopieren",
    copy: "Kopieren",
    copied: "Kopiert",
    select: "Alles auswählen und kopieren",
    preview: "Vorschau",
    more: "Wie eine Seite mit ihrem Rahmen spricht, steht bei den Quellen in docs/embedding.md.",
  },
};
