/** What the whole page does while it is about surfaces. */

import { useEffect } from "preact/hooks";
import { language } from "../words/language";
import { space as say } from "../words/space";
import type { Ways } from "./ways";

/** Files dropped anywhere: onto the template for it, else for the reference. */
export function useDrops(ways: Ways): void {
  useEffect(() => {
    const over = (event: DragEvent) => {
      if (!event.dataTransfer?.types.includes("Files")) return;
      event.preventDefault();
      document.documentElement.toggleAttribute("data-dropping", true);
    };
    const end = () => document.documentElement.toggleAttribute("data-dropping", false);
    const drop = (event: DragEvent) => {
      end();
      const [file] = event.dataTransfer?.files ?? [];
      if (!file) return;
      event.preventDefault();
      const section = event.target instanceof Element ? event.target.closest(".sketch") : null;
      void ways.take(section?.querySelector("#template-surface") ? "template" : "reference", file);
    };
    addEventListener("dragover", over);
    addEventListener("dragleave", end);
    addEventListener("drop", drop);
    return () => {
      end();
      removeEventListener("dragover", over);
      removeEventListener("dragleave", end);
      removeEventListener("drop", drop);
    };
  }, [ways]);
}

/** The page says what it is about; what explains curves goes. */
export function useTitle(): void {
  const spoken = language.value;
  useEffect(() => {
    const root = document.documentElement;
    const texts = { title: say.document, h1: say.title, ".promise": say.promise };
    const back = Object.entries(texts).map(([place, text]) => inPlaceOf(document.querySelector(place), text));
    root.toggleAttribute("data-space", true);
    return () => {
      for (const bring of back) bring();
      root.toggleAttribute("data-space", false);
    };
  }, [spoken]);
}

/** Another element, for the sentences of the first change with the language. Returns how to bring it back. */
function inPlaceOf(element: Element | null, text: string): () => void {
  const other = element?.cloneNode() as Element | undefined;
  if (!element || !other) return () => {};
  other.textContent = text;
  element.replaceWith(other);
  return () => other.replaceWith(element);
}
