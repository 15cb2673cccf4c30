/** What the page says of the sessions that it keeps. */

export const memory = {
  title: "Recent sessions",
  none: "What you draw is kept here, in this browser alone.",
  help: "Kept in this browser alone, each tab's by itself. Opening one is a step that can be undone.",
  drawn: "Drawn shapes",
  settings: (count: number) => (count === 1 ? "1 setting changed" : `${count} settings changed`),
  own: "this tab",
  open: (what: string, when: string) => `Open: ${what}, ${when}`,
  remove: (what: string, when: string) => `Delete: ${what}, ${when}`,
  removeShort: "Delete",
  before: "earlier",
  when: (time: Date) => time.toLocaleString("en-GB", { dateStyle: "medium", timeStyle: "short" }),
  failed:
    "This browser keeps nothing for you: its storage is full or switched off. The address still holds everything; copy the link before you close the page.",
};
