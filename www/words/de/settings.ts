/** Die Einstellungen und die Beispiele. Das Zeichen steht beim Wort, wo es keinen Index hat. */

import type { Book } from "../book";

export const settings: Book["settings"] = {
  membrane: {
    label: "Streckung",
    help: "Wie sehr sich die Schale dagegen wehrt, entlang der Kurve gestreckt zu werden. 0 lässt den Term weg.",
  },
  membraneModel: {
    label: "Stauchung zählt",
    help: "Entlang der bewegten Kurve, wie im Artikel, kann eine Kurve, die schrumpfen muss, stattdessen zerknittern; entlang des Ziels hilft ihr das nicht.",
    options: [{ label: "entlang der bewegten Kurve" }, { label: "entlang des Ziels" }],
  },
  bending: {
    label: "Biegung",
    help: "Wie sehr sich die Schale gegen eine Änderung der Krümmung wehrt. 0 lässt den Term weg.",
  },
  bendingModel: {
    label: "Biegung vergleicht",
    help: "Der relative Formoperator sieht auch Richtungen; die mittlere Krümmung allein ist die einfachere Wahl.",
    options: [{ label: "Formoperatoren" }, { label: "mittlere Krümmungen" }],
  },
  thickness: {
    label: "Dicke δ",
    help: "Der Schale, auf dem gröbsten Gitter. Streckung zählt δ-fach, Biegung δ³-fach.",
    unit: "Seitenlängen",
  },
  penalty: {
    label: "Anpassung 1/ε",
    help: "Wie stark die Referenz auf das Ziel gezogen wird, auf dem gröbsten Gitter.",
    unit: "je Seitenlänge²",
  },
  tangency: {
    label: "Tangentialität ρ",
    help: "Hält die bewegte Kurve längs des Ziels statt in Wellen um es herum. Auf gröberen Gittern das Vierfache. 0 ist wie im Artikel.",
    unit: "Zellen",
  },
  pinWeight: {
    label: "Stärke der Nadeln",
    help: "Wie stark Nadeln ziehen, im Verhältnis zur Anpassung. Bei 0 wirken sie nicht.",
  },
  volume: {
    label: "Volumen ξ",
    help: "Wie sehr sich die Ebene um die Kurve gegen eine Verformung wehrt.",
  },
  finest: { label: "Feinstes Gitter", help: "Bis zu diesem Gitter wird der Abgleich verfeinert." },
  bandwidth: {
    label: "Band σ",
    help: "Halbe Breite des Bandes der Schale um die Referenz. 0 wählt sie nach dem feinsten Gitter.",
    unit: "Seitenlängen",
  },
  vertexShare: {
    label: "Eckenanteil θ",
    help: "Anteil des Volumenterms, der an den Ecken der Zellen genommen wird und sie davor bewahrt, sich dort zu falten. 0 ist wie im Artikel.",
  },
  halving: {
    label: "Je feinerem Gitter",
    help: "Dicke und ε mit der Zellgröße zu halbieren schärft den Abgleich von Stufe zu Stufe.",
    options: [{ label: "δ und ε halbieren" }, { label: "δ und ε behalten" }],
  },
  align: {
    label: "Beginn",
    help: "Die beste Ähnlichkeit verschiebt, dreht und skaliert die Referenz zuerst auf das Ziel zu; der Artikel beginnt mit der Identität.",
    options: [{ label: "die beste Ähnlichkeit" }, { label: "die Identität" }],
  },
  minimizer: {
    label: "Minimierer",
    help: "Das Newton-Verfahren macht wenige teure Schritte, die konjugierten Gradienten des Artikels viele billige.",
    options: [{ label: "projiziertes Newton-Verfahren" }, { label: "konjugierte Gradienten" }],
  },
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
