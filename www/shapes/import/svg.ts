/**
 * SVG as shapes. The drawing is parsed apart from the page and only read: no script of it runs, nothing it refers to
 * is loaded.
 */

import type { Loop, Shape } from "../geometry";
import { type Choice, type Found, ImportError } from "./found";
import { type Commands, controlBounds, flattened, parsePath } from "./path";
import { type FillRule, united } from "./region";
import { basicShape, type Length } from "./svgShapes";
import { type Declarations, declarationsFrom, declared, inherited, START, type Style, styleRules } from "./svgStyle";
import { compose, IDENTITY, type Matrix, parseTransform, pixels } from "./transform";

/** What is painted: path data where it stands, and how it is filled. */
type Figure = {
  readonly name: string;
  readonly commands: Commands;
  readonly matrix: Matrix;
  readonly filled: boolean;
  readonly rule: FillRule;
  readonly rectangle: boolean;
  /** The side of a match, in drawings that this page has written. */
  readonly side: string | null;
};

/** Curves are flattened to this part of the drawing's longer side: a thousandth of a cell. */
const TOLERANCE = 1e-5;

/** `use` inside `use` further than this is a circle. */
const DEEPEST = 40;

/** Names of figures are offered one by one up to this many. */
const MOST_CHOICES = 60;

/** Containers whose children are not painted where they stand. */
const UNPAINTED = new Set(["defs", "symbol", "clippath", "mask", "marker", "pattern", "metadata", "title", "desc"]);

export function readSvg(text: string): Found {
  const drawing = new DOMParser().parseFromString(text, "image/svg+xml");
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
  reader.children(root, upright, reader.style(root, START), 0);
  return own ? ownChoices(reader.figures) : choices(reader);
}

class Reader {
  readonly figures: Figure[] = [];
  readonly notes = new Set<string>();
  private readonly drawing: Document;
  private readonly rules;
  private readonly size: { readonly width: number; readonly height: number };

  constructor(drawing: Document) {
    this.drawing = drawing;
    this.rules = styleRules(drawing);
    const box = viewBox(drawing.documentElement);
    const own = (name: string) => pixels(drawing.documentElement.getAttribute(name) ?? "") ?? 100;
    this.size = { width: box?.width ?? own("width"), height: box?.height ?? own("height") };
  }

  style(element: Element, parent: Style): Style {
    return inherited(parent, this.declarations(element));
  }

  children(element: Element, matrix: Matrix, style: Style, depth: number): void {
    for (const child of element.children) this.element(child, matrix, style, depth + 1);
  }

  private declarations(element: Element): Declarations {
    return declarationsFrom(element, this.rules);
  }

  private element(element: Element, outer: Matrix, parent: Style, depth: number): void {
    const kind = element.localName.toLowerCase();
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
        this.children(element, matrix, style, depth);
        break;
      case "switch":
        if (element.firstElementChild) this.element(element.firstElementChild, matrix, style, depth + 1);
        break;
      case "svg":
        this.children(element, compose(matrix, this.viewport(element, null)), style, depth);
        break;
      case "use":
        this.use(element, matrix, style, depth);
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
    this.figures.push({
      name: element.getAttribute("id") ?? element.getAttribute("aria-label") ?? `${kind} ${this.figures.length + 1}`,
      commands: parsePath(data),
      matrix,
      filled: style.filled,
      rule: style.rule,
      rectangle: kind === "rect",
      side: element.getAttribute("data-side"),
    });
  }

