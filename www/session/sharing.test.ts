import { signal } from "@preact/signals";
import { beforeEach, expect, test, vi } from "vitest";
import { PRESETS } from "../shapes/presets";
import type { View } from "../view/names";
import { stepOf } from "./edits";
import { Sharing } from "./sharing";

const [FIRST] = PRESETS;
const STEP = stepOf({ ...FIRST, pins: [] }, { bending: 0 }, FIRST.id);

beforeEach(() => {
  vi.stubGlobal("location", { href: "https://example.org/?lang=de&bending=1#old" });
});

function stage(choose: (view: View) => Promise<void> = async () => {}) {
  const view = signal<View>("stretch");
  const morph = signal(0.5);
  const problem = signal<string | null>(null);
  const chosen: View[] = [];
  const looks = {
    view,
    choose: (wanted: View) => {
      chosen.push(wanted);
      return choose(wanted);
    },
  };
  return { sharing: new Sharing(looks, morph, problem), view, morph, problem, chosen };
}

test("a link has what was drawn and chosen, and how it is looked at", () => {
  const { sharing, view, morph } = stage();
  expect(sharing.link(STEP)).toBe(`v=2&preset=${FIRST.id}&bending=0&view=stretch&morph=0.5`);
  [view.value, morph.value] = ["grid", 1];
  expect(sharing.link(STEP)).toBe(`v=2&preset=${FIRST.id}&bending=0`);
});

test("an address leaves out what its link says already, and the language, which is its reader's", () => {
  const { sharing } = stage();
  expect(sharing.address(STEP)).toBe(`https://example.org/#${sharing.link(STEP)}`);
});

test("a view is fetched only where it is another one, and the morph follows at once", () => {
  const { sharing, morph, chosen } = stage();
  sharing.look({ view: "stretch", morph: 0.25 });
  sharing.look({ view: "band", morph: 1 });
  expect([morph.value, chosen]).toEqual([1, ["band"]]);
});

test("a view that cannot be had is said", async () => {
  const { sharing, problem } = stage(() => Promise.reject(new Error("This view could not be loaded.")));
  sharing.look({ view: "image", morph: 1 });
  await vi.waitFor(() => expect(problem.value).toBe("This view could not be loaded."));
});
