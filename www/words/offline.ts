/** What the page says of new versions of itself. */

import { page } from "./language";

export const offline = page("offline", {
  region: "Version",
  waiting: "A new version of this page is ready. It begins with your next visit, or now; what you have drawn stays.",
  takeOver: "Use it now",
});
