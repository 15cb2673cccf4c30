/** Zeichnen, Nadeln, Werkzeuge. */

import type { Book } from "../book";
import { decimals, written } from "../numbers";
import { place } from "../place";
import { capital, DEM, DER, DES } from "./sides";

export const tools: Book["tools"] = {
  group: "Werkzeug",
  draw: { label: "Zeichnen", help: "Formen zeichnen, biegen und verschieben" },
  circle: { label: "Kreis", help: "Einen Kreis aus seiner Mitte aufziehen" },
  polygon: { label: "Vieleck", help: "Ecke für Ecke drücken; auch mit der Tastatur" },
  mirror: { label: "Spiegel", help: "Eine Hälfte zeichnen und eine Form erhalten, die ihr eigenes Spiegelbild ist" },
  points: { label: "Punkte", help: "Punkte einer Kurve verschieben, hinzufügen und löschen; auch mit der Tastatur" },
  pin: { label: "Nadel", help: "Einen Punkt der Referenz an einen Punkt des Ziels heften" },
  drawFirst: "Zeichnen Sie auf einer der Flächen eine geschlossene Kurve.",
  drawOn: "Zeichnen Sie, biegen Sie eine Kurve durch Ziehen, oder verschieben Sie sie am runden Griff.",
};

const OTHER = { reference: "template", template: "reference" } as const;

export const exchange: Book["exchange"] = {
  name: "Formen tauschen oder kopieren",
  swap: "Formen tauschen",
  copy: (from) => (from === "reference" ? "Referenz ins Ziel kopieren" : "Ziel in die Referenz kopieren"),
  swapped: (pins) =>
    `Getauscht: Die Referenz ist, was das Ziel war${pins > 0 ? ", und die Nadeln führen zurück" : ""}.`,
  copied: (from, pins) =>
    `${capital(DER[OTHER[from]])} ist nun wie ${DER[from]}.${pins > 0 ? " Die Nadeln sind gelöscht." : ""}`,
  pinsDropped: (side, pins) =>
    pins === 1
      ? `Die Nadel ist gelöscht, denn die Form ${DES[side]}, zu der sie führte, ist nicht mehr da. „Rückgängig“ bringt beide zurück.`
      : `Alle ${pins} Nadeln sind gelöscht, denn die Form ${DES[side]}, zu der sie führten, ist nicht mehr da. „Rückgängig“ bringt alles zurück.`,
};

export const guides: Book["guides"] = {
  circle: "Drücken Sie, wo die Mitte sein soll, und ziehen Sie nach außen.",
  polygon: "Drücken Sie Ecke für Ecke; die erste Ecke noch einmal schließt den Umriss.",
  points: "Ziehen Sie einen Punkt, oder drücken Sie auf die Kurve, wo einer hinzukommen soll.",
  mirror: "Zeichnen Sie eine Hälfte, von der gestrichelten Linie zurück zu ihr: Die andere ist ihr Spiegelbild.",
  open: (count, least) =>
    count < least
      ? `${points(count)}: Setzen Sie den nächsten.`
      : `${points(count)}: Den ersten noch einmal oder die Eingabetaste drücken, um zu schließen.`,
  rim: "Pfeiltasten weiten den Kreis, die Eingabetaste setzt ihn ab.",
};

export const outline: Book["outline"] = {
  close: "Umriss schließen",
  back: "Letzten löschen",
  giveUp: "Verwerfen",
  rounding: "Glätten",
  roundness: (percent) => (percent === 0 ? "wie gezeichnet" : `${percent} %`),
  deleteCurve: "Kurve löschen",
  deletePoint: "Punkt löschen",
};

export const told: Book["told"] = {
  walk: (at, index, count, closes) =>
    index === null
      ? `${place(at)}.`
      : `${place(at)}, am Punkt ${index + 1} von ${count}${closes ? ": Die Eingabetaste schließt den Umriss" : ""}.`,
  set: (index, at) => `Punkt ${index + 1} gesetzt: ${place(at)}.`,
  chosen: (index, count, at, closes) =>
    `Punkt ${index + 1} von ${count}: ${place(at)}. Die Leertaste nimmt ihn auf, Entf löscht ihn${closes ? ", die Eingabetaste schließt den Umriss" : ""}.`,
  takenUp: (index) => `Punkt ${index + 1} aufgenommen: Pfeiltasten bewegen ihn, die Leertaste setzt ihn ab.`,
  moved: (index, at) => `Punkt ${index + 1} bewegt: ${place(at)}.`,
  deleted: (index, count) =>
    count === 0 ? "Der letzte Punkt ist gelöscht." : `Punkt ${index + 1} gelöscht; noch ${points(count)}.`,
  tooFew: (count, least) => `Bisher ${points(count)}: Ein Umriss braucht ${least}.`,
  added: (index) => `Punkt ${index + 1} hinzugefügt: Pfeiltasten bewegen ihn, die Leertaste setzt ihn ab.`,
  noCurve: "Hier ist keine Kurve: „Bild ab“ führt zum nächsten Punkt.",
  keepsThree: "Eine geschlossene Kurve behält drei Punkte.",
  putBack: "Zurückgesetzt.",
  givenUp: "Der Umriss ist verworfen.",
  centre: (at) => `Mitte gesetzt: ${place(at)}. Pfeiltasten weiten den Kreis, die Eingabetaste setzt ihn ab.`,
  rim: (at, radius) => `${place(at)}: Radius ${written(String(Number(radius.toFixed(3))))}.`,
  circleGivenUp: "Der Kreis ist verworfen.",
  rounded: (percent, side) =>
    percent === 0
      ? `Die Kurve ${DES[side]} ist, wie sie gezeichnet wurde.`
      : `Die Kurve ${DES[side]} ist zu ${percent} % geglättet.`,
  curveDeleted: (side) => `Kurve ${DES[side]} gelöscht.`,
};

