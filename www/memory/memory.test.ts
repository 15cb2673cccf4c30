import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { fakeStorage } from "../testing/storage";
import { Memory } from "./memory";
import { Sessions } from "./sessions";
import { Tab } from "./tab";

let address = "";

beforeEach(() => {
  address = "https://example.org/";
  vi.stubGlobal("history", {
    replaceState: (_: unknown, __: string, to: string) => {
      address = to;
    },
  });
  vi.stubGlobal("location", { href: "https://example.org/" });
});
afterEach(() => {
  vi.unstubAllGlobals();
});

/** Locks as browsers have them: `release` ends all that a tab holds. */
function fakeLocks() {
  const held = new Set<string>();
  const forTab = () => ({
    request: async (name: string, _: unknown, work: (lock: Lock | null) => unknown) => {
      if (held.has(name)) return work(null);
      held.add(name);
      work({ name, mode: "exclusive" });
    },
  });
  return { forTab: forTab as unknown as () => LockManager, release: () => held.clear() };
}

test("two tabs have sessions of their own, and a third begins with the last of them", () => {
  const local = fakeStorage();
  const locks = fakeLocks();
  const open = () => new Memory(new Sessions(() => local), new Tab(fakeStorage, locks.forTab()));
  vi.setSystemTime(1);
  const first = open();
  first.keep("v=2&preset=star");
  vi.setSystemTime(2);
  const second = open();
  expect(second.found).toBe("v=2&preset=star");
  second.keep("v=2&preset=leaf");
  vi.setSystemTime(3);
  first.keep("v=2&preset=ring");
  expect(first.sessions.list().map(({ text }) => text)).toEqual(["v=2&preset=ring", "v=2&preset=leaf"]);
  expect(open().found).toBe("v=2&preset=ring");
  vi.useRealTimers();
});

test("after a reload a tab goes on with its own session, not with the last of all", () => {
  const local = fakeStorage();
  const locks = fakeLocks();
  const session = fakeStorage();
  const before = new Memory(new Sessions(() => local), new Tab(() => session, locks.forTab()));
  before.keep("v=2&preset=star");
  new Memory(new Sessions(() => local), new Tab(fakeStorage, locks.forTab())).keep("v=2&preset=leaf");
  locks.release();
  const after = new Memory(new Sessions(() => local), new Tab(() => session, locks.forTab()));
  expect([after.own, after.found]).toEqual([before.own, "v=2&preset=star"]);
});

test("what is set aside stays as it was, however often, beside what is kept from then on", () => {
  vi.setSystemTime(1);
  const storage = fakeStorage();
  const memory = new Memory(new Sessions(() => storage), { id: "a" });
  memory.keep("v=7&preset=star");
  vi.setSystemTime(2);
  for (let k = 0; k < 2; k += 1) memory.setAside();
  memory.keep("v=2&preset=leaf");
  expect(memory.sessions.list()).toEqual([
    { id: "a", at: 2, text: "v=2&preset=leaf" },
    { id: "a-1", at: 1, text: "v=7&preset=star" },
  ]);
  vi.useRealTimers();
});

test("a duplicated tab, which has the other's name, takes another before it writes", async () => {
  const locks = fakeLocks();
  const session = fakeStorage();
  const original = new Tab(() => session, locks.forTab());
  const copied = fakeStorage();
  copied.setItem("thinshell:tab", original.id);
  const duplicate = new Tab(() => copied, locks.forTab());
  await Promise.resolve();
  expect(duplicate.id).not.toBe(original.id);
  expect(copied.getItem("thinshell:tab")).toBe(duplicate.id);
});

test("without locks, as without https, a duplicated tab asks whose its name is, and takes another", () => {
  const ends: { onmessage: ((event: MessageEvent) => void) | null }[] = [];
  const channel = () => {
    const end = {
      onmessage: null,
      postMessage: (data: unknown) => {
        for (const other of ends) if (other !== end) other.onmessage?.({ data } as MessageEvent);
      },
    };
    ends.push(end);
    return end;
  };
  const session = fakeStorage();
  const original = new Tab(() => session, null, channel);
  const own = original.id;
  const copied = fakeStorage();
  copied.setItem("thinshell:tab", own);
  const duplicate = new Tab(() => copied, null, channel);
  expect(duplicate.id).not.toBe(own);
  expect(copied.getItem("thinshell:tab")).toBe(duplicate.id);
  expect(original.id).toBe(own);
  // A reload ends the old one first: it finds its name again.
  ends.splice(0, 1);
  expect(new Tab(() => session, null, channel).id).toBe(own);
});

test("a storage that keeps nothing is told of once, and the address holds the text all the same", () => {
  const memory = new Memory(new Sessions(() => fakeStorage(0)), { id: "a" });
  let told = 0;
  memory.onFailure = () => {
    told += 1;
  };
  memory.remember("v=2&preset=star");
  memory.remember("v=2&preset=leaf");
  expect([told, address]).toEqual([1, "https://example.org/#v=2&preset=leaf"]);
  expect(memory.writes.value).toBe(2);
});
