/**
 * SVG as plain data: what is painted, where, and how. The drawing is parsed apart from the page and only read: no script
 * of it runs, nothing it refers to is loaded. What it may hold is bounded, so that no drawing keeps the page from
 * answering; whatever takes its time with the paths does so elsewhere.
 */

import { ImportError } from "./found";
import type { FillRule } from "./region";
import { basicShape, type Length } from "./svgShapes";
import {
  type Declarations,
  declarationsFrom,
  declared,
  INERT_STYLE,
  inherited,
  type Rule,
  START,
  type Style,
  styleRules,
} from "./svgStyle";
import { compose, IDENTITY, type Matrix, parseTransform, pixels } from "./transform";

/** What is painted: path data where it stands, and how it is filled. */
export type Figure = {
  readonly name: string;
  readonly data: string;
  readonly matrix: Matrix;
  readonly filled: boolean;
  readonly rule: FillRule;
  readonly rectangle: boolean;
  /** The side of a match, in drawings that this page has written. */
  readonly side: string | null;
};

export type Drawing = {
  readonly figures: readonly Figure[];
  readonly notes: readonly string[];
  /** Written by this page: its shapes lie in the box already. */
  readonly own: boolean;
};

/** `use` inside `use` further than this is a circle. */
const DEEPEST = 40;

/** Letters of a file and of all path data, tags of a file, attributes of a tag, and elements with every use counted. */
const MOST_LETTERS = 20e6;
const MOST_TAGS = 200_000;
const MOST_ATTRIBUTES = 10_000;
const LONGEST_HEAD = 20_000;
const MOST_ELEMENTS = 50_000;

/** Elements between two looks at what else the page has to do. */
const AT_ONCE = 500;

/** Containers whose children are not painted where they stand. */
const UNPAINTED = new Set(["defs", "symbol", "clippath", "mask", "marker", "pattern", "metadata", "title", "desc"]);

/** The drawing at once: for drawings that are known to be small. */
export function drawingFrom(text: string): Drawing {
  const reading = read(text);
  for (;;) {
    const { done, value } = reading.next();
    if (done) return value;
  }
}

/** The same, while the page goes on answering. Ends with the signal's reason when it is aborted. */
export async function drawingMeanwhile(text: string, signal: AbortSignal): Promise<Drawing> {
  const reading = read(text);
  for (let count = 1; ; count += 1) {
    const { done, value } = reading.next();
    if (done) return value;
    if (count % AT_ONCE !== 0) continue;
    await new Promise((resolve) => setTimeout(resolve));
    signal.throwIfAborted();
  }
}

/** Reads one element after the other, and yields after each. */
function* read(text: string): Generator<void, Drawing> {
  checkSize(text);
  const drawing = new DOMParser().parseFromString(inert(text), "image/svg+xml");
  const broken = drawing.querySelector("parsererror");
  if (broken) {
    const why = /line \d+[^:]*:\s*([^\n]*)/.exec(broken.textContent ?? "")?.[0].trim() ?? "it is not well-formed";
    throw new ImportError(`The SVG is broken (${why}); save or copy it again, whole.`);
  }
  const root = drawing.documentElement;
  if (root.localName !== "svg") throw new ImportError("This is XML, but not a drawing: its root is not <svg>.");
  const reader = new Reader(drawing);
  // Drawings that this page has written say how many units the box's side has.
  const unit = Number(root.getAttribute("data-units-per-side"));
  const own = Number.isFinite(unit) && unit > 0;
  const upright: Matrix = own ? [1 / unit, 0, 0, -1 / unit, 0, 1] : [1, 0, 0, -1, 0, 0];
  yield* reader.children(root, upright, reader.style(root, START), 0);
  return { figures: reader.figures, notes: [...reader.notes], own };
}

/** The browser itself is to apply no style of the drawing and no script: the page's policy would complain aloud. */
function inert(text: string): string {
  return text
    .replace(/(<\/?(?:[\w.-]{1,40}:)?)style(?=[\s/>])/gi, `$1${INERT_STYLE}`)
    .replace(/(\s)style(?=\s*=)/gi, `$1${INERT_STYLE}`)
    .replace(/(\s)(on[a-z]{1,30})(?=\s*=)/gi, "$1inert-$2");
}

