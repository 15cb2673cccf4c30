/** What the list of sessions says. */

import { page } from "./language";

export const recent = page("recent", {
  none: "What you draw is kept here, in this browser alone.",
  help: "Kept in this browser alone, each tab's by itself. Opening one is a step that can be undone.",
  drawn: "Drawn shapes",
  unread: (why: string) => `Could not be read: ${why}`,
  settings: (count: number) => (count === 1 ? "1 setting changed" : `${count} settings changed`),
  own: "this tab",
  open: (what: string, when: string) => `Open: ${what}, ${when}`,
  remove: (what: string, when: string) => `Delete: ${what}, ${when}`,
  removeShort: "Delete",
  before: "earlier",
  when: (time: Date) => time.toLocaleString("en-GB", { dateStyle: "medium", timeStyle: "short" }),
});
