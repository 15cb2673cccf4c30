/** Die Einstellungen und die Beispiele. Das Zeichen steht beim Wort, wo es keinen Index hat. */

import type { Book } from "../book";

export const settings: Book["settings"] = {
  membrane: {
    label: "Streckung",
  },
  membraneModel: {
    label: "Stauchung zählt",
    options: [{ label: "entlang der bewegten Kurve" }, { label: "entlang des Ziels" }],
  },
  bending: {
    label: "Biegung",
  },
  bendingModel: {
    label: "Biegung vergleicht",
    options: [{ label: "Formoperatoren" }, { label: "mittlere Krümmungen" }],
  },
  thickness: {
    label: "Dicke δ",
    unit: "Seitenlängen",
  },
  penalty: {
    label: "Abweichung 1/ε",
    unit: "je Seitenlänge²",
  },
  tangency: {
    label: "Tangentialität ρ",
    unit: "Zellen",
  },
  pinWeight: {
    label: "Stärke der Nadeln",
  },
  volume: {
    label: "Volumen ξ",
  },
  finest: { label: "Feinstes Gitter" },
  bandwidth: {
    label: "Band σ",
    unit: "Seitenlängen",
  },
  vertexShare: {
    label: "Eckenanteil θ",
  },
  halving: {
    label: "Je feinerem Gitter",
    options: [{ label: "δ und ε halbieren" }, { label: "δ und ε behalten" }],
  },
  align: {
    label: "Beginn",
    options: [{ label: "die beste Ähnlichkeit" }, { label: "die Identität" }],
  },
  minimizer: {
    label: "Minimierer",
    options: [{ label: "projiziertes Newton-Verfahren" }, { label: "konjugierte Gradienten" }],
  },
  backend: {
    label: "Gerechnet von",
    options: [{ label: "dem Schnelleren" }, { label: "dem Prozessor" }, { label: "der Grafikkarte" }],
  },
};

export const helps: Book["helps"] = {
  membrane: "Wie sehr sich die Schale dagegen wehrt, entlang der Kurve gestreckt zu werden. 0 lässt den Term weg.",
  membraneModel:
    "Entlang der bewegten Kurve, wie im Artikel, kann eine Kurve, die schrumpfen muss, stattdessen zerknittern; entlang des Ziels hilft ihr das nicht.",
  bending: "Wie sehr sich die Schale gegen eine Änderung der Krümmung wehrt. 0 lässt den Term weg.",
  bendingModel:
    "Der relative Formoperator sieht auch Richtungen; die mittlere Krümmung allein ist die einfachere Wahl.",
  thickness: "Der Schale, auf dem gröbsten Gitter. Streckung zählt δ-fach, Biegung δ³-fach.",
  penalty: "Wie stark die Referenz auf das Ziel gezogen wird, auf dem gröbsten Gitter.",
  tangency:
    "Hält die bewegte Kurve längs des Ziels statt in Wellen um es herum. Auf gröberen Gittern das Vierfache. 0 ist wie im Artikel.",
  pinWeight: "Wie stark Nadeln ziehen, im Verhältnis zu 1/ε. Bei 0 wirken sie nicht.",
  volume: "Wie sehr sich die Ebene um die Kurve gegen eine Verformung wehrt.",
  finest: "Bis zu diesem Gitter wird der Abgleich verfeinert.",
  bandwidth: "Halbe Breite des Bandes der Schale um die Referenz. 0 wählt sie nach dem feinsten Gitter.",
  vertexShare:
    "Anteil des Volumenterms, der an den Ecken der Zellen genommen wird und sie davor bewahrt, sich dort zu falten. 0 ist wie im Artikel.",
  halving: "Dicke und ε mit der Zellgröße zu halbieren schärft den Abgleich von Stufe zu Stufe.",
  align:
    "Die beste Ähnlichkeit verschiebt, dreht und skaliert die Referenz zuerst auf das Ziel zu; der Artikel beginnt mit der Identität.",
  minimizer:
    "Das Newton-Verfahren macht wenige teure Schritte, die konjugierten Gradienten des Artikels viele billige.",
  backend: "Wer rechnet. Eine Grafikkarte lohnt sich, wo Gitter groß sind.",
};

export const presets: Book["presets"] = {
  ellipse: { title: "Kreis → Ellipse" },
  star: { title: "Stern → gedrehter Stern" },
  square: { title: "Abgerundetes Quadrat → um 30° gedreht" },
  blobs: { title: "Zwei Kleckse" },
  leaf: { title: "Blatt → gelapptes Blatt" },
  letters: { title: "L → C" },
  clover: { title: "Langer Klee → kurzer Kreis" },
  ring: { title: "Ring → verschobener Ring" },
  fish: { title: "Fisch → schwimmender Fisch" },
  hand: { title: "Hand → gespreizte Hand" },
  ears: { title: "Katze → Hase" },
  heart: { title: "Herz → Tropfen" },
  pairs: { title: "Zwei Teile → zwei Teile" },
  moon: { title: "Bohne → Sichel" },
};
