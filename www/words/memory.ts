/** What the page says of the sessions that it keeps, before they are listed. */

import { page } from "./language";

export const memory = page("memory", {
  title: "Recent sessions",
  failed:
    "This browser keeps nothing for you: its storage is full or switched off. The address still holds everything; copy the link before you close the page.",
});
