import { effect, useComputed } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import type { Session } from "../session";
import { bandwidth } from "../settings";
import { Surface } from "../view/canvas";
import { drawResult } from "../view/result";
import { decimals } from "./numbers";

/** φ leaves the box a little under the natural boundary condition; this much around it is shown. */
const MARGIN = 0.05;

/** The deformed grid and the matched curve. */
export function ResultPanel({ session }: { session: Session }) {
  const canvas = useRef<HTMLCanvasElement>(null);

  useEffect(() => {
    if (!canvas.current) return;
    const surface = new Surface(canvas.current, MARGIN, (context, frame, colours) => {
      drawResult(context, frame, colours, {
        ...session.shapes.value,
        match: matchOf(session),
        morph: session.morph.value,
        bandwidth: bandwidth(session.settings.value),
      });
      session.drawn(session.match.value);
    });
    const stop = effect(() => {
      session.shapes.value;
      session.match.value;
      session.morph.value;
      session.settings.value;
      surface.invalidate();
    });
    return () => {
      stop();
      surface.dispose();
    };
  }, [session]);

  const label = useComputed(() => `Deformed grid and matched curve: ${words(session)}`);
  return <canvas ref={canvas} role="img" aria-label={label} class="result" />;
}

function matchOf(session: Session) {
  const frame = session.match.value;
  return frame && { level: frame.status.level, deformation: frame.deformation, curves: frame.curves };
}

function words(session: Session): string {
  const { phase, match } = session;
  const status = match.value?.status;
  if (!status) return phase.value === "solving" ? "the solver is starting" : "not matched yet, the grid is undeformed";
  if (phase.value === "finished") {
    return `matched, at most ${decimals(status.mismatch.max)} cells off, no cell folded`;
  }
  const side = 2 ** status.level + 1;
  const doing = { paused: "paused", following: "following your hand" }[phase.value as string] ?? "matching";
  return `${doing} on the ${side} by ${side} grid`;
}
