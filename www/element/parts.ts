/** What is seen of an element: the picture, its controls and the line of words. Each follows a matching until it is stopped. */

import { effect, type ReadonlySignal } from "@preact/signals";
import { bandwidth } from "../settings";
import { Surface } from "../view/canvas";
import { framing, type Square } from "../view/framing";
import { VIEWS } from "../view/names";
import { pattern } from "../view/picture";
import { drawMissed, drawResult, type ResultScene } from "../view/result";
import { missedBy } from "../view/unreached";
import { drawView, limitOf } from "../view/views";
import { en } from "../words/en";
import { resultState } from "../words/said";
import type { Matching } from "./matching";

/** Puts itself into the root; gives how to stop following. */
type Stop = () => void;

export function picture(root: ShadowRoot, { shapes, settings, view, morph, match, phase }: Matching): Stop {
  const canvas = document.createElement("canvas");
  canvas.setAttribute("role", "img");
  const element = document.createElement("div");
  element.className = "surface";
  element.append(canvas);
  // First, for its colours are those of the place where it is.
  root.append(element);
  let square: Square | null = null;
  const seen = () => {
    const { reference, template } = shapes.peek();
    square = framing([...reference, ...template], square);
    return square;
  };
  const surface = new Surface(canvas, seen, (context, frame, colours) => {
    const found = match.peek();
    const shown = found && { ...found, level: found.status.level };
    const width = bandwidth(settings.peek());
    const missed = missedBy(found);
    const scene: ResultScene = { ...shapes.peek(), match: shown, morph: morph.peek(), bandwidth: width, missed };
    const name = view.peek();
    if (name === "grid" || !shown) drawResult(context, frame, colours, scene);
    else {
      const limit = limitOf(name, shown, width) || 1;
      drawView(name, context, frame, colours, { ...scene, match: shown, limit, picture: pattern() });
      if (name !== "pullback") drawMissed(context, frame, colours, missed);
    }
  });
  const follow = effect(() => {
    for (const value of [shapes, settings, view, morph]) value.value;
    const status = match.value?.status ?? null;
    canvas.setAttribute("aria-label", resultState({ phase: phase.value, status, stale: false }));
    surface.invalidate();
  });
  return () => {
    follow();
    surface.dispose();
  };
}

export function viewPicker(root: ShadowRoot, matching: Matching): Stop {
  const element = document.createElement("select");
  element.setAttribute("aria-label", "View");
  for (const view of VIEWS) element.add(new Option(en.views[view], view));
  element.onchange = () => matching.setView(element.value);
  root.append(element);
  return effect(() => {
    element.value = matching.view.value;
  });
}

export function morphSlider(root: ShadowRoot, matching: Matching): Stop {
  const element = document.createElement("input");
  Object.assign(element, { type: "range", min: "0", max: "1", step: "0.01" });
  element.setAttribute("aria-label", "Morph");
  element.oninput = () => matching.setMorph(element.valueAsNumber);
  root.append(element);
  return effect(() => {
    element.value = String(matching.morph.value);
    element.disabled = matching.match.value === null;
  });
}

/** What is wrong is said in any case, the rest where it is wanted. */
export function words(
  root: ShadowRoot,
  { match, phase }: Matching,
  problem: ReadonlySignal<string | null>,
  isWanted: boolean,
): Stop {
  const element = document.createElement("p");
  element.setAttribute("role", "status");
  root.append(element);
  return effect(() => {
    const status = match.value?.status;
    const said = status?.verdict ?? resultState({ phase: phase.value, status: status ?? null, stale: false });
    element.textContent = problem.value ?? (isWanted ? said : "");
    element.className = problem.value ? "problem" : "";
  });
}
