/** Was die Seite von Flächen im Raum sagt. */

import type { Book } from "../book";
import { brief } from "../links";
import { written } from "../numbers";
import { DER, DES } from "./sides";

export const way: Book["way"] = {
  enter: "Flächen",
  help: "Geschlossene Flächen im Raum abgleichen statt Kurven",
  part: "was Flächen zeigt",
};

export const space: Book["space"] = {
  leave: "Zurück zu den Kurven",
  title: "Elastischer Abgleich zweier Flächen",
  document: "thinshell: elastischer Abgleich zweier Flächen",
  promise:
    "Wählen Sie zwei geschlossene Flächen: Der Raum, mit einer dünnen Schale entlang der ersten, wird verformt, bis diese auf der zweiten liegt.",
  examples: "Oder mit einem Beispiel beginnen",

  sides: { reference: "Referenz", template: "Ziel" },
  surface: { reference: "Form der Referenz", template: "Form des Ziels" },
  choose: (side) => `Fläche ${DES[side]}`,
  open: (side) => `Eine Datei öffnen: ${DER[side]}`,
  file: "Datei",
  actions: {
    match: "Abgleichen",
    live: "Live",
    liveHelp: "Ein Abgleich beginnt, sobald Sie eine Fläche, eine Nadel oder eine Einstellung ändern",
    pause: "Anhalten",
    resume: "Fortsetzen",
    cancel: "Abbrechen",
    undo: "Rückgängig",
    redo: "Wiederholen",
    swap: "Tauschen",
    swapHelp: "Die Referenz wird zum Ziel, und umgekehrt",
    link: "Link kopieren",
    copied: "Kopiert",
    address: "Siehe Adresszeile",
    linkHelp: "Ein Link, der Flächen der Galerie, Nadeln, Einstellungen, Ansicht und Blickpunkt zurückbringt",
    camera: "Blick zurücksetzen",
    dismiss: "Verstanden",
  },

  pins: {
    set: "Nadeln setzen",
    help: "Punkte der Referenz, an Punkte des Ziels gebunden",
    deleteAll: "Alle Nadeln löschen",
    name: (number, side) => `Nadel ${number} auf der Fläche ${DES[side]}`,
    guide:
      "Drücken Sie auf einen Punkt einer der Flächen, dann auf seinen Partner auf der anderen. Mit Tasten: Drehen Sie den Punkt zum Kreuz in der Mitte, dann Eingabe.",
    begun: (number, side) =>
      `Nadel ${number} beginnt auf der Fläche ${DES[side]}: Drücken Sie nun auf ihren Partner auf der Fläche ${DES[side === "reference" ? "template" : "reference"]}, oder Escape.`,
    keys: "Nadeln werden auf ihrer Fläche gezogen oder mit den Pfeiltasten bewegt; Entf löscht eine.",
  },

  view: "Ansicht",
  views: {
    colours: "Gleiche Farben",
    area: "Flächenverhältnis",
    distance: "Abstand",
    slice: "Schnitt",
  },
  captions: {
    colours:
      "Gleiche Farben sind einander zugeordnete Punkte: Jeder Punkt der Referenz behält seine Farbe und seine Linien, und das Ziel zeigt die seiner Partner.",
    area: "Wie sehr die Fläche wächst: um jeden Punkt ihr Inhalt nach dem Abgleich durch den davor.",
    distance:
      "Wie weit jeder Punkt der bewegten Referenz vom Ziel entfernt liegt, in Zellen des Gitters, auf dem abgeglichen wurde.",
    slice:
      "Der Raum ist entlang einer Ebene des unverformten Gitters geschnitten: Das Netz ist, wohin die Verformung sie führt, die kräftige Linie, wohin sie die Kurve führt, die die Ebene aus der Referenz schneidet.",
  },
  keys: "Ziehen dreht, mit der Umschalttaste verschiebt es, das Rad zoomt; zwei Finger zoomen und verschieben. Tasten: Pfeile drehen, mit der Umschalttaste verschieben sie, + und − zoomen, Pos1 führt zurück.",
  waiting: "Farben und Karten kommen mit dem Abgleich.",
  legend: "Was die Farben bedeuten",
  area: "Flächenverhältnis",
  distance: "Abstand zum Ziel",
  cells: "Zellen",
  target: "Das Ziel als Schleier",
  plane: "Quer zur",
  axes: ["Breite", "Höhe", "Tiefe"],
  at: "Ebene bei",
  percent: (part) => `${Math.round(100 * part)} %`,

  pose(across, above, zoom, moved) {
    const side = across === 0 ? "" : `${Math.abs(across)}° von ${across > 0 ? "rechts" : "links"}`;
    const height = above === 0 ? "" : `${Math.abs(above)}° von ${above > 0 ? "oben" : "unten"}`;
    const from = [side, height].filter(Boolean).join(", ") || "von vorn";
    return `Gesehen ${from}, Zoom ${written(zoom.toFixed(1))}${moved ? ", verschoben" : ""}`;
  },

  result: "Verformtes Gitter und zugeordnete Kurve, hier eine Fläche",
  state: {
    none: "noch nicht abgeglichen",
    starting: "der Löser beginnt",
    paused: "angehalten",
    on: (grid) => `Abgleich läuft, auf dem Gitter ${grid}`,
    stale: "abgeglichen, aber mit anderen Flächen oder Einstellungen als den jetzt gewählten",
    matched: (distance) => `abgeglichen, höchstens ${distance} Zellen daneben, nichts gefaltet`,
  },
  status: {
    ready: "Bereit: Drücken Sie „Abgleichen“.",
    cancelled: "Abgebrochen. „Abgleichen“ beginnt von vorn.",
    loading: "Der Löser für Flächen wird geladen …",
    preparing: "Die Flächen werden vorbereitet …",
    paused: "Angehalten.",
    on: (grid) => `Abgleich läuft, auf dem Gitter ${grid} …`,
    changed: "Flächen oder Einstellungen haben sich geändert: Drücken Sie „Abgleichen“.",
    finished: "Fertig.",
  },
  grid: (level) => `${2 ** level + 1}³`,
  numbers: {
    level: "Gitter",
    iteration: "Iteration",
    total: "Energie",
    "mismatch-max": "Größter Abstand",
    "mismatch-mean": "Mittlerer Abstand",
    "cover-max": "Ziel verfehlt um",
    measure: "Inhalt durch den des Ziels",
    "area-deviation": "Flächenverhältnis streut um",
    "pins-off": "Eine Nadel endet daneben um",
    "least-determinant": "Kleinstes Volumenverhältnis",
  },
  after: "Abgleich nach dem Gitter",
  nothing: "keiner: Das Gitter sieht die Fläche nicht",

  settings: "Einstellungen",
  changed: (count) => (count > 0 ? ` (${count} geändert)` : ""),
  reset: "Auf die Vorgaben zurücksetzen",
  finest: "Feinstes Gitter",
  finestHelp:
    "Knoten des letzten Gitters. 33³ dauert Sekunden; jedes weitere dauert etwa zehnmal so lang und braucht achtmal so viel Speicher.",

  save: "Speichern",
  formats: {
    png: "Bild (PNG)",
    ply: "Zugeordnete Fläche (PLY)",
    json: "Alles (JSON)",
    video: "Übergang als Video",
    gif: "Übergang als GIF",
  },
  saving: "Wird gespeichert …",
  films: "was Filme macht",
  notSaved: (what, why) => `Nicht gespeichert: ${what}. ${why}`,
  noMatch: "Es gibt noch keinen Abgleich zu speichern; drücken Sie erst „Abgleichen“.",

  noWebGl:
    "Dieser Browser zeigt kein WebGL, deshalb können die Flächen hier nicht gezeichnet werden; Abgleich, Zahlen und Speichern gehen trotzdem. Erlauben Sie Hardwarebeschleunigung, oder nehmen Sie einen aktuellen Firefox, Chrome oder Safari.",
  crashed: (why) =>
    `Der Löser ist unerwartet stehen geblieben (${why}). Ihre Flächen sind noch da; mit „Abgleichen“ beginnt ein neuer Versuch.`,

  files: {
    notRead: (name, why) => `„${name}“ wurde nicht übernommen: Die Datei ${why}.`,
    unknown: "ist weder PLY, OBJ, STL oder NRRD noch JSON mit einem Abstandsfeld",
    large: (limit) => `hat mehr als ${limit} Dreiecke; verkleinern Sie sie erst, zum Beispiel in MeshLab`,
    empty: "enthält keine Dreiecke",
    cut: "endet zu früh",
    number: "enthält etwas anderes, wo eine Zahl stehen sollte",
    index: "nennt eine Ecke, die es in ihr nicht gibt",
    flat: "hat keine Ausdehnung",
    far: "reicht weiter, als Zahlen reichen",
    nrrd: "ist kein NRRD aus drei Längen mit einer Zahl je Voxel, roh, mit gzip gepackt oder als Text, in einer Datei",
    manyVoxels: (limit) => `hat mehr als ${limit} Voxel; verkleinern Sie sie erst`,
    plyFormat: (format) => `ist ein PLY des unbekannten Formats „${format}“`,
    plyHeader: "hat keinen lesbaren PLY-Kopf",
    json: "ist kein JSON mit „cells“ (2 bis 128) und „values“, einem für jeden der (cells + 1)³ Knoten, x am schnellsten, innen negativ",
  },

  links: {
    notRead: (why) => `Der Link konnte nicht gelesen werden: ${why}.`,
    number: (text) => `„${brief(text)}“ ist nicht, was es sein sollte`,
    unknown: (id) => `die Galerie hat keine Fläche „${brief(id)}“`,
    elsewhere: (side) => `${DER[side]} ist eine Datei, die nur ein anderer Browser hat oder die es nicht mehr gibt`,
    notWhole:
      "Der Link enthält Einstellungen, Ansicht und Blickpunkt, aber nicht das Netz der Datei: Das bleibt nur in diesem Browser.",
    notKept:
      "Dieser Browser bewahrt keine Dateien auf: Nach dem Neuladen muss das abgelegte Netz noch einmal geöffnet werden.",
  },
};

