/** The forces of the match that is shown: asked for of a worker of their own, and drawn as arrows over the picture. */

import type { Engine } from "../engine";
import type { Result } from "../run";
import { complete } from "../settings";
import { type Frame, pixelX, pixelY } from "../view/canvas";
import { thinned } from "../view/field";
import { identity } from "../view/identity";
import { movedAt, wayOf } from "../view/morph";
import type { Match } from "../view/result";
import { later } from "../words/later";
import ForcesWorker from "./forces.worker?worker&inline";
import { FORCES, type Forces, type Term } from "./terms";

type Reply = { readonly forces?: Forces; readonly problem?: string };

/** Rejects with a sentence. */
export async function ask(engine: Engine, { frame, reference, template, settings }: Result): Promise<Forces> {
  const module = await engine.module();
  const worker = new ForcesWorker();
  try {
    const { forces, problem } = await new Promise<Reply>((resolve) => {
      worker.onmessage = ({ data }: MessageEvent<Reply>) => resolve(data);
      worker.onerror = ({ message }) => resolve({ problem: message });
      worker.postMessage({
        module,
        reference: { kind: "curves", loops: [...reference] },
        template: { kind: "curves", loops: [...template] },
        // A φ that is there needs no graphics card.
        settings: { ...complete(settings), backend: "cpu" },
        level: frame.status.level,
        deformation: frame.deformation,
      });
    });
    if (!forces) throw new Error(problem || later.forces.failed);
    return forces;
  } finally {
    worker.terminate();
  }
}

/** Length of the longest arrow, domain units. */
const LONGEST = 0.07;
/** Shorter ones are left out, as a part of the longest. */
const LEAST = 0.04;

export type Colours = Readonly<Record<Term, string>>;

/** The terms' colours as the page has them. */
export function colours(): Colours {
  const style = getComputedStyle(document.documentElement);
  const names = { membrane: "reference", bending: "bending", mismatch: "template", volume: "volume" };
  return Object.fromEntries(FORCES.map((term) => [term, style.getPropertyValue(`--${names[term]}`).trim()])) as Colours;
}

/**
 * Arrows at the grid's nodes. All terms have one scale; the square root of a force is its length, or the weak ones could
 * not be seen beside the strong.
 */
export function draw(
  context: CanvasRenderingContext2D,
  frame: Frame,
  palette: Colours,
  forces: Forces,
  match: Match,
  morph: number,
): void {
  const cells = Math.sqrt(forces.membrane.length / 2) - 1;
  const { deformation } = thinned({ cells: 2 ** match.level, deformation: match.deformation }, cells);
  const at = movedAt(wayOf(match), identity(cells), deformation, morph);
  let most = 0;
  for (const term of FORCES)
    for (let k = 0; k < at.length; k += 2) most = Math.max(most, Math.hypot(forces[term][k], forces[term][k + 1]));
  if (!(most > 0)) return;
  context.lineWidth = 1.4 * frame.ratio;
  context.lineCap = "round";
  for (const term of FORCES) {
    context.strokeStyle = palette[term];
    context.beginPath();
    for (let k = 0; k < at.length; k += 2) {
      const [u, v] = [forces[term][k], forces[term][k + 1]];
      const force = Math.hypot(u, v);
      const length = Math.sqrt(force / most);
      if (length < LEAST) continue;
      const [dx, dy] = [(u / force) * length * LONGEST, (v / force) * length * LONGEST];
      arrow(context, frame, at[k], at[k + 1], dx, dy);
    }
    context.stroke();
  }
}

function arrow(context: CanvasPath, frame: Frame, x: number, y: number, dx: number, dy: number): void {
  const [fromX, fromY] = [pixelX(frame, x), pixelY(frame, y)];
  const [toX, toY] = [pixelX(frame, x + dx), pixelY(frame, y + dy)];
  context.moveTo(fromX, fromY);
  context.lineTo(toX, toY);
  for (const turn of [2.6, -2.6]) {
    const [cos, sin] = [Math.cos(turn), Math.sin(turn)];
    const head = 0.3;
    const [u, v] = [toX - fromX, toY - fromY];
    context.moveTo(toX, toY);
    context.lineTo(toX + head * (cos * u - sin * v), toY + head * (sin * u + cos * v));
  }
}
