/** The element as an anywidget: what Python gives goes in, the report and φ at points come out. */

import { define, TAG, type ThinShellMatch } from "./element";
import type { GivenLoop, GivenPin } from "./matching";

/** As far as it is used of an anywidget's model. */
type Model = {
  get(name: string): unknown;
  set(name: string, value: unknown): void;
  save_changes(): void;
  on(event: string, heard: () => void): void;
  off(event: string, heard: () => void): void;
};

/** What is given, in the order in which it is to be taken: a state has all of it. */
const GIVEN: Readonly<Record<string, (element: ThinShellMatch, value: never) => void>> = {
  state: (element, value: string) => {
    if (value) element.setAttribute("state", value);
  },
  settings: (element, value: object) => {
    if (Object.keys(value).length > 0) element.settings = value;
  },
  reference: (element, value: readonly GivenLoop[]) => {
    if (value.length > 0) element.reference = value;
  },
  template: (element, value: readonly GivenLoop[]) => {
    if (value.length > 0) element.template = value;
  },
  pins: (element, value: readonly GivenPin[]) => {
    if (value.length > 0) element.pins = value;
  },
  view: (element, value: string) => {
    element.view = value || "grid";
  },
  morph: (element, value: number) => {
    element.morph = value;
  },
};

export function render({ model, el }: { model: Model; el: HTMLElement }): () => void {
  define();
  const element = document.createElement(TAG) as ThinShellMatch;
  const listening = new AbortController();
  const give = (name: string) => {
    try {
      GIVEN[name](element, (model.get(name) ?? "") as never);
    } catch (error) {
      fail(error instanceof Error ? error.message : String(error));
    }
  };
  const fail = (problem: string) => {
    model.set("problem", problem);
    model.save_changes();
  };
  const answer = () => {
    const points = (model.get("points") ?? []) as [number, number][];
    model.set("report", element.report ?? {});
    model.set("mapped", element.map(points) ?? []);
    model.set("problem", "");
    model.save_changes();
  };
  element.addEventListener("match", answer, { signal: listening.signal });
  element.addEventListener("problem", (event) => fail(String((event as CustomEvent).detail)), {
    signal: listening.signal,
  });
  const heard = Object.keys(GIVEN).map((name) => [`change:${name}`, () => give(name)] as const);
  const all = [...heard, ["change:points", () => element.report && answer()] as const];
  for (const [event, hear] of all) model.on(event, hear);
  for (const name of Object.keys(GIVEN)) give(name);
  el.append(element);
  return () => {
    listening.abort();
    for (const [event, hear] of all) model.off(event, hear);
    element.remove();
  };
}
