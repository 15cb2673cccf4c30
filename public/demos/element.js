// How a page uses the element: docs/element.md in the sources says all of it.

import "./thin-shell-match.js";

const ellipse = (a, b) => [
  Array.from({ length: 120 }, (_, i) => {
    const t = (2 * Math.PI * i) / 120;
    return [0.5 + a * Math.cos(t), 0.5 + b * Math.sin(t)];
  }),
];

const first = document.getElementById("first");
first.addEventListener("match", ({ detail }) => {
  const [[x, y]] = first.map([[0.5, 0.5]]);
  document.getElementById("said").textContent =
    `${detail.verdict} The middle goes to ${x.toFixed(3)}, ${y.toFixed(3)}.`;
});

const second = document.getElementById("second");
second.addEventListener("match", ({ detail }) => {
  document.getElementById("stretch").textContent = detail.stretch.mean.toFixed(2);
});
second.settings = { finest: 6 };
second.reference = ellipse(0.2, 0.2);
second.template = ellipse(0.25, 0.15);

document.getElementById("other").onclick = () => {
  second.template = ellipse(0.4, 0.15);
};
