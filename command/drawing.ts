/** What the page's reader of drawings asks of a browser: an XML parser and its elements. */

import { DOMParser } from "linkedom";
import { ImportError } from "../www/shapes/import/found";

/**
 * Gives this process a DOMParser. It takes anything for XML, so whoever reads asks `checkWellFormed` before, and it knows
 * no namespaces, so what is in those of SVG and XLink loses its prefix first.
 */
export function provideParser(): void {
  class Parser {
    parseFromString(text: string, type: "image/svg+xml") {
      return new DOMParser().parseFromString(withoutPrefixes(text), type);
    }
  }
  Object.assign(globalThis, { DOMParser: Parser });
}

function withoutPrefixes(text: string): string {
  const bound = (namespace: string) =>
    [...text.matchAll(/xmlns:([\w-]{1,40})\s*=\s*(["'])(.*?)\2/g)]
      .filter(([, , , address]) => address === namespace)
      .map(([, prefix]) => prefix);
  const elements = bound("http://www.w3.org/2000/svg").map((prefix) => new RegExp(`(</?)${prefix}:`, "g"));
  const links = bound("http://www.w3.org/1999/xlink").map((prefix) => new RegExp(`(\\s)${prefix}:(?=href\\s*=)`, "g"));
  return [...elements, ...links].reduce((plain, prefix) => plain.replace(prefix, "$1"), text);
}

/** What begins with "<" and is no element, and tags: their name, whether they end one, and whether they are both. */
const MARKUP =
  /<!--[\s\S]*?-->|<!\[CDATA\[[\s\S]*?\]\]>|<\?[\s\S]*?\?>|<!DOCTYPE(?:[^[>]|\[[^\]]*\])*>|<(\/?)([^\s<>/!?="'-][^\s<>/!?="']*)((?:[^<>"']|"[^"<]*"|'[^'<]*')*?)(\/?)>|</gi;

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
