import { isDone, isFollowing, isPaused, isWorking } from "../phase";
import { kit } from "../pins/kit";
import type { Session } from "../session";
import { coarsestLevel, finestLevel } from "../settings";
import { en } from "../words/en";
import { decimals } from "../words/numbers";
import { cells, gridName, headline, staleness } from "../words/said";
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
      <p class="headline">
        {headline({ phase, loaded: session.loaded.value, status: status ?? null, ...staleness(session) })}
      </p>
      {status && (
        <dl class={session.stale.value ? "stale" : undefined}>
          <Value name="level" value={status.level} text={gridName(status.level)} />
          <Value name="iteration" value={status.iteration} text={String(status.iteration)} />
          <Value name="total" value={status.energies.total} text={decimals(status.energies.total)} />
          {!working && (
            <>
              <Value name="mismatch-max" value={status.mismatch.max} {...cells(status.mismatch.max)} />
              <Value name="mismatch-mean" value={status.mismatch.mean} {...cells(status.mismatch.mean)} />
              <Value name="cover-max" value={status.cover.max} {...cells(status.cover.max)} />
              <Value name="measure" value={status.measure} text={decimals(status.measure)} />
              <Value
                name="least-determinant"
                value={status.leastDeterminant}
                text={decimals(status.leastDeterminant)}
              />
            </>
          )}
        </dl>
      )}
      {isDone(phase) && !session.stale.value && status?.verdict && status.stop && (
        <p class="stop">{en.status.stop(status)}</p>
      )}
      {isDone(phase) && Report && <Report session={session} />}
      {!working && <Resolution session={session} />}
    </div>
  );
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
        <button type="button" onClick={() => session.matchOn(level)}>
          {en.actions.matchOn(gridName(level))}
        </button>
      )}
    </p>
  );
}

type Named = keyof typeof en.numbers & string;

/** For machines only what is a number; for people always words. */
function Value({ name, value, text, unit = "" }: { name: Named; value: number; text: string; unit?: string }) {
  return (
    <div>
      <dt>{en.numbers[name]}</dt>
      <dd>
        {Number.isFinite(value) ? (
          <data data-name={name} value={String(value)}>
            {text}
          </data>
        ) : (
          text
        )}
        {unit && <span class="unit">{unit}</span>}
      </dd>
    </div>
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
  if (!status) {
    return (
      <div class="progress unknown" role="progressbar" aria-label={en.result.title}>
        <div />
      </div>
    );
  }
  return (
    <div
      class="progress"
      role="progressbar"
      aria-label={en.result.title}
      aria-valuemin={0}
      aria-valuemax={100}
      aria-valuenow={percent}
    >
      <div style={{ inlineSize: `${percent}%` }} />
    </div>
  );
}
