/**
 * Sessions as the browser keeps them, each under a key of its own so that two tabs never write the same one.
 *
 * In `localStorage`, since it is written before the call returns: what is there survives a tab that is killed in the next
 * moment. A session is a link's text, some two thousand letters at most: 0.1 ms in Chromium, where IndexedDB takes from 1
 * to 14 until it is kept.
 */

export type Kept = {
  readonly id: string;
  /** When it was written last, in milliseconds since 1970. */
  readonly at: number;
  /** A link's text. */
  readonly text: string;
};

const PREFIX = "thinshell:";
/** Where there was one session for all tabs. */
const FIRST_KEY = "thinshell";
/** Sessions kept; the oldest go first. */
export const MOST = 20;

export class Sessions {
  private readonly storage: () => Storage;

  /** Even to ask for the storage may be forbidden. */
  constructor(storage: () => Storage = () => localStorage) {
    this.storage = storage;
  }

  /** Newest first. Of those that hold the same only the newest; none where the storage is switched off. */
  list(): readonly Kept[] {
    const seen = new Set<string>();
    return this.all().filter(({ text }) => !seen.has(text) && seen.add(text));
  }

  read(id: string): Kept | null {
    return this.all().find((kept) => kept.id === id) ?? null;
  }

  /** Whether it has been kept: the storage may be full or switched off. */
  write(kept: Kept): boolean {
    const others = this.all().filter(({ id }) => id !== kept.id);
    for (const { id } of others.splice(MOST - 1)) this.remove(id);
    for (;;) {
      try {
        const { at, text } = kept;
        this.storage().setItem(PREFIX + kept.id, JSON.stringify({ at, text }));
        return true;
      } catch {
        // What is oldest makes room for what is newest.
        const oldest = others.pop();
        if (!oldest) return false;
        this.remove(oldest.id);
      }
    }
  }

  remove(id: string): void {
    try {
      this.storage().removeItem(id === "" ? FIRST_KEY : PREFIX + id);
    } catch {
      // Without a storage there is nothing to remove.
    }
  }

  private all(): Kept[] {
    try {
      const storage = this.storage();
      const keys = Array.from({ length: storage.length }, (_, i) => storage.key(i) ?? "");
      return keys.flatMap((key) => entry(key, storage.getItem(key))).sort((a, b) => b.at - a.at);
    } catch {
      return [];
    }
  }
}

function entry(key: string, value: string | null): Kept[] {
  if (value === null) return [];
  if (key === FIRST_KEY) return [{ id: "", at: 0, text: value }];
  if (!key.startsWith(PREFIX)) return [];
  try {
    const { at, text } = JSON.parse(value);
    return typeof at === "number" && typeof text === "string" ? [{ id: key.slice(PREFIX.length), at, text }] : [];
  } catch {
    return []; // Not written by this page.
  }
}