  private use(element: Element, matrix: Matrix, style: Style, depth: number): void {
    const address =
      element.getAttribute("href") ?? element.getAttributeNS("http://www.w3.org/1999/xlink", "href") ?? "";
    const target = address.startsWith("#") ? this.drawing.getElementById(address.slice(1)) : null;
    if (!target) {
      this.notes.add("Parts kept in other files are left out.");
      return;
    }
    const length = this.length(this.declarations(element));
    const moved = compose(matrix, [1, 0, 0, 1, length(element, "x", "width"), length(element, "y", "height")]);
    if (target.localName !== "symbol") this.element(target, moved, style, depth + 1);
    else {
      const placed = compose(moved, this.viewport(target, element));
      this.children(target, placed, inherited(style, this.declarations(target)), depth + 1);
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

/** The areas of the figures: everything together first, then each by itself. */
function choices(reader: Reader): Found {
  const { notes } = reader;
  const figures = withoutBackground(reader.figures, notes);
  const areas = areasOf(figures);
  const bodies = figures.map((figure, i) => ({ figure, loops: areas[i] })).filter(({ loops }) => loops.length > 0);
  if (bodies.length === 0) {
    throw new ImportError(
      reader.figures.length === 0
        ? "The drawing has no paths and no basic shapes; turn text and strokes into paths."
        : "The drawing has only open lines, which enclose nothing; close them, or turn strokes into paths.",
    );
  }
  if (bodies.length < figures.length) notes.add("Open lines are left out: they enclose nothing.");
  const choice = (name: string, loops: Shape): Choice => ({
    name,
    loops,
    placed: false,
    mainPart: false,
    smoothing: 0,
  });
  const all = choice("Everything together", united(bodies.map(({ figure, loops }) => ({ loops, rule: figure.rule }))));
  if (all.loops.length === 0) throw new ImportError("The paths of the drawing enclose no area.");
  const single =
    bodies.length > 1 && bodies.length <= MOST_CHOICES
      ? bodies
          .map(({ figure, loops }) => choice(figure.name, united([{ loops, rule: figure.rule }])))
          .filter(({ loops }) => loops.length > 0)
      : [];
  return { kind: "shapes", choices: single.length > 1 ? [all, ...single] : [all], notes: [...notes] };
}

const SIDES: Record<string, string> = { reference: "Reference", template: "Template", matched: "Matched reference" };

/** A drawing of this page: its shapes lie in the box already and go back to where they were. */
function ownChoices(figures: readonly Figure[]): Found {
  const order = Object.keys(SIDES);
  const rank = ({ side }: Figure) => order.indexOf(side ?? "");
  const named = figures.filter((figure) => rank(figure) >= 0).sort((a, b) => rank(a) - rank(b));
  const areas = areasOf(named);
  const found = named.map(
    (figure, i): Choice => ({
      name: SIDES[figure.side ?? ""],
      loops: united([{ loops: areas[i], rule: figure.rule }]),
      placed: true,
      mainPart: false,
      smoothing: 0,
    }),
  );
  const some = found.filter(({ loops }) => loops.length > 0);
  if (some.length === 0) throw new ImportError("This drawing of a match holds no shape; save it again.");
  return { kind: "shapes", choices: some, notes: [] };
}

/** What each figure encloses: all its subpaths when it is filled, the closed ones when it is only outlined. */
function areasOf(figures: readonly Figure[]): readonly Loop[][] {
  let [left, low, right, high] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const { commands, matrix } of figures) {
    const box = controlBounds(commands, matrix);
    if (!box) continue;
    left = Math.min(left, box[0]);
    low = Math.min(low, box[1]);
    right = Math.max(right, box[2]);
    high = Math.max(high, box[3]);
  }
  const extent = Math.max(right - left, high - low);
  if (!(extent > 0) || !Number.isFinite(extent)) return figures.map(() => []);
  return figures.map(({ commands, matrix, filled }) =>
    flattened(commands, matrix, TOLERANCE * extent)
      .filter(({ closed }) => filled || closed)
      .map(({ points }) => points),
  );
}

/** Without a rectangle behind everything, which is paper and no shape. */
function withoutBackground(figures: readonly Figure[], notes: Set<string>): readonly Figure[] {
  if (figures.length < 2 || !figures[0].rectangle) return figures;
  const [first, ...others] = figures;
  const paper = controlBounds(first.commands, first.matrix);
  const inside = others.every((figure) => {
    const box = controlBounds(figure.commands, figure.matrix);
    if (!box || !paper) return false;
    const slack = 0.001 * (paper[2] - paper[0]);
    return (
      box[0] >= paper[0] - slack &&
      box[1] >= paper[1] - slack &&
      box[2] <= paper[2] + slack &&
      box[3] <= paper[3] + slack
    );
  });
  if (!inside) return figures;
  notes.add("The rectangle behind everything is taken for paper and left out.");
  return others;
}
