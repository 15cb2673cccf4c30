/** The ways into the import besides its button: a drop, a paste. They come with what draws. */

import type { Side } from "../session";
import { importing } from "./imported";

/** Files and texts dropped or pasted anywhere on the page open the dialog. Returns how to stop listening. */
export function listenForImports(): () => void {
  const listening = new AbortController();
  const options = { signal: listening.signal };
  addEventListener("dragover", (event) => dragOver(event), options);
  addEventListener("dragleave", (event) => event.relatedTarget === null && showTargets(false), options);
  addEventListener("drop", (event) => drop(event), options);
  addEventListener("paste", (event) => paste(event), options);
  return () => listening.abort();
}

function dragOver(event: DragEvent): void {
  if (!event.dataTransfer?.types.some((type) => type === "Files" || type === "text/plain")) return;
  // Without this the browser would leave the page for the dropped file.
  event.preventDefault();
  event.dataTransfer.dropEffect = "copy";
  showTargets(true);
}

/** The style sheet marks the surfaces while something to drop is over the page. */
function showTargets(on: boolean): void {
  document.documentElement.toggleAttribute("data-dropping", on);
}

function drop(event: DragEvent): void {
  showTargets(false);
  if (isField(event.target) || !event.dataTransfer) return;
  event.preventDefault();
  const side = sideAt(event.target);
  const { files, items } = event.dataTransfer;
  // Entries are there only as long as the event is.
  const entries = [...items].map((item) => item.webkitGetAsEntry()).filter((entry) => entry !== null);
  if (files.length > 1 || entries.some((entry) => entry.isDirectory)) {
    const many = entries.length > 0 ? entries : [...files];
    importing.value = { side, input: null, many };
    return;
  }
  const input = files[0] ?? event.dataTransfer.getData("text/plain");
  if (input) importing.value = { side, input };
}

function paste(event: ClipboardEvent): void {
  if (isField(event.target) || !event.clipboardData) return;
  const input = event.clipboardData.files[0] ?? event.clipboardData.getData("text/plain");
  if (!input) return;
  event.preventDefault();
  importing.value = { side: sideAt(event.target), input };
}

function isField(target: EventTarget | null): boolean {
  return target instanceof HTMLTextAreaElement || target instanceof HTMLInputElement;
}

/** What lands on the template's panel is for the template, all else for the side in question or the reference. */
function sideAt(target: EventTarget | null): Side {
  const panel = target instanceof Element ? target.closest("section.sketch") : null;
  if (panel) return panel.getAttribute("aria-labelledby") === "template-name" ? "template" : "reference";
  return importing.value?.side ?? "reference";
}
