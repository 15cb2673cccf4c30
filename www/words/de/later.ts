/** Was erst auf Abruf kommt. */

import type { Book } from "../book";
import { page } from "./page";
import { DER } from "./sides";

export const later: Book["later"] = {
  settings: {
    plain: "Einstellungen, die die meisten brauchen",
    experts: "Für Kenner des Artikels",
    groups: { Energies: "Energien", Grid: "Gitter", Method: "Verfahren" },
    automatic: (value) => `Zurzeit: ${value} Seitenlängen.`,
    reset: "Auf die Vorgaben zurücksetzen",
    slider: (label) => `${label}, Regler`,
  },

  compare: {
    setting: (side) => `Einstellung, die ${side} ändert`,
    but: (side) => `${side}: die Einstellungen der Seite, aber`,
    nothing: "nichts geändert",
    of: (setting, side) => `${setting} von ${side}`,
    run: "Vergleichen",
    running: "Vergleich läuft …",
    stop: "Vergleich anhalten",
    stopped: (why) => `Der Löser ist unerwartet stehen geblieben (${why}); vergleichen Sie noch einmal.`,
    view: "Ansicht beider",
    morph: "Übergang beider",
    result: (name) => `Ergebnis von ${name}`,
    numbers: (name) => `Zahlen am Punkt, ${name}`,
    differences: (a, b) => `Unterschiede zwischen ${a} und ${b}`,
    rows: {
      total: "Energie",
      membrane: "der Streckung",
      bending: "der Biegung",
      mismatch: "der Abweichung",
      volume: "des Volumens",
      pins: "der Nadeln",
      largest: "Größter Abstand, Zellen",
      mean: "Mittlerer Abstand, Zellen",
      missed: "Ziel verfehlt um, Zellen",
      measure: "Längen\u00adverhältnis",
      stretch: "Mittlere Streckung",
      deviation: "Streuung der Streckung",
      area: "Kleinstes Flächen\u00adverhältnis",
      evaluations: "Aus\u00adwertungen",
      millis: "Zeit, ms",
    },
  },

  energies: {
    title: "Terme der Energie über den Iterationen, logarithmisch",
    none: "Drücken Sie „Abgleichen“, um die Energien fallen zu sehen.",
    iteration: "Iteration",
    axis: "Iteration",
    total: "Summe",
  },

  view: {
    legend: "Legende",
    histogram: (most) => `Histogramm der Streckung; der größte Teil der Kurve ist ${most}`,
    shares: ["verkürzt", "gleich lang", "verlängert"],
    choose: "Bild wählen …",
    pattern: "Testmuster",
  },

  runs: {
    none: "Drücken Sie „Abgleichen“: Jeder Lauf bleibt hier, um ihn wieder zu zeigen und zu vergleichen.",
    title: "Bisherige Läufe, der neueste zuerst",
    defaults: "Vorgaben",
    show: (title) => `Wieder zeigen: ${title}`,
    pin: "Damit vergleichen",
    pinned: "Festgehalten",
    now: "Jetzt",
    run: (id) => `Lauf ${id}`,
  },

  past: {
    name: "Iteration",
    at: (iteration, all, grid) => `Iteration ${iteration} von ${all}, auf dem Gitter ${grid}`,
  },

  legend: {
    reference: "Referenz",
    matched: "Referenz, bewegt",
    template: "Ziel",
    missed: "Nicht erreicht (gestrichelt)",
  },

  guess: {
    ask: "Wohin geht der markierte Punkt der Referenz? Klicken Sie im Bild auf die Stelle, oder führen Sie das Kreuz mit den Pfeiltasten hin und drücken Sie die Eingabetaste.",
    off: (sides, cells) => `Sie lagen um ${sides} Seitenlängen daneben, das sind ${cells} Zellen des Gitters.`,
  },

  enlarged: {
    begun: (side) => `Jetzt füllt ${DER[side]} den Bildschirm; „Fertig“ führt zurück.`,
    undo: "Rückgängig",
    redo: "Wiederholen",
    other: (side) => (side === "reference" ? "Zur Referenz" : "Zum Ziel"),
    done: "Fertig",
  },

  gallery: { title: "Galerie", importing: (side) => `Importieren: ${DER[side]}` },

  present: {
    enter: "Vorführen",
    what: "die Vorführung",
    leave: "Beenden",
    help: "Nur das Ergebnis auf dem ganzen Bildschirm, in großer Schrift",
    keys: "Leertaste spielt ab, ← → Schritt, v nächste Ansicht, Esc beendet",
  },

  scales: {
    stretch: "Länge nachher / vorher",
    determinant: "Fläche nachher / vorher",
    curvature: "Krümmung",
    band: "Gewicht η der Schale",
    mismatch: "|d₂∘φ − d₁|",
    stretching: "Streckungsenergie, W",
    bending: "Biegeenergie, |S|²",
    volume: "Volumenenergie, W",
    perSide: "je Seitenlänge",
    perSquare: "je Seitenlänge²",
    cells: "Zellen",
  },

  pictures: {
    unread: "Das Bild konnte nicht gelesen werden; wählen Sie eine Datei in PNG, JPEG oder WebP.",
    canvas: "Dieser Browser bietet keine 2D-Zeichenfläche; nehmen Sie einen aktuellen Firefox, Chrome oder Safari.",
  },

  readout: {
    name: "Zahlen am Punkt",
    point: "Punkt",
    partner: "Partner",
    stretch: "Streckung",
    determinant: "Flächenverhältnis",
    curvatures: "Krümmungen",
    distance: "Abstand",
    perSide: "je Seitenlänge",
    cells: "Zellen",
  },

  card: {
    solver: "Der Löser für Grafikkarten",
    by: "Gerechnet von",
    cpu: "vom Prozessor",
    gpu: (name) => `von der Grafikkarte (${name})`,
    because: (who, reason) => `${who}: ${reason}`,
    last: (who) => `Zuletzt ${who}.`,
  },

  hints: {
    fit: "Beide Formen skalieren und in die Mitte setzen",
    gallery: "Länder, Tiere und Dinge, als Referenz oder als Ziel zu nehmen",
  },

  copying: {
    copy: "Link kopieren",
    copied: "Kopiert",
    seeAddress: "Siehe Adresszeile",
    help: "Ein Link, der alles zurückbringt: Formen, Nadeln, Einstellungen, Ansicht",
  },

  without: {
    membrane: "Aus: Die Schale darf sich entlang der Kurve umsonst strecken.",
    bending: "Aus: Die Schale darf sich umsonst biegen.",
    volume: "Aus: Die Ebene ringsum gibt fast frei nach; ein Rest bleibt, sonst könnte sie sich falten.",
  },

  forces: { failed: "Die Kräfte ließen sich nicht berechnen" },
};

