/**
 * The languages of the page. English stands in the code: each object of sentences is a page of a book, registered here
 * under the name that its like has in every other language. Another language is a book of the same shape (book.ts),
 * fetched on demand; its sentences change places with those in force, so that whoever holds a page says them.
 *
 * To add a language: write `www/words/xx.ts` like de.ts (what is missing does not compile), and put it on the `SHELVES`.
 */

import { signal } from "@preact/signals";

export type Language = "en" | "de";

/** Sentences, functions that make them, and the like of them in objects and lists. */
type Page = Record<string, unknown>;
type Book = Readonly<Record<string, object>>;

/** Where the books are; English needs none. */
const SHELVES: Readonly<Record<Language, () => Promise<Book | null>>> = {
  en: async () => null,
  de: async () => (await import("./de")).de,
};

/** The language in force. */
export const language = signal<Language>("en");

export const pages = new Map<string, Page>();
let book: Book | null = null;

/**
 * The page, in the language in force whenever it is read: so it is to be read when something is said. What is shown of
 * it follows the language, as it follows a signal.
 */
export function page<T extends object>(name: string, english: T): T {
  const own = english as Page;
  pages.set(name, own);
  if (book) exchange(own, book[name] as Page);
  return new Proxy(english, {
    get(target, key) {
      language.value;
      return target[key as keyof T];
    },
  });
}

/** Rejects where the language cannot be fetched; then the old one stays. */
export async function speak(wanted: Language): Promise<void> {
  const next = await SHELVES[wanted]();
  for (const other of [book, next]) if (other) for (const [name, own] of pages) exchange(own, other[name] as Page);
  book = next;
  language.value = wanted;
}

/** Twice is as good as never, so that the way back needs no copy. */
function exchange(own: Page, other: Page): void {
  for (const key in other) {
    const value = other[key];
    if (typeof value === "object") exchange(own[key] as Page, value as Page);
    else [own[key], other[key]] = [value, own[key]];
  }
}

/** What the address asks for, else what was chosen before, else the first of the browser's that the page speaks. */
export function preferred(search: string, chosen: string | null, languages: readonly string[]): Language {
  const asked = new URLSearchParams(search).get("lang");
  const known = [asked, chosen, ...languages].map((name) => String(name).slice(0, 2).toLowerCase());
  return (known.find((name) => Object.hasOwn(SHELVES, name)) as Language | undefined) ?? "en";
}
