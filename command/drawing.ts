/** What the page's reader of drawings asks of a browser: an XML parser and its elements. */

import { DOMParser } from "linkedom";
import { ImportError } from "../www/shapes/import/found";

/** Gives this process a DOMParser. It takes anything for XML, so whoever reads asks `checkWellFormed` before. */
export function provideParser(): void {
  Object.assign(globalThis, { DOMParser });
}

/** What begins with "<" and is no element, and tags: their name, whether they end one, and whether they are both. */
const MARKUP =
  /<!--[\s\S]*?-->|<!\[CDATA\[[\s\S]*?\]\]>|<\?[\s\S]*?\?>|<!DOCTYPE(?:[^[>]|\[[^\]]*\])*>|<(\/?)([A-Za-z_][\w.:-]*)((?:[^<>"']|"[^"<]*"|'[^'<]*')*?)(\/?)>|</gi;

/** Throws where elements are not nested, or the text ends before they do: a drawing that is cut off. */
export function checkWellFormed(text: string): void {
  const open: string[] = [];
  let roots = 0;
  for (const { 0: whole, 1: ending, 2: name, 4: single, index } of text.matchAll(MARKUP)) {
    if (whole === "<") throw broken(text, index, "a tag does not end");
    if (name === undefined) continue;
    if (!ending) {
      if (open.length === 0) roots += 1;
      if (!single) open.push(name);
    } else if (open.pop() !== name) throw broken(text, index, `</${name}> ends what has not begun`);
  }
  if (open.length > 0) throw broken(text, text.length, `<${open[open.length - 1]}> does not end`);
  if (roots > 1) throw broken(text, text.length, "it has more than one root");
}

function broken(text: string, index: number, why: string): ImportError {
  const line = text.slice(0, index).split("\n").length;
  return new ImportError(`The SVG is broken (line ${line}: ${why}); save or copy it again, whole.`);
}
