/** Was die Seite von Anfang an sagt. */

import type { Book } from "../book";
import { again } from "./again";
import { capital, DER } from "./sides";
import { approach, stop, unresolved, verdict } from "./solver";

export const page: Book["en"] = {
  actions: {
    match: "Abgleichen",
    live: "Live",
    liveHelp: "Der Abgleich folgt Ihrer Hand, während Sie eine Form oder eine Einstellung ändern",
    pause: "Anhalten",
    resume: "Fortsetzen",
    cancel: "Abbrechen",
    undo: "Rückgängig",
    redo: "Wiederholen",
    fit: "Einpassen",
    drawAgain: "Neu zeichnen",
    dismiss: "Verstanden",
    matchOn: (grid) => `Auf ${grid} abgleichen`,
  },

  sketch: {
    names: { reference: "Referenz", template: "Ziel" },
    surface: { reference: "Form der Referenz", template: "Form des Ziels" },
    clear: "Leeren",
    clearSide: (side) => `Leeren: ${DER[side]}`,
    invitation: "Zeichnen Sie hier eine geschlossene Kurve",
  },

  imports: {
    name: "Importieren",
    of: (side) => `Importieren: ${DER[side]}`,
    help: (side) => `${capital(DER[side])} aus einer Zeichnung, einem Bild, einer Punktliste oder der Galerie nehmen`,
    what: "Der Import",
    loading: "Der Import wird geladen …",
  },

  parts: {
    energies: "Energien über den Iterationen",
    runs: "Bisherige Läufe",
    compare: "Nebeneinander vergleichen",
    settings: "Einstellungen",
    changed: (count) => `(${count} geändert)`,
    named: (title) => `„${title}“`,
    loading: "Wird geladen …",
  },

  missing: {
    sentence: (what) =>
      `Nicht geladen: ${what}. Prüfen Sie die Verbindung und versuchen Sie es noch einmal, oder laden Sie die Seite neu.`,
    tool: "was dieses Werkzeug braucht",
    draw: "was zum Zeichnen nötig ist",
    pins: "was Nadeln brauchen",
    view: "diese Ansicht",
    files: "was Dateien speichert",
    language: "diese Sprache",
  },

  solver: {
    words: again,
    refused:
      "Der Löser ließ sich nicht starten, weil der Browser den Worker der Seite ablehnt. Laden Sie die Seite neu; ihre Sicherheitsregeln müssen „worker-src blob:“ erlauben. Auch eine Browsererweiterung kann Worker verbieten",
    stopped: (why) =>
      `Der Löser ist unerwartet stehen geblieben (${why}). Ihre Formen sind noch da; mit „Abgleichen“ beginnt ein neuer Versuch.`,
    offline:
      "der Löser konnte nicht geladen werden; prüfen Sie die Verbindung und versuchen Sie es noch einmal, oder laden Sie die Seite neu",
    unanswered: (status) => `der Löser konnte nicht geladen werden (${status}); laden Sie die Seite neu`,
    untaken: (why) =>
      `der Löser konnte nicht geladen werden, weil dieser Browser sein WebAssembly nicht annimmt (${why}); nehmen Sie einen aktuellen Firefox, Chrome oder Safari, und erlauben Sie in den Sicherheitsregeln der Seite 'wasm-unsafe-eval'`,
    canvas: "dieser Browser bietet keine 2D-Zeichenfläche; nehmen Sie einen aktuellen Firefox, Chrome oder Safari",
  },

  examples: {
    title: "Oder mit einem Beispiel beginnen",
    gallery: "Galerie öffnen",
  },

  view: "Ansicht",

  views: {
    grid: "Gitter",
    image: "Mitgeführtes Bild",
    pullback: "Zurückgezogenes Bild",
    stretch: "Streckung",
    determinant: "Flächenverhältnis",
    curvature: "Krümmung",
    band: "Band",
    mismatch: "Abweichung",
    stretching: "Streckungsenergie",
    bending: "Biegeenergie",
    volume: "Volumenenergie",
  },

  gridCaption:
    "Gleiche Farben sind einander zugeordnete Punkte: dünn, wo die Referenz war, in ihrem schattierten Band, und dick, wohin sie geht; kurze Striche verbinden beide. Die breite blasse Linie ist das Ziel, gestrichelt, wo es nicht erreicht wurde. Das Netz ist die verformte Ebene.",

  dashed: " Gestrichelt ist, was vom Ziel nicht erreicht wurde.",

  status: {
    ready: "Bereit: Drücken Sie „Abgleichen“.",
    cancelled: "Abgebrochen. „Abgleichen“ beginnt von vorn.",
    preparing: "Die Formen werden vorbereitet …",
    loading: "Der Löser wird geladen …",
    following: "Folgt Ihrer Hand …",
    paused: "Angehalten.",
    matching: "Abgleich läuft …",
    shapesChanged: "Die Formen haben sich geändert: Drücken Sie „Abgleichen“.",
    settingsChanged: "Die Einstellungen haben sich geändert: Drücken Sie „Abgleichen“.",
    pinsChanged: "Die Nadeln haben sich geändert: Drücken Sie „Abgleichen“.",
    on: (what, grid) => `${what}, auf dem Gitter ${grid} …`,
    approach,
    stop,
    verdict,
    unresolved,
  },

  numbers: {
    level: "Gitter",
    iteration: "Iteration",
    total: "Energie",
    "mismatch-max": "Größter Abstand",
    "mismatch-mean": "Mittlerer Abstand",
    "cover-max": "Ziel verfehlt um",
    measure: "Längen\u00adverhältnis",
    "least-determinant": "Kleinstes Flächen\u00adverhältnis",
    cells: "Zellen",
    noCells: "keiner: Das Gitter sieht die Kurve nicht",
  },

  terms: {
    title: "Energie nach Termen",
    names: { membrane: "Streckung", bending: "Biegung", mismatch: "Abweichung", volume: "Volumen" },
    forces: "Ihre Kräfte als Pfeile zeigen",
    rest: (energy) => `Über den ${energy}, die schon da sind, bevor etwas verformt ist.`,
  },

  enlarge: { what: "die große Zeichenfläche", begin: (side) => `Vergrößern: ${DER[side]}` },

  guess: { begin: "Erst raten", another: "Anderer Punkt", end: "Fertig" },

  morph: {
    name: "Übergang",
    what: "was nach Falten sucht",
    play: "Übergang abspielen",
    stop: "Übergang anhalten",
    part: (percent) => `${percent} % der Verformung`,
    how: "Wie der Übergang abläuft",
    plays: { once: "einmal", loop: "immer wieder", swing: "hin und her" },
    folds: (first, last) =>
      `Unterwegs, von ${first} bis ${last} %, faltet sich die Ebene irgendwo; der Abgleich selbst tut das nicht.`,
  },

  result: {
    name: (state) => `Verformtes Gitter und zugeordnete Kurve: ${state}`,
    title: "Abgleich",
    starting: "der Löser beginnt",
    none: "noch nicht abgeglichen, das Gitter ist unverformt",
    stale: "abgeglichen, aber mit anderen Einstellungen als den jetzt gewählten",
    otherPins: "abgeglichen, aber mit anderen Nadeln als den jetzt gesetzten",
    matched: (distance) => `abgeglichen, höchstens ${distance} Zellen daneben, keine Zelle gefaltet`,
    blind: "abgeglichen, aber das Gitter sieht die Kurve nicht",
    doing: { paused: "angehalten", following: "folgt Ihrer Hand", matching: "Abgleich läuft" },
    on: (doing, side) => `${doing}, auf dem Gitter ${side} mal ${side}`,
    outdated: {
      settings: "Mit anderen Einstellungen berechnet",
      pins: "Mit anderen Nadeln berechnet",
    },
    back: "Zurück zum Ergebnis",
    numbers: "was an einem Punkt misst",
  },
};