export const strokes: Book["strokes"] = {
  faults: {
    crossing: () => "Diese Linie kreuzt sich selbst; so ist nicht klar, was innen ist.",
    flat: () => "Diese Linie umschließt nichts: Zeichnen Sie ganz um das herum, was innen sein soll.",
    small: (size) => `Diese Kurve ist ${size} Zellen breit, und unter vier sieht das Gitter nichts.`,
    border: () => "Diese Kurve verlässt das Quadrat oder kommt seinem Rand zu nahe.",
  },
  ways: {
    crossing: "Den größeren Teil behalten",
    flat: "",
    small: "Vergrößern",
    border: "Nach innen schieben",
  },
  changed: (side) => `${capital(DER[side])} hat sich geändert.`,
  curves: (side, count) => {
    if (count === 0) return `${capital(DER[side])} ist jetzt leer.`;
    return count === 1
      ? `${capital(DER[side])} ist jetzt eine geschlossene Kurve.`
      : `${capital(DER[side])} hat jetzt ${count} geschlossene Kurven.`;
  },
};

export const pinActions: Book["pinActions"] = {
  first: "Drücken Sie einen Punkt der Referenz, dann seinen Partner auf dem Ziel.",
  partner: (number, side) => `Nun der Partner der Nadel ${number}: Drücken Sie, wo er auf ${DEM[side]} liegen soll.`,
  chosen: (index) => `Nadel ${index + 1}: Ziehen Sie eines der Enden, oder löschen Sie sie.`,
  delete: (index) => `Nadel ${index + 1} löschen`,
  deleteAll: "Alle Nadeln löschen",
};

export const pinsTold: Book["pinsTold"] = {
  begun: (index, side, at) => `Nadel ${index + 1} auf ${DEM[side]} begonnen: ${place(at)}.`,
  set: (index, from, to) => `Nadel ${index + 1} gesetzt: von ${place(from)} nach ${place(to)}.`,
  moved: (index, at) => `Nadel ${index + 1} bewegt: ${place(at)}.`,
  chosen: (index, at) => `Nadel ${index + 1} gewählt: ${place(at)}.`,
  takenUp: (index) =>
    `Nadel ${index + 1} aufgenommen: Pfeiltasten bewegen sie, die Eingabetaste setzt sie ab, Esc setzt sie zurück.`,
  deleted: (index) => `Nadel ${index + 1} gelöscht.`,
  allDeleted: "Alle Nadeln gelöscht.",
  putBack: "Zurückgesetzt.",
  givenUp: "Die Nadel ist verworfen.",
  full: (most) => `Es gibt schon ${most} Nadeln: Löschen Sie erst eine.`,
  onCurve: ", auf der Kurve",
  atPin: (index) => `, an der Nadel ${index + 1}`,
};

export const pinReports: Book["pinReports"] = {
  aside: ({ index, cells }) =>
    `Nadel ${index + 1} heftet zwei Punkte aneinander, von denen einer ${decimals(cells)} Zellen weiter von seiner Kurve liegt: Der Abgleich kann nicht zugleich passen und ihr folgen. Ziehen Sie sie auf die Kurve, wo sie einrastet.`,
  ignored: "Die Nadeln wirken nicht: Ihre Stärke ist 0.",
  off: (far) => {
    const [first, ...others] = far.map(({ index, cells }, k) =>
      k === 0
        ? `Nadel ${index + 1} endet ${decimals(cells)} Zellen neben ihrem Partner`
        : `Nadel ${index + 1} ${decimals(cells)} Zellen`,
    );
    const list = [first, ...others.slice(0, 3)].join(", ");
    const more = others.length > 3 ? ` und ${others.length - 3} weitere` : "";
    const remedy =
      far.length > 1
        ? "Bewegen Sie sie, oder erhöhen Sie in den Einstellungen ihre Stärke"
        : "Bewegen Sie sie, oder erhöhen Sie in den Einstellungen die Stärke der Nadeln";
    return `${list}${more}: ${remedy}.`;
  },
};

function points(count: number): string {
  return count === 1 ? "1 Punkt" : `${count} Punkte`;
}
