// What a notebook does with the file, done by hand.

import widget from "./thin-shell-match.js";

/** As an anywidget's model: values by name, and who wants to hear of a change. */
const values = { state: "v=2&preset=ellipse&finest=6", points: [[0.65, 0.5]], view: "stretch", morph: 1 };
const listeners = new Map();
const model = {
  get: (name) => values[name],
  set: (name, value) => {
    values[name] = value;
  },
  save_changes: () => {
    const { report, mapped, problem } = values;
    const text =
      problem ||
      `stretch ${report.stretch.mean.toFixed(2)}, mapped ${mapped.map((one) => one.map((x) => x.toFixed(3)))}`;
    document.getElementById("model").textContent = text;
  },
  on: (event, hear) => listeners.set(event, [...(listeners.get(event) ?? []), hear]),
  off: (event, hear) =>
    listeners.set(
      event,
      listeners.get(event)?.filter((other) => other !== hear),
    ),
};

/** As if Python had set it. */
function give(name, value) {
  values[name] = value;
  for (const hear of listeners.get(`change:${name}`) ?? []) hear();
}

widget.render({ model, el: document.getElementById("place") });

const circle = Array.from({ length: 90 }, (_, i) => [
  0.5 + 0.3 * Math.cos(i / 14.324),
  0.5 + 0.3 * Math.sin(i / 14.324),
]);
document.getElementById("other").onclick = () => give("template", [circle]);
document.getElementById("wrong").onclick = () => give("template", [[[0, 0]]]);
