/** What of a drawing's style decides which areas it paints. */

import type { FillRule } from "./region";

export type Declarations = Readonly<Record<string, string>>;

export type Style = {
  readonly fill: string;
  readonly stroke: string;
  /** Painted as an area. */
  readonly filled: boolean;
  /** Neither filled nor outlined, or not visible. */
  readonly invisible: boolean;
  readonly visibility: string;
  /** Not displayed, and its children neither. */
  readonly hidden: boolean;
  readonly rule: FillRule;
};

export const START: Style = {
  fill: "black",
  stroke: "none",
  filled: true,
  invisible: false,
  visibility: "visible",
  hidden: false,
  rule: "nonzero",
};

export type Rule = { readonly selector: string; readonly declarations: Declarations };

const PROPERTIES = ["fill", "stroke", "fill-rule", "display", "visibility"];

/** What style elements and style attributes are called in the drawing that is read. */
export const INERT_STYLE = "inert-style";

/** Rules asked of each element, at most, and letters of a selector: the browser compares each with each. */
const MOST_RULES = 400;
const LONGEST_SELECTOR = 300;

/** What decides where a figure is painted and where it lies. */
const DECISIVE =
  /(?:^|[\s;{])(?:fill|stroke|fill-rule|display|visibility|transform|d|x|y|r|rx|ry|cx|cy|width|height)\s*:/i;

/** At-rules whose blocks are for a screen as well. */
const SHOWN = /^@(?:media(?!\s+print\b)|supports|layer|container|scope)\b/i;

type Sheet = {
  readonly rules: readonly Rule[];
  /** Some have not been taken that may change what is painted, or where. */
  readonly leftOut: boolean;
};

/** The rules of the drawing's style elements. Null where they are more than this page takes. */
export function styleRules(drawing: Document): Sheet | null {
  const rules: Rule[] = [];
  let leftOut = false;
  for (const element of drawing.querySelectorAll(INERT_STYLE)) {
    for (const { selector, body, whole } of everyBlock(element.textContent ?? "")) {
      const isTaken = !selector.startsWith("@") && isSelector(drawing, selector);
      if (isTaken) rules.push({ selector, declarations: listed(body) });
      else if (!selector.startsWith("@") || SHOWN.test(selector)) leftOut ||= DECISIVE.test(whole);
    }
  }
  return rules.length <= MOST_RULES ? { rules, leftOut } : null;
}

type Block = {
  readonly selector: string;
  /** Its own declarations. */
  readonly body: string;
  /** With what is nested. */
  readonly whole: string;
};

/** The blocks of a style sheet that have a selector. */
export function blocks(text: string): Block[] {
  return everyBlock(text).filter(({ selector }) => !selector.startsWith("@"));
}

/**
 * The blocks of a style sheet with their selectors, those at the outermost level only: what is nested, or within an
 * at-rule, is for other media and states. One pass over the text, however deep it is nested.
 */
function everyBlock(text: string): Block[] {
  const found: Block[] = [];
  const plain = withoutComments(text);
  let depth = 0;
  // Where the selector began, its block, what of the block has not been taken yet, and its last whole declaration.
  let [begin, open, told, whole] = [0, 0, 0, 0];
  let body = "";
  for (let i = 0; i < plain.length; i += 1) {
    const letter = plain[i];
    if (letter === '"' || letter === "'") {
      const end = plain.indexOf(letter, i + 1);
      if (end < 0) break;
      i = end;
    } else if (letter === "{") {
      if (depth === 0) {
        open = i;
        told = i + 1;
        whole = told;
        body = "";
      } else if (depth === 1) body += plain.slice(told, Math.max(told, whole));
      depth += 1;
    } else if (letter === "}" && depth > 0) {
      depth -= 1;
      if (depth === 1) told = i + 1;
      if (depth === 0) {
        found.push({
          selector: plain.slice(begin, open).trim(),
          body: body + plain.slice(told, i),
          whole: plain.slice(open + 1, i),
        });
        begin = i + 1;
      }
    } else if (letter === ";" && depth === 0) begin = i + 1;
    else if (letter === ";" && depth === 1) whole = i + 1;
  }
  // What is left open at the end is closed by it.
  if (depth > 0)
    found.push({
      selector: plain.slice(begin, open).trim(),
      body: body + (depth === 1 ? plain.slice(told) : ""),
      whole: plain.slice(open + 1),
    });
  return found.filter(({ selector }) => selector !== "");
}

/** Selectors that ask about other elements' insides could take for ever; nobody draws with them. */
function isSelector(drawing: Document, selector: string): boolean {
  if (selector.length > LONGEST_SELECTOR || /:(has|nth-)/i.test(selector)) return false;
  try {
    drawing.documentElement.matches(selector);
    return true;
  } catch {
    return false;
  }
}

/** Presentation attributes, then style rules in their order, then the element's own style: later ones win. */
export function declarationsFrom(element: Element, rules: readonly Rule[]): Declarations {
  const out: Record<string, string> = {};
  for (const name of PROPERTIES) {
    const value = element.getAttribute(name);
    if (value !== null) out[name] = value.trim();
  }
  for (const { selector, declarations } of rules) {
    if (element.matches(selector)) Object.assign(out, declarations);
  }
  return Object.assign(out, listed(element.getAttribute(INERT_STYLE) ?? ""));
}

export function declared(declarations: Declarations, name: string): string | null {
  return declarations[name] ?? null;
}

export function inherited(parent: Style, declarations: Declarations): Style {
  const own = (name: string, value: string) => {
    const said = declarations[name];
    return said === undefined || said === "inherit" ? value : said;
  };
  const fill = own("fill", parent.fill);
  const stroke = own("stroke", parent.stroke);
  const visibility = own("visibility", parent.visibility);
  const painted = (paint: string) => paint !== "none" && paint !== "transparent";
  return {
    fill,
    stroke,
    visibility,
    filled: painted(fill),
    invisible: visibility === "hidden" || visibility === "collapse" || !(painted(fill) || painted(stroke)),
    hidden: declarations.display === "none",
    rule: own("fill-rule", parent.rule) === "evenodd" ? "evenodd" : "nonzero",
  };
}

function listed(text: string): Declarations {
  const out: Record<string, string> = {};
  for (const part of withoutComments(text).split(";")) {
    const colon = part.indexOf(":");
    if (colon < 0) continue;
    const value = part.slice(colon + 1).split("!")[0];
    out[part.slice(0, colon).trim().toLowerCase()] = value.trim();
  }
  return out;
}

function withoutComments(text: string): string {
  let out = "";
  let from = 0;
  for (let begin = text.indexOf("/*"); begin >= 0; begin = text.indexOf("/*", from)) {
    out += text.slice(from, begin);
    const end = text.indexOf("*/", begin + 2);
    if (end < 0) return out;
    from = end + 2;
  }
  return out + text.slice(from);
}
