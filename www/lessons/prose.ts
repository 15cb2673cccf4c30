/**
 * A lesson's Markdown as HTML, while the page is built: formulas between $ … $ or $$ … $$ become MathML, as the page has
 * its own, so that neither style sheets nor fonts are needed for them.
 */

import katex from "katex";
import MarkdownIt from "markdown-it";
import { raised } from "../words/numbers";

const markdown = new MarkdownIt({ html: false, typographer: false });

/** A mistake, at a line of the text that was given, from 0. */
export class Mistake extends Error {
  readonly line: number;

  constructor(line: number, message: string) {
    super(message);
    this.line = line;
  }
}

const FORMULA = /\$\$([^$]+)\$\$|(?<!\\)\$([^$\n]+)\$/g;
/** Of no text: letters of the private area around a formula's number. */
const OPEN = "\uE000";
const CLOSE = "\uE001";

/** Throws a Mistake. `isKnown` tells whether a page of this site is there. */
export function htmlOf(text: string, isKnown: (address: string) => boolean): string {
  const formulas: string[] = [];
  const marked = text.replace(FORMULA, (whole, display: string | undefined, inline: string | undefined, at: number) => {
    formulas.push(mathOf((display ?? inline ?? "").trim(), display !== undefined, lineOf(text, at)));
    // As many lines as before, so that those of other mistakes are right.
    return `${OPEN}${formulas.length - 1}${CLOSE}${"\n".repeat(whole.split("\n").length - 1)}`;
  });
  const alone = /(?<!\\)\$/.exec(marked);
  if (alone) throw new Mistake(lineOf(marked, alone.index), "a $ is without its partner; a dollar is written \\$");
  for (const token of markdown.parse(marked, {})) {
    const line = token.map?.[0] ?? 0;
    if (token.type === "hr") throw new Mistake(line, "a line of --- begins a step, and nothing else");
    for (const child of token.children ?? []) {
      if (child.type === "image") throw new Mistake(line, "lessons have no pictures: the frame beside them shows one");
      const address = child.type === "link_open" ? (child.attrGet("href") ?? "") : "https:";
      if (!/^https:/.test(address) && !isKnown(address))
        throw new Mistake(line, `the link leads to “${address}”, which is not there`);
    }
  }
  const html = markdown.render(marked).trim();
  return html.replace(new RegExp(`${OPEN}(\\d+)${CLOSE}`, "g"), (_, index) => formulas[Number(index)]);
}

/** A heading's words, formulas and all, without a paragraph around them. */
export function inlineOf(text: string): string {
  return htmlOf(text, () => false).replace(/^<p>|<\/p>$/g, "");
}

/** A digit, a whole number in braces, or a transpose. */
const POWER = /\^(?:(?<power>\d)|\{(?<whole>-?\d+)\}|\{\\mathsf T\})/g;

/** Powers as letters: in a browser without a mathematical font superscripts float above the line. */
function withLetters(tex: string): string {
  return tex.replace(POWER, (_, power?: string, whole?: string) => {
    const number = power ?? whole;
    return `\\text{${number ? raised(Number(number)) : "ᵀ"}}`;
  });
}

function mathOf(tex: string, displayMode: boolean, line: number): string {
  try {
    const rendered = katex.renderToString(withLetters(tex), {
      output: "mathml",
      displayMode,
      throwOnError: true,
      strict: "ignore",
    });
    // What it was written as is of no use to whoever reads it.
    return (
      rendered
        .replace(/^<span class="katex">|<\/span>$/g, "")
        .replace(/<annotation[^>]*>[\s\S]*?<\/annotation>/, "")
        .replace(/<\/?semantics>/g, "")
        .replace(' xmlns="http://www.w3.org/1998/Math/MathML"', "")
        // A formula of its own may be wider than a narrow screen, and is then scrolled, by keyboard too.
        .replace('<math display="block"', '$& tabindex="0"')
    );
  } catch (error) {
    const why = error instanceof Error ? error.message.replace(/^KaTeX parse error: /, "") : String(error);
    throw new Mistake(line, `the formula ${tex} cannot be read: ${why}`);
  }
}

function lineOf(text: string, at: number): number {
  return text.slice(0, at).split("\n").length - 1;
}
