/** A guess under way: the question, where the hand or the keys have taken the guess, and what came out. */

import type { Session } from "../session";
import { type Frame, pixelX, pixelY } from "../view/canvas";
import { distance, type Place, type Question, questionOf } from "../view/guess";
import { theme } from "../view/palette";
import { drawMark } from "../view/probe";
import { matchOf } from "../view/result";
import { later } from "../words/later";
import { decimals } from "../words/numbers";
import { partAt, WAY_MILLIS } from "./playing";
import { guess } from "./viewing";

/** Of the arrow keys, domain units. */
const STEP = 0.02;

/** How many questions have been asked: the next is another one. */
let asked = 0;

/** Asks; the function given back ends it and shows the match. */
export function ask(session: Session): () => void {
  const frame = session.match.peek();
  const match = frame && matchOf(frame);
  const question = match && questionOf(match, asked);
  if (!match || !question) return () => {};
  asked += 1;
  session.morph.value = 0;
  let at: Place = question.point;
  const show = (placed: boolean) => {
    guess.value = {
      of: match.deformation,
      says: placed ? answer(distance(at, question.partner), match.level) : later.guess.ask,
      moved: (place) => {
        if (placed) return;
        at = place;
        show(false);
      },
      place: () => {
        if (placed) return;
        show(true);
        reveal(session);
      },
      key: (key) => {
        const step = STEPS[key];
        if (placed || !step) return false;
        at = { x: at.x + STEP * step[0], y: at.y + STEP * step[1] };
        show(false);
        return true;
      },
      draw: (context, frame) => drawGuess(context, frame, question, at, placed),
    };
  };
  show(false);
  return () => {
    if (guess.peek()?.of !== match.deformation) return;
    guess.value = null;
    session.morph.value = 1;
  };
}

const STEPS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowRight: [1, 0],
  ArrowLeft: [-1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

function answer(off: number, level: number): string {
  return later.guess.off(decimals(off), decimals(off * 2 ** level));
}

/** The morph to its end, or at once where motion is unwelcome. */
function reveal(session: Session): void {
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
    session.morph.value = 1;
    return;
  }
  const begin = performance.now();
  const tick = (now: number) => {
    if (!guess.peek()) return;
    const part = partAt("once", now - begin);
    session.morph.value = part ?? 1;
    if (now - begin < WAY_MILLIS) requestAnimationFrame(tick);
  };
  requestAnimationFrame(tick);
}

function drawGuess(
  context: CanvasRenderingContext2D,
  frame: Frame,
  { point, partner }: Question,
  at: Place,
  placed: boolean,
): void {
  const colours = theme();
  drawMark(context, frame, colours, point, colours.reference);
  context.strokeStyle = colours.ink;
  context.lineWidth = 2 * frame.ratio;
  if (placed) {
    context.beginPath();
    context.moveTo(pixelX(frame, at.x), pixelY(frame, at.y));
    context.lineTo(pixelX(frame, partner.x), pixelY(frame, partner.y));
    context.stroke();
    drawMark(context, frame, colours, partner, colours.template);
  }
  // A cross: nothing of the match has this form.
  const [x, y, arm] = [pixelX(frame, at.x), pixelY(frame, at.y), 9 * frame.ratio];
  context.beginPath();
  for (const [u, v] of [
    [arm, arm],
    [arm, -arm],
  ]) {
    context.moveTo(x - u, y - v);
    context.lineTo(x + u, y + v);
  }
  context.stroke();
}
