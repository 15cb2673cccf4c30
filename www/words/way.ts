/** The way to surfaces: what is said before anything of them has been fetched. */

import { page } from "./language";

export const way = page("way", {
  enter: "Surfaces",
  help: "Match closed surfaces in space instead of curves",
  part: "What shows surfaces",
});