export const captions: Book["captions"] = {
  grid: page.gridCaption,
  image:
    "Jeder Punkt des Bildes wandert dorthin, wohin ihn die Verformung führt. Orange ist das Ziel; die schwarze Linie ist die mitgeführte Referenz.",
  pullback:
    "Jeder Punkt zeigt, was das Bild dort hat, wohin ihn die Verformung führt. Blau ist die Referenz: Auf ihr liegt, was das Bild entlang des Ziels hat.",
  stretch:
    "Länge nachher durch Länge vorher, entlang der zugeordneten Kurve: Blau ist verkürzt, Orange verlängert, farblos gleich lang. Dünn und grau ist, wo die Referenz war, blass orange das Ziel; die Balken zeigen, wie viel der Kurve welche Streckung hat.",
  determinant:
    "Fläche nachher durch Fläche vorher, det Dφ: Blau schrumpft, Orange wächst, farblos bleibt gleich. Die orange Linie ist das Ziel, die schwarze die mitgeführte Referenz.",
  curvature:
    "Die dünne Kurve hat die Farben der Krümmung der Referenz, die dicke die der Krümmung des Ziels an den Partnern: Orange wölbt sich nach außen, Blau nach innen, farblos ist gerade.",
  band: "Wie viel jeder Punkt als Schale zählt, mitgeführt: Hell zählt voll, dunkel gar nicht. Streckung, Biegung und Abweichung wirken nur, wo es hell ist.",
  mismatch:
    "Wie weit die Abstände zu beiden Kurven voneinander abweichen, in Zellen des Gitters: Dunkel stimmt überein, hell nicht. Außerhalb des Bandes zählt es nicht, und dort ist nichts gemalt.",
  stretching:
    "Entlang der zugeordneten Kurve, was Strecken und Stauchen an jeder Stelle kostet, vor der Gewichtung: Dunkel ist nichts, hell am meisten. Dünn und grau ist, wo die Referenz war, blass orange das Ziel.",
  bending:
    "Entlang der zugeordneten Kurve, was die Änderung ihrer Krümmung an jeder Stelle kostet, vor der Gewichtung: Dunkel ist nichts, hell am meisten. Dünn und grau ist, wo die Referenz war, blass orange das Ziel.",
  volume:
    "Was die Verformung der Ebene an jeder Stelle kostet, vor der Gewichtung: Dunkel ist nichts, hell am meisten. Die orange Linie ist das Ziel, die schwarze die mitgeführte Referenz.",
};

export const memory: Book["memory"] = {
  title: "Letzte Sitzungen",
  failed:
    "Dieser Browser bewahrt nichts für Sie auf: Sein Speicher ist voll oder abgeschaltet. Die Adresse enthält weiterhin alles; kopieren Sie den Link, bevor Sie die Seite schließen.",
};

export const recent: Book["recent"] = {
  none: "Was Sie zeichnen, bleibt hier erhalten, nur in diesem Browser.",
  help: "Nur in diesem Browser aufbewahrt, für jeden Tab getrennt. Eine Sitzung zu öffnen ist ein Schritt, der sich rückgängig machen lässt.",
  drawn: "Gezeichnete Formen",
  unread: (why) => `Nicht lesbar: ${why}`,
  settings: (count) => (count === 1 ? "1 Einstellung geändert" : `${count} Einstellungen geändert`),
  own: "dieser Tab",
  open: (what, when) => `Öffnen: ${what}, ${when}`,
  remove: (what, when) => `Löschen: ${what}, ${when}`,
  removeShort: "Löschen",
  before: "früher",
  when: (time) => time.toLocaleString("de-DE", { dateStyle: "medium", timeStyle: "short" }),
};

export const offline: Book["offline"] = {
  region: "Version",
  waiting:
    "Eine neue Version dieser Seite ist da. Sie beginnt mit Ihrem nächsten Besuch, oder jetzt; was Sie gezeichnet haben, bleibt.",
  takeOver: "Jetzt verwenden",
};
