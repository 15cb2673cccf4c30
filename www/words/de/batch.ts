/** Was die Seite von einem Stapel sagt: eine Referenz, abgeglichen mit vielen Zielen. */

import type { Book } from "../book";

export const batch: Book["batch"] = {
  title: "Eine Referenz, viele Ziele",
  open: "Viele Dateien",
  what: "Der Stapel",
  loading: "Der Stapel wird geladen …",
  help: "Jede Form der Dateien wird mit der Referenz abgeglichen, eine nach der anderen. Wählen Sie Dateien oder einen Ordner, oder legen Sie sie hier ab: Zeichnungen, Bilder, Punktlisten und TPS-Dateien mit allen Exemplaren.",
  files: "Dateien wählen",
  folder: "Ordner wählen",
  reference: "Referenz",
  references: { page: "die Referenz der Seite", first: "die erste Form der Dateien" },
  outline: "Von jeder Form nur der Umriss: ihr größter Teil, ohne Löcher",
  points: "Punkte auf jedem Umriss",
  chosen: (count) =>
    count === 0 ? "Noch keine Dateien." : count === 1 ? "1 Datei ist bereit." : `${count} Dateien sind bereit.`,
  most: (most) => `Aus dem Ordner werden die ersten ${most} Dateien genommen.`,
  noReference: "Die Seite hat keine Referenz; zeichnen Sie eine, oder nehmen Sie die erste Form der Dateien.",
  unread: (file, why) => `${file} kann nicht die Referenz sein: ${why}`,
  start: "Alle abgleichen",
  stop: "Anhalten",
  progress: "Stapel",
  reading: (file) => `${file} wird gelesen …`,
  matching: (name, grid) => `${name} wird abgeglichen, auf dem Gitter ${grid} …`,
  done: (good, all, fitting) => `${good} von ${all} Formen sind abgeglichen, ${fitting} davon passen.`,
  stopped: (good) =>
    good === 1
      ? "Angehalten; der bisherige Abgleich lässt sich speichern."
      : `Angehalten; die bisherigen ${good} Abgleiche lassen sich speichern.`,
  failed: (why) => `Der Löser ist unerwartet stehen geblieben (${why}).`,
  saved: "Das ist ein gespeicherter Abgleich; holen Sie eine Form daraus, indem Sie ihn importieren.",
  table: "Abgleiche mit der Referenz",
  columns: {
    shape: "Form",
    distance: "Procrustes-Abstand",
    size: "Zentroidgröße",
    mismatch: "Größter Abstand, Zellen",
    outcome: "Ergebnis",
  },
  show: (name) => `${name} zeigen`,
  saves: {
    table: "Tabelle (CSV)",
    tps: "Punkte (TPS)",
    points: "Punkte (CSV)",
    strains: "Dehnungen (CSV)",
  },
  unlike: (reference, target) =>
    `Die Landmarken sind nicht verbunden: Die Referenz hat ${reference}, diese Form ${target}.`,
  firstLandmarks: (all, most) => `Von ${all} Landmarken sind die ersten ${most} verbunden.`,
};