/** Before the browser parses it: that cannot be interrupted. */
function checkSize(text: string): void {
  if (text.length > MOST_LETTERS) {
    throw new ImportError(`The drawing has more than ${MOST_LETTERS / 1e6} MB of text; simplify its paths first.`);
  }
  if (text.includes("<!ENTITY")) {
    // Those of Illustrator stand for addresses. Entities that hold entities can stand for a text without end.
    const head = text.slice(0, Math.max(0, text.search(/<svg[\s>]/)));
    if (head.length > LONGEST_HEAD || head.split("<!ENTITY").some((part, i) => i > 0 && part.includes("&"))) {
      throw new ImportError("The drawing abbreviates its text by entities; save it as plain SVG.");
    }
  }
  let [tags, attributes] = [0, 0];
  for (let i = 0; i < text.length; i += 1) {
    const letter = text.charCodeAt(i);
    if (letter === 0x3c) {
      tags += 1;
      attributes = 0;
    } else if (letter === 0x3d) attributes += 1;
    if (attributes > MOST_ATTRIBUTES) {
      throw new ImportError(
        `A tag of the drawing has more than ${MOST_ATTRIBUTES} attributes, or a script or style sheet is as long; save it as plain SVG.`,
      );
    }
  }
  if (tags > MOST_TAGS) throw tooMany();
}

function tooMany(): ImportError {
  return new ImportError(
    `The drawing has more than ${MOST_ELEMENTS} elements, each use of one counted; simplify it, or import a picture of it.`,
  );
}

class Reader {
  readonly figures: Figure[] = [];
  readonly notes = new Set<string>();
  private readonly drawing: Document;
  private readonly rules: readonly Rule[];
  private visited = 0;
  private letters = 0;
  private readonly size: { readonly width: number; readonly height: number };

  constructor(drawing: Document) {
    this.drawing = drawing;
    const sheet = styleRules(drawing);
    if (!sheet) throw new ImportError("The drawing has a style sheet of too many rules; save it as plain SVG.");
    this.rules = sheet.rules;
    if (sheet.leftOut)
      this.notes.add(
        "Some rules of the drawing's style sheet are left out; save it as plain SVG if parts are missing or too many.",
      );
    const box = viewBox(drawing.documentElement);
    const own = (name: string) => pixels(drawing.documentElement.getAttribute(name) ?? "") ?? 100;
    this.size = { width: box?.width ?? own("width"), height: box?.height ?? own("height") };
  }

  style(element: Element, parent: Style): Style {
    return inherited(parent, this.declarations(element));
  }

  *children(element: Element, matrix: Matrix, style: Style, depth: number): Generator<void> {
    // From one to the next: a list of children would be counted anew for each.
    for (let child = element.firstElementChild; child; child = child.nextElementSibling) {
      yield* this.element(child, matrix, style, depth + 1);
    }
  }

  private declarations(element: Element): Declarations {
    return declarationsFrom(element, this.rules);
  }

  private *element(element: Element, outer: Matrix, parent: Style, depth: number): Generator<void> {
    const kind = element.localName.toLowerCase();
    this.visited += 1;
    if (this.visited > MOST_ELEMENTS) throw tooMany();
    yield;
    if (UNPAINTED.has(kind)) return;
    if (depth > DEEPEST)
      throw new ImportError("The drawing uses itself or is nested too deeply; save it as plain SVG.");
    const declarations = this.declarations(element);
    const style = inherited(parent, declarations);
    if (style.hidden) return;
    const matrix = compose(outer, ownTransform(element, declarations));
    switch (kind) {
      case "g":
      case "a":
        yield* this.children(element, matrix, style, depth);
        break;
      case "switch":
        if (element.firstElementChild) yield* this.element(element.firstElementChild, matrix, style, depth + 1);
        break;
      case "svg":
        yield* this.children(element, compose(matrix, this.viewport(element, null)), style, depth);
        break;
      case "use":
        yield* this.use(element, matrix, style, depth);
        break;
      case "text":
        this.notes.add("Text is left out: turn it into paths to have it.");
        break;
      case "image":
        this.notes.add("Pictures inside the drawing are left out: import them by themselves.");
        break;
      default:
        this.figure(element, kind, matrix, style, declarations);
    }
  }

