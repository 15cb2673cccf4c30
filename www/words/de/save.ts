/** Von dem, was man mitnimmt. */

import type { Book } from "../book";

export const save: Book["save"] = {
  name: "Speichern",
  busy: "Wird gespeichert …",
  legend: "Mit Legende",
  formats: {
    png: "Bild (PNG)",
    svg: "Zeichnung (SVG)",
    json: "Alles (JSON)",
    csv: "Zugeordnete Punkte (CSV)",
    video: "Übergang als Video (WebM)",
    gif: "Übergang als GIF",
  },
  failed: (what, why) => `Nicht gespeichert: ${what}. ${why}`,
};
