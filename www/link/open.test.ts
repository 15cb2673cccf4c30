import { describe, expect, test, vi } from "vitest";
import { addressOf, fallback, linkIn, open } from "./open";
import { encode } from "./text";

const STORED = encode({ ...fallback(), preset: "ring" });

function opened(hash: string, search = "", stored: string | null = STORED) {
  return open({ hash, search }, stored);
}

describe("the page starts", () => {
  test("with its link, and the address needs no writing", () => {
    const { saved, ...rest } = opened("#v=2&preset=leaf&bending=0");
    expect(saved).toMatchObject({ preset: "leaf", settings: { bending: 0 } });
    expect(rest).toEqual({ problem: null, unread: false, unwritten: false, later: false });
  });

  test("without one with what was stored, and without that with the first example", () => {
    expect(opened("")).toMatchObject({ saved: { preset: "ring" }, problem: null, unwritten: true });
    const nothing = { saved: fallback(), problem: null, unread: false, unwritten: false, later: false };
    expect(opened("", "", null)).toEqual(nothing);
  });

  test("with the first example where what was stored cannot be read, which is said", () => {
    const { saved, problem, unread, unwritten } = opened("", "", "v=7&nonsense");
    expect([saved, unread, unwritten]).toEqual([fallback(), true, false]);
    expect(problem).toMatch(/^What was here last could not be read: version “7” is not known\. It stays under “Recent/);
    expect(opened("#v=2&preset=leaf", "", "v=7&nonsense")).toMatchObject({ problem: null, unread: true });
    expect(opened("#v=2&preset=dragon", "", "v=7&nonsense")).toMatchObject({ saved: fallback(), unread: true });
  });

  test("a link that cannot be read is reported and takes nothing away", () => {
    const { saved, problem } = opened("#v=2&preset=dragon");
    expect(problem).toMatch(
      /^The link could not be read: there is no example called “dragon”\. What would be here without it/,
    );
    expect(saved.preset).toBe("ring");
  });

  test("an anchor of the page is no link, and what is neither is said", () => {
    expect(linkIn("#method")).toBeNull();
    expect(linkIn("")).toBeNull();
    expect(opened("#method")).toMatchObject({ saved: { preset: "ring" }, problem: null });
    expect(() => linkIn("#utm_source=elsewhere")).toThrow("no link of this page");
    expect(() => linkIn("#v2/preset,star")).toThrow("no link of this page");
  });

  test("the match is left to a press where link or query says so", () => {
    expect(opened("#v=2&preset=leaf&match=later").later).toBe(true);
    expect(opened("#v=2&preset=leaf", "?match=later").later).toBe(true);
    expect(opened("", "?match=later", null).later).toBe(true);
  });
});

describe("settings in the query", () => {
  test("stand instead of the link's, and leave its others", () => {
    const { saved, unwritten } = opened("#v=2&preset=leaf&bending=1&finest=6", "?bending=0&view=stretch&utm=x");
    expect(saved).toMatchObject({ preset: "leaf", settings: { bending: 0, finest: 6 }, view: "stretch" });
    expect(unwritten).toBe(true);
  });

  test("stand instead of what was stored, and of the first example's", () => {
    expect(opened("", "?bending=0").saved).toMatchObject({ preset: "ring", settings: { bending: 0 } });
    expect(opened("", "?bending=0", null).saved).toEqual({ ...fallback(), settings: { bending: 0 } });
  });

  test("are left out with a sentence where they cannot be", () => {
    const { saved, problem } = opened("#v=2&preset=leaf&bending=1", "?bending=much&finest=6");
    expect(problem).toMatch(/^The address asks for what cannot be: Bending is “much”, but must be/);
    expect(saved).toMatchObject({ preset: "leaf", settings: { bending: 1 } });
  });

  test("are gone from the address once the fragment has them; what is not ours stays", () => {
    vi.stubGlobal("location", { href: "https://example.org/a/?bending=0&utm=x#v=2&preset=leaf" });
    expect(addressOf("v=2&preset=leaf&bending=0")).toBe("https://example.org/a/?utm=x#v=2&preset=leaf&bending=0");
    vi.unstubAllGlobals();
  });
});
