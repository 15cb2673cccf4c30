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
    element.settings = value;
  },
  reference: (element, value: readonly GivenLoop[]) => {
    element.reference = value;
  },
  template: (element, value: readonly GivenLoop[]) => {
    element.template = value;
  },
  pins: (element, value: readonly GivenPin[]) => {
    element.pins = value;
  },
  view: (element, value: string) => {
    element.view = value || "grid";
  },
  morph: (element, value: number | null) => {
    element.morph = value ?? 1;
  },
};

/** Whether something has been given: what is empty from the start leaves what the state says. */
function isGiven(value: unknown): boolean {
  return value !== undefined && value !== null && Object.keys(Object(value)).length > 0;
}

/** The model of a MyST book has nobody behind it: it throws where it is asked to tell, or to forget. */
function tolerant(work: () => void): void {
  try {
    work();
  } catch {
    // The picture does not depend on it.
  }
}

export function render({ model, el }: { model: Model; el: HTMLElement }): () => void {
  define();
  const element = document.createElement(TAG) as ThinShellMatch;
  const listening = new AbortController();
  const attempt = (work: () => void) => {
    try {
      work();
    } catch (error) {
      fail(error instanceof Error ? error.message : String(error));
    }
  };
  const give = (name: string) => attempt(() => GIVEN[name](element, model.get(name) as never));
  const fail = (problem: string) => {
    model.set("problem", problem);
    tolerant(() => model.save_changes());
  };
  const answer = () =>
    attempt(() => {
      const mapped = element.map((model.get("points") ?? []) as [number, number][]);
      model.set("report", element.report ?? {});
      model.set("mapped", mapped ?? []);
      model.set("problem", "");
      tolerant(() => model.save_changes());
    });
  element.addEventListener("match", answer, { signal: listening.signal });
  element.addEventListener("problem", (event) => fail(String((event as CustomEvent).detail)), {
    signal: listening.signal,
  });
  const heard = Object.keys(GIVEN).map((name) => [`change:${name}`, () => give(name)] as const);
  const all = [...heard, ["change:points", () => element.report && answer()] as const];
  for (const [event, hear] of all) model.on(event, hear);
  for (const name of Object.keys(GIVEN)) {
    const value = model.get(name);
    if (typeof value === "number" || isGiven(value)) give(name);
  }
  el.append(element);
  return () => {
    listening.abort();
    for (const [event, hear] of all) tolerant(() => model.off(event, hear));
    element.remove();
  };
}
