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

type Rule = { readonly selector: string; readonly declarations: Declarations };

const PROPERTIES = ["fill", "stroke", "fill-rule", "display", "visibility"];

/** The rules of the drawing's style elements. A constructed sheet loads nothing, not even what it imports. */
export function styleRules(drawing: Document): readonly Rule[] {
  const rules: Rule[] = [];
  for (const element of drawing.querySelectorAll("style")) {
    const sheet = new CSSStyleSheet();
    // It would leave out imports by itself, but complain about them on the console.
    sheet.replaceSync((element.textContent ?? "").replace(/@import[^;]*;/gi, ""));
    for (const rule of sheet.cssRules) {
      if (rule instanceof CSSStyleRule) {
        rules.push({ selector: rule.selectorText, declarations: listed(rule.style.cssText) });
      }
    }
  }
  return rules;
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
  return Object.assign(out, listed(element.getAttribute("style") ?? ""));
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
  for (const part of text.replace(/\/\*.*?\*\//gs, "").split(";")) {
    const colon = part.indexOf(":");
    if (colon < 0) continue;
    const value = part.slice(colon + 1).replace(/!important\s*$/i, "");
    out[part.slice(0, colon).trim().toLowerCase()] = value.trim();
  }
  return out;
}