export const surfaces: Book["surfaces"] = {
  sphere: { name: "Kugel" },
  ellipsoid: { name: "Ellipsoid" },
  octahedron: { name: "Abgerundetes Oktaeder" },
  "octahedron-turned": { name: "Oktaeder, gedreht" },
  unduloid: { name: "Unduloid" },
  "unduloid-shifted": { name: "Unduloid, verschoben" },
  torus: { name: "Torus" },
  "torus-bent": { name: "Torus, gebogen" },
  bumpy: { name: "Kugel mit Beulen" },
  "bumpy-turned": { name: "Kugel mit Beulen, gedreht" },
  cube: { name: "Abgerundeter Würfel" },
  star: { name: "Superform" },
  bar: { name: "Stab" },
  "bar-twisted": { name: "Stab, verdrillt" },
  "bar-bent": { name: "Stab, gebogen" },
  figure: { name: "Figur" },
  "figure-waving": { name: "Figur, winkend" },
  hound: { name: "Hund" },
  "hound-trotting": { name: "Hund, trabend" },
};

export const pairsOfSurfaces: Book["pairsOfSurfaces"] = {
  "sphere ellipsoid": { name: "Kugel → Ellipsoid" },
  "octahedron octahedron-turned": { name: "Oktaeder, um 30° gedreht" },
  "unduloid unduloid-shifted": { name: "Unduloid, verschoben" },
  "torus torus-bent": { name: "Torus → gebogener Torus" },
  "bumpy bumpy-turned": { name: "Beulen, um 30° gedreht" },
  "sphere cube": { name: "Kugel → abgerundeter Würfel" },
  "sphere star": { name: "Kugel → Superform" },
  "bar bar-twisted": { name: "Stab, verdrillt" },
  "bar bar-bent": { name: "Stab, gebogen" },
  "figure figure-waving": { name: "Figur, winkend" },
  "hound hound-trotting": { name: "Hund, trabend" },
};
