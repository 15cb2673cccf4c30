/** Shows the forces of every finished match, as long as they are wanted. */

import { effect } from "@preact/signals";
import { arrows } from "../controls/viewing";
import { isDone } from "../phase";
import { type Result, sentence } from "../run";
import type { Session } from "../session";
import { ask, colours, draw } from "./forces";

/** The function given back ends it. */
export function showForces(session: Session): () => void {
  const stop = effect(() => {
    const result = isDone(session.phase.value) ? session.result.value : null;
    if (!result || arrows.peek()?.of !== result.frame.deformation) arrows.value = null;
    if (result) void show(session, result);
  });
  return () => {
    stop();
    arrows.value = null;
  };
}

async function show(session: Session, result: Result): Promise<void> {
  const { deformation } = result.frame;
  try {
    const forces = await ask(session.engine, result);
    // Another match may have come meanwhile, and with it another answer.
    if (session.result.peek()?.frame.deformation !== deformation) return;
    arrows.value = {
      of: deformation,
      draw: (context, frame, match, morph) => draw(context, frame, colours(), forces, match, morph),
    };
  } catch (error) {
    session.problem.value = sentence(error instanceof Error ? error.message : String(error));
  }
}
