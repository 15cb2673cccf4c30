import { useComputed } from "@preact/signals";
import { useCallback } from "preact/hooks";
import { isDone, isFollowing, isPaused } from "../phase";
import type { Session } from "../session";
import { bandwidth } from "../settings";
import type { ResultScene } from "../view/result";
import { Legend, takePicture } from "./Legend";
import { MatchCanvas } from "./MatchCanvas";
import { decimals } from "./numbers";
import { Readout } from "./Readout";
import { limitOf, view } from "./viewing";

/** The match in the chosen view, with its legend and the numbers at the place pointed at. */
export function ResultPanel({ session }: { session: Session }) {
  const match = useComputed(() => matchOf(session));
  const scene = useComputed<ResultScene>(() => ({
    ...session.shapes.value,
    match: match.value,
    morph: session.morph.value,
    bandwidth: bandwidth(session.settings.value),
  }));
  const limit = useComputed(() => limitOf(match.value, bandwidth(session.settings.value)));
  const label = useComputed(() => `Deformed grid and matched curve: ${words(session)}`);
  const drawn = useCallback(() => session.drawn(), [session]);
  const showsPicture = view.value === "image" || view.value === "pullback";
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: dropping is one way more; the legend has a button for it
    <div
      class="shown"
      onDragOver={(event) => showsPicture && event.preventDefault()}
      onDrop={(event) => {
        const [file] = event.dataTransfer?.files ?? [];
        if (!showsPicture || !file) return;
        // The rest of the page takes files for shapes.
        event.preventDefault();
        event.stopPropagation();
        void takePicture(session, file);
      }}
    >
      <MatchCanvas label={label} scene={scene} limit={limit} drawn={drawn} />
      <Legend session={session} match={match} limit={limit} />
      <Readout match={match} />
    </div>
  );
}

function matchOf(session: Session) {
  const frame = session.match.value;
  return frame && { level: frame.status.level, deformation: frame.deformation, curves: frame.curves };
}

function words(session: Session): string {
  const phase = session.phase.value;
  const status = session.match.value?.status;
  if (!status) return phase === "preparing" ? "the solver is starting" : "not matched yet, the grid is undeformed";
  if (isDone(phase)) {
    const max = Math.max(status.mismatch.max, status.cover.max);
    return Number.isFinite(max)
      ? `matched, at most ${decimals(max)} cells off, no cell folded`
      : "matched, but the grid does not see the curve";
  }
  const side = 2 ** status.level + 1;
  const doing = isPaused(phase) ? "paused" : isFollowing(phase) ? "following your hand" : "matching";
  return `${doing} on the ${side} by ${side} grid`;
}
