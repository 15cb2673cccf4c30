/** The areas that a drawing paints, as shapes to choose from. */

import type { Loop, Shape } from "../geometry";
import { type Choice, type FoundShapes, ImportError } from "./found";
import { type Commands, controlBounds, flattened, parsePath } from "./path";
import { isTangled, united } from "./region";
import { type Drawing, drawingFrom, type Figure as Painted } from "./svgDrawing";

type Figure = Painted & { readonly commands: Commands };

/** Curves are flattened to this part of the drawing's longer side: a thousandth of a cell. */
const TOLERANCE = 1e-5;

/** Names of figures are offered one by one up to this many. */
const MOST_CHOICES = 60;

/** Commands of all paths together: more than any outline has, and some seconds of work. */
const MOST_COMMANDS = 300_000;

/** Part of the work that parsing is, for whoever watches. */
const PARSING = 0.4;

/** A drawing that is known to be small, at once. */
export function readSvg(text: string): FoundShapes {
  return shapesOf(drawingFrom(text));
}

/** `report` is told the part that is done, so far as it is known. */
export function shapesOf(drawing: Drawing, report: (done: number) => void = () => {}): FoundShapes {
  let count = 0;
  const figures = drawing.figures.map((figure, i): Figure => {
    const commands = parsePath(figure.data);
    count += commands.length;
    if (count > MOST_COMMANDS) {
      throw new ImportError(
        `The drawing has more than ${MOST_COMMANDS} path commands; simplify its paths first, or import a picture of it.`,
      );
    }
    if (i % 64 === 0) report((PARSING * i) / drawing.figures.length);
    return { ...figure, commands };
  });
  const rest = (done: number) => report(PARSING + (1 - PARSING) * done);
  return drawing.own ? ownChoices(figures) : choices(figures, new Set(drawing.notes), rest);
}

/** The areas of the figures: everything together first, then each by itself. */
function choices(all: readonly Figure[], notes: Set<string>, report: (done: number) => void): FoundShapes {
  const figures = withoutBackground(all, notes);
  const areas = areasOf(figures);
  const bodies = figures.map((figure, i) => ({ figure, loops: areas[i] })).filter(({ loops }) => loops.length > 0);
  if (bodies.length === 0) {
    throw new ImportError(
      all.length === 0
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
  const regions = bodies.map(({ figure, loops }) => ({ loops, rule: figure.rule }));
  if (isTangled(regions)) notes.add("The paths cross so often that they are read as a picture of 1024 points a side.");
  const everything = choice("Everything together", united(regions, report));
  if (everything.loops.length === 0) throw new ImportError("The paths of the drawing enclose no area.");
  const single =
    bodies.length > 1 && bodies.length <= MOST_CHOICES
      ? bodies
          .map(({ figure, loops }) => choice(figure.name, united([{ loops, rule: figure.rule }])))
          .filter(({ loops }) => loops.length > 0)
      : [];
  const some = single.length > 1 ? [everything, ...single] : [everything];
  return { kind: "shapes", choices: some, notes: [...notes], firstIsAll: true };
}

const SIDES: Record<string, string> = { reference: "Reference", template: "Target", matched: "Matched reference" };

/** A drawing of this page: its shapes lie in the box already and go back to where they were. */
function ownChoices(figures: readonly Figure[]): FoundShapes {
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
  return { kind: "shapes", choices: some, notes: [], firstIsAll: true };
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