  private figure(element: Element, kind: string, matrix: Matrix, style: Style, declarations: Declarations): void {
    const data = kind === "path" ? (element.getAttribute("d") ?? "") : basicShape(element, this.length(declarations));
    if (!data || style.invisible) return;
    this.letters += data.length;
    if (this.letters > MOST_LETTERS) {
      throw new ImportError(
        `The drawing has more than ${MOST_LETTERS / 1e6} MB of path data, each use counted; simplify its paths first.`,
      );
    }
    this.figures.push({
      name: element.getAttribute("id") ?? element.getAttribute("aria-label") ?? `${kind} ${this.figures.length + 1}`,
      data,
      matrix,
      filled: style.filled,
      rule: style.rule,
      rectangle: kind === "rect",
      side: element.getAttribute("data-side"),
    });
  }

  private *use(element: Element, matrix: Matrix, style: Style, depth: number): Generator<void> {
    const address =
      element.getAttribute("href") ?? element.getAttributeNS("http://www.w3.org/1999/xlink", "href") ?? "";
    const target = address.startsWith("#") ? this.drawing.getElementById(address.slice(1)) : null;
    if (!target) {
      this.notes.add("Parts kept in other files are left out.");
      return;
    }
    const length = this.length(this.declarations(element));
    const moved = compose(matrix, [1, 0, 0, 1, length(element, "x", "width"), length(element, "y", "height")]);
    if (target.localName !== "symbol") yield* this.element(target, moved, style, depth + 1);
    else {
      const placed = compose(moved, this.viewport(target, element));
      yield* this.children(target, placed, inherited(style, this.declarations(target)), depth + 1);
    }
  }

  /** What the inner coordinates of an `svg` or `symbol` are in outer ones: its place, and its view box fitted inside. */
  private viewport(element: Element, user: Element | null): Matrix {
    const length = this.length({});
    const sized = user?.hasAttribute("width") ? user : element;
    const x = user ? 0 : length(element, "x", "width");
    const y = user ? 0 : length(element, "y", "height");
    const width = sized.hasAttribute("width") ? length(sized, "width", "width") : this.size.width;
    const height = sized.hasAttribute("height") ? length(sized, "height", "height") : this.size.height;
    const box = viewBox(element);
    if (!box) return [1, 0, 0, 1, x, y];
    const [across, up] = [width / box.width, height / box.height];
    const fit = element.getAttribute("preserveAspectRatio") ?? "xMidYMid meet";
    if (/none/.test(fit)) return [across, 0, 0, up, x - across * box.x, y - up * box.y];
    const scale = /slice/.test(fit) ? Math.max(across, up) : Math.min(across, up);
    const share = (word: "x" | "Y") => (fit.includes(`${word}Min`) ? 0 : fit.includes(`${word}Max`) ? 1 : 0.5);
    return [
      scale,
      0,
      0,
      scale,
      x + share("x") * (width - scale * box.width) - scale * box.x,
      y + share("Y") * (height - scale * box.height) - scale * box.y,
    ];
  }

  private length(declarations: Declarations): Length {
    const { width, height } = this.size;
    const along = { width, height, diagonal: Math.hypot(width, height) / Math.SQRT2 };
    return (element, name, direction) => {
      const text = declared(declarations, name) ?? element.getAttribute(name) ?? "0";
      const share = /^\s*([\d.]+)%\s*$/.exec(text);
      return share ? (Number(share[1]) / 100) * along[direction] : (pixels(text) ?? 0);
    };
  }
}

function ownTransform(element: Element, declarations: Declarations): Matrix {
  const text = declared(declarations, "transform") ?? element.getAttribute("transform");
  if (!text) return IDENTITY;
  const matrix = parseTransform(text);
  const origin = declared(declarations, "transform-origin") ?? element.getAttribute("transform-origin");
  if (!origin) return matrix;
  const [x, y] = origin
    .slice(0, 200)
    .trim()
    .split(/[\s,]+/)
    .map(pixels);
  if (x === null || y === null || y === undefined) {
    throw new ImportError(`The transform-origin “${origin}” is not in pixels; save the drawing as plain SVG.`);
  }
  return compose([1, 0, 0, 1, x, y], compose(matrix, [1, 0, 0, 1, -x, -y]));
}

function viewBox(element: Element): { x: number; y: number; width: number; height: number } | null {
  const numbers = (element.getAttribute("viewBox") ?? "")
    .trim()
    .split(/[\s,]+/)
    .map(Number);
  const [x, y, width, height] = numbers;
  return numbers.length === 4 && numbers.every(Number.isFinite) && width > 0 && height > 0
    ? { x, y, width, height }
    : null;
}
