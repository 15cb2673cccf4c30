import { useComputed, useSignalEffect } from "@preact/signals";
import { useCallback } from "preact/hooks";
import type { Session } from "../session";
import { bandwidth } from "../settings";
import { matchOf, type ResultScene } from "../view/result";
import { missedBy } from "../view/unreached";
import { en } from "../words/en";
import { resultState, staleness } from "../words/said";
import { MatchCanvas } from "./MatchCanvas";
import { fetchLocal, guess, lazy, limitOf, local, past, probe, view } from "./viewing";

/** The match in the chosen view, with its legend and the numbers at the place pointed at. */
export function ResultPanel({ session }: { session: Session }) {
  const match = useComputed(() => past.value?.match ?? (session.match.value && matchOf(session.match.value)));
  // Of the match that is shown, whatever has been chosen since.
  const width = useComputed(() => bandwidth((session.result.value ?? { settings: session.settings.value }).settings));
  const scene = useComputed<ResultScene>(() => ({
    ...session.shapes.value,
    match: match.value,
    morph: session.morph.value,
    bandwidth: width.value,
    missed: past.value ? [] : missedBy(session.result.value?.frame ?? null),
  }));
  const limit = useComputed(() => limitOf(match.value, width.value));
  const label = useComputed(() => en.result.name(state(session)));
  const drawn = useCallback(() => session.drawn(), [session]);
  useSignalEffect(() => {
    if (!probe.value || local.peek()) return;
    fetchLocal().catch((problem: Error) => {
      session.problem.value = problem.message;
    });
  });
  const Legend = lazy.value?.legends.Legend;
  const outdated = session.outdated.value;
  const showsPicture = view.value === "image" || view.value === "pullback";
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: dropping is one way more; the legend has a button for it
    <div
      class={outdated ? "shown stale" : "shown"}
      onDragOver={(event) => showsPicture && event.preventDefault()}
      onDrop={(event) => {
        const [file] = event.dataTransfer?.files ?? [];
        if (!showsPicture || !file) return;
        // The rest of the page takes files for shapes.
        event.preventDefault();
        event.stopPropagation();
        void lazy.value?.legends.takePicture(session, file);
      }}
    >
      <p class="asked" aria-live="polite">
        {guess.value?.of === session.match.value?.deformation && guess.value?.says}
      </p>
      {past.value && <p class="outdated past">{past.value.words}</p>}
      {outdated && !past.value && <p class="outdated">{en.result.outdated[outdated]}</p>}
      <MatchCanvas label={label} scene={scene} limit={limit} drawn={drawn} />
      {Legend && <Legend session={session} match={match} limit={limit} bandwidth={width.value} />}
      {local.value && <local.value.Readout match={match} />}
    </div>
  );
}

function state(session: Session): string {
  const status = session.match.value?.status ?? null;
  return resultState({ phase: session.phase.value, status, ...staleness(session) });
}
