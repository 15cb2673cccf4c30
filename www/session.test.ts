import { signal } from "@preact/signals";
import { beforeEach, expect, test, vi } from "vitest";
import { open } from "./link/open";
import { Memory } from "./memory/memory";
import { Sessions } from "./memory/sessions";
import { Session } from "./session";
import { FIELDS } from "./settings";
import { PRESETS } from "./shapes/presets";
import { puppetEngine } from "./testing/puppet";
import { fakeStorage } from "./testing/storage";
import type { View } from "./view/names";

let address = "";

beforeEach(() => {
  vi.stubGlobal("location", { href: "https://example.org/" });
  vi.stubGlobal("history", {
    replaceState: (_: unknown, __: string, to: string) => {
      address = to;
    },
  });
  vi.useFakeTimers();
  vi.stubGlobal("requestAnimationFrame", () => 1);
  vi.stubGlobal("cancelAnimationFrame", () => {});
  vi.stubGlobal("addEventListener", () => {});
});

function stage(hash = "#v=1&preset=star&finest=5") {
  const { engine, puppets } = puppetEngine();
  const view = signal<View>("grid");
  const choose = async (wanted: View) => {
    view.value = wanted;
  };
  const local = fakeStorage();
  const memory = new Memory(new Sessions(() => local), { id: "tab" });
  const opened = open({ hash, search: "" }, null);
  const session = new Session(engine, opened, { view, choose }, memory);
  return { puppet: puppets[0], session, view, memory };
}

const BENDING = FIELDS.find(({ name }) => name === "bending");

test("a first look is taken at what a link shows, and none at nothing", () => {
  const { puppet, session } = stage();
  session.glance();
  expect(puppet.starts).toHaveLength(1);
  const empty = stage("#v=1&reference=&template=");
  empty.session.glance();
  expect(empty.puppet.starts).toHaveLength(0);
});

test("a link that leaves the match to a press starts nothing when it is opened over another", () => {
  const { puppet, session } = stage();
  session.openLink("#v=1&preset=leaf&match=later");
  expect(puppet.starts).toHaveLength(0);
  session.openLink("#v=1&preset=leaf");
  expect(puppet.starts).toHaveLength(1);
});

test("a shape that is taken away while it is matched ends the run without a complaint", () => {
  const { puppet, session } = stage();
  session.start();
  session.commitShape("template", []);
  expect(session.phase.value).toBe("idle");
  expect(session.problem.value).toBeNull();
  vi.advanceTimersByTime(1000);
  expect(puppet.starts).toHaveLength(1);
});

test("a term that is left out at the result is matched without at once", () => {
  const { puppet, session } = stage();
  if (!BENDING) throw new Error("bending is a setting of the page");
  session.start();
  puppet.frame(true);
  session.choices.tryOut(BENDING, 0);
  expect(puppet.starts.at(-1)).toMatchObject({ settings: { bending: 0 } });
});

test("a finished run is kept, and shown again with its own shapes and settings", () => {
  const { puppet, session } = stage();
  if (!BENDING) throw new Error("bending is a setting of the page");
  session.start();
  puppet.frame(true);
  session.choices.tryOut(BENDING, 0);
  puppet.frame(true);
  const [second, first] = session.runs.list.value;
  expect([first.settings.bending, second.settings.bending]).toEqual([undefined, 0]);
  const leaf = PRESETS.find(({ id }) => id === "leaf");
  if (!leaf) throw new Error("the leaf is an example");
  session.choosePreset(leaf);
  session.showAgain(first);
  expect(session.shapes.value.reference).toBe(first.reference);
  expect(session.settings.value).toEqual({ finest: 5 });
  expect([session.phase.value, session.stale.value]).toEqual(["restored", false]);
  session.undo();
  expect(session.shapes.value.reference).toBe(leaf.reference);
});

test("runs that only follow the hand are none to come back to", () => {
  const { puppet, session } = stage();
  session.setLive(true);
  puppet.frame(true);
  expect(session.runs.list.value).toHaveLength(0);
});

test("a setting is one step to undo, and the match that was made with it fits again", () => {
  const { puppet, session } = stage();
  if (!BENDING) throw new Error("bending is a setting of the page");
  session.start();
  puppet.frame(true);
  session.choices.preview(BENDING, 2, 0);
  session.choices.preview(BENDING, 1, 0);
  session.choices.change(BENDING, 1);
  expect(session.stale.value).toBe(true);
  session.undo();
  expect([session.settings.value, session.stale.value, session.canUndo.value]).toEqual([{ finest: 5 }, false, false]);
  session.redo();
  expect(session.settings.value).toEqual({ finest: 5, bending: 1 });
});

test("the same value chosen again is no step", () => {
  const { session } = stage();
  if (!BENDING) throw new Error("bending is a setting of the page");
  session.choices.change(BENDING, BENDING.initial);
  session.choices.reset();
  expect(session.settings.value).toEqual({});
  session.undo();
  expect([session.settings.value, session.canUndo.value]).toEqual([{ finest: 5 }, false]);
});

test("undo after a link brings back shapes and settings alike", () => {
  const { session } = stage();
  const before = session.shapes.value;
  session.openLink("#v=1&preset=leaf&bending=0.5&finest=6");
  expect(session.settings.value).toEqual({ finest: 6, bending: 0.5 });
  session.undo();
  expect([session.shapes.value, session.settings.value]).toEqual([before, { finest: 5 }]);
});

test("a link carries the view and the morph", () => {
  const { session, view } = stage();
  session.openLink("#v=2&preset=leaf&view=stretch&morph=0.5");
  expect([view.value, session.morph.value]).toEqual(["stretch", 0.5]);
  expect(session.link()).toBe("v=2&preset=leaf&view=stretch&morph=0.5");
});

test("a link that cannot be read ends in a sentence, changes nothing, and the address holds the shapes again", () => {
  const { puppet, session } = stage();
  const before = session.link();
  for (const hash of ["#v=2&preset=dragon", "#v=9", "#utm=x", "#v=2&reference=AAAA&template=", "#%%%=%"]) {
    session.openLink(hash);
    expect(session.problem.value).toMatch(/^The link could not be read: .*\. Everything is left as it was\.$/);
    expect([session.link(), address, session.canUndo.value]).toEqual([before, `https://example.org/#${before}`, false]);
  }
  expect(puppet.starts).toHaveLength(0);
});

test("an anchor of the page is followed, not read", () => {
  const { session } = stage();
  const before = session.link();
  session.openLink("#method");
  expect([session.link(), session.problem.value, session.canUndo.value]).toEqual([before, null, false]);
});

test("every step is kept at once, before the next moment can lose it", () => {
  const { session, memory } = stage();
  session.commitShape("template", []);
  expect(memory.sessions.list()).toMatchObject([{ id: "tab", text: session.link() }]);
  session.undo();
  expect(memory.sessions.list()).toMatchObject([{ id: "tab", text: session.link() }]);
});

test("that nothing is kept is said once, and stays said until it has been read", () => {
  const { session, memory } = stage();
  vi.spyOn(memory.sessions, "write").mockReturnValue(false);
  session.commitShape("template", []);
  session.commitShape("reference", []);
  expect(session.notice.value).toMatch(/^This browser keeps nothing for you/);
  session.notice.value = null;
  session.undo();
  expect(session.notice.value).toBeNull();
});
