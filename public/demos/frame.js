// How a page talks to the frame that it holds: docs/embedding.md in the sources says all of it.

const frame = document.querySelector("iframe");
const heard = document.getElementById("heard");

// `?page=` names thinshell's address where it is not the folder above this one.
const page = new URL(new URLSearchParams(location.search).get("page") ?? "../", location.href);
frame.src = new URL(`?embed=result&origin=${location.origin}#v=2&preset=ellipse`, page).href;

/** Sends a message and waits for its answer, by its number. */
let last = 0;
const waiting = new Map();
function ask(message) {
  last += 1;
  frame.contentWindow.postMessage({ thinshell: 1, id: last, ...message }, page.origin);
  return new Promise((resolve) => waiting.set(last, resolve));
}

addEventListener("message", ({ data, source, origin }) => {
  if (source !== frame.contentWindow || origin !== page.origin || data?.thinshell !== 1) return;
  waiting.get(data.id)?.(data);
  waiting.delete(data.id);
  show(data);
});

function show({ kind, message, report, points }) {
  if (kind === "finished") heard.textContent = `finished: ${report.match.verdict}`;
  else if (kind === "refused") heard.textContent = `refused: ${message}`;
  else if (kind === "mapped")
    heard.textContent = `mapped: ${points.map((one) => one.map((x) => x.toFixed(3))).join(" ")}`;
  else heard.textContent = kind;
}

for (const button of document.querySelectorAll("[data-state]"))
  button.onclick = () => ask({ kind: "set", state: button.dataset.state });
document.getElementById("middle").onclick = () => ask({ kind: "map", points: [[0.5, 0.5]] });
