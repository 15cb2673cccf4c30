/** A storage for tests, with room for so many letters. */
export function fakeStorage(room = Number.POSITIVE_INFINITY): Storage {
  const all = new Map<string, string>();
  const used = () => [...all].reduce((sum, [key, value]) => sum + key.length + value.length, 0);
  return {
    get length() {
      return all.size;
    },
    key: (i) => [...all.keys()][i] ?? null,
    getItem: (key) => all.get(key) ?? null,
    setItem: (key, value) => {
      const before = all.get(key);
      all.delete(key);
      if (used() + key.length + value.length > room) {
        if (before !== undefined) all.set(key, before);
        throw new DOMException("full", "QuotaExceededError");
      }
      all.set(key, value);
    },
    removeItem: (key) => {
      all.delete(key);
    },
    clear: () => all.clear(),
  };
}
