/** The language of the page: found when it opens, and kept for the next visit. */

import { language, page, preferred, speak } from "../words/language";

/** In the browser's storage. */
export const KEY = "language of thinshell";

/** What stands in the page's file. Its elements are exchanged like sentences: by what they hold. */
export function readFile(name: string, prose: string): void {
  page(name, {
    root: document.documentElement,
    title: document.querySelector("title"),
    description: document.querySelector("meta[name=description]"),
    change: change(),
    prose: [...document.querySelectorAll(prose)],
  });
}

/** Begins with the language that is wanted; where it cannot be fetched, with English. */
export function begin(): Promise<void> {
  let chosen: string | null = null;
  try {
    chosen = localStorage.getItem(KEY);
  } catch {
    // Switched off: then the browser's languages decide.
  }
  const wanted = preferred(location.search, chosen, navigator.languages);
  return wanted === language.value ? Promise.resolve() : speak(wanted);
}

export function change(): HTMLButtonElement | null {
  return document.querySelector("button.language");
}
