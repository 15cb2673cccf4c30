import { isDone, isFollowing, isPaused, isWorking } from "../phase";
import { kit } from "../pins/kit";
import type { Session } from "../session";
import { coarsestLevel, finestLevel } from "../settings";
import { hands } from "../tools/tool";
import { en } from "../words/en";
import { cells, gridName, headline, staleness } from "../words/said";
import { Bar, Numbers } from "./Figures";
import { lazy, view } from "./viewing";

/** What goes on, in words and as machine-readable values. */
export function StatusPanel({ session }: { session: Session }) {
  const phase = session.phase.value;
  const status = session.fresh.value ? session.match.value?.status : undefined;
  const paused = isPaused(phase);
  const working = isWorking(phase) || isFollowing(phase);
  const Report = kit.value?.Report;
  return (
    // Thirty updates a second would drown a screen reader: it hears the beginning and the end.
    <div class="status" role="status" aria-live={working && !paused && status ? "off" : "polite"}>
      <p class="headline">{said(session)}</p>
      {status && (
        <Numbers
          status={status}
          stale={session.stale.value}
          working={working}
          labels={en.numbers}
          grid={gridName(status.level)}
          cells={cells}
        >
          {hands.value && <hands.value.Computed status={status} />}
        </Numbers>
      )}
      {isDone(phase) && !session.stale.value && status?.verdict && status.stop && (
        <p class="stop">{en.status.stop(status)}</p>
      )}
      {isDone(phase) && Report && <Report session={session} />}
      {!working && <Resolution session={session} />}
    </div>
  );
}

/** The one sentence under the picture. */
export function said(session: Session): string {
  const status = session.fresh.value ? session.match.value?.status : undefined;
  const [phase, loaded] = [session.phase.value, session.loaded.value];
  return headline({ phase, loaded, status: status ?? null, ...staleness(session) });
}

/** What the colours, lines and ticks of the chosen view mean. */
export function Caption({ session }: { session: Session }) {
  const status = session.result.value?.frame.status;
  const isMissed = status?.finished && status.cover.max > 1;
  // The grid's caption says it always; what is pulled back lies on the reference.
  const says = isMissed && view.value !== "grid" && view.value !== "pullback";
  return (
    <p id="view-caption" class="caption">
      {lazy.value?.captions[view.value] ?? en.gridCaption}
      {says && en.dashed}
    </p>
  );
}

/** What the finest grid does not resolve, and the way to one that does. */
function Resolution({ session }: { session: Session }) {
  const inspection = session.inspection.value;
  if (!inspection?.words) return null;
  const { level } = inspection;
  return (
    <p class="resolution">
      {en.status.unresolved(inspection)}
      {level !== null && (
        <button type="button" onClick={() => session.choices.matchOn(level)}>
          {en.actions.matchOn(gridName(level))}
        </button>
      )}
    </p>
  );
}

/** How far the cascade is, as a part of its levels. */
export function Progress({ session }: { session: Session }) {
  const phase = session.phase.value;
  if (!isWorking(phase)) return <div class="progress idle" />;
  const status = session.fresh.value ? session.match.value?.status : undefined;
  const coarsest = coarsestLevel(session.settings.value);
  const finest = finestLevel(session.settings.value);
  // Nobody knows how many iterations a level will take: each brings the bar closer to the next level's mark.
  const within = status ? status.iteration / (status.iteration + 20) : 0;
  const done = status ? (status.level - coarsest + within) / (finest - coarsest + 1) : 0;
  const percent = Math.round(100 * Math.min(1, Math.max(0, done)));
  // Nor how long the shapes will take.
  return <Bar label={en.result.title} percent={status ? percent : null} />;
}
