/** What is said of taking a match away; it comes with what does that. */

import { page } from "./language";

export const save = page("save", {
  name: "Save",
  busy: "Saving …",
  legend: "With a legend",
  formats: {
    png: "Picture (PNG)",
    svg: "Drawing (SVG)",
    json: "Everything (JSON)",
    csv: "Matched points (CSV)",
    video: "Morph as video (WebM)",
    gif: "Morph as GIF",
  },
  failed: (what: string, why: string) => `${what} could not be saved. ${why}`,
});
