import { effect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { isDone, isFollowing, isPaused, isWorking } from "../phase";
import type { Status } from "../protocol";
import type { Session } from "../session";
import { coarsestLevel, finestLevel } from "../settings";
import { drawEnergies } from "../view/chart";
import { theme } from "../view/palette";
import { cells, decimals } from "./numbers";

/** What goes on, in words and as machine-readable values, with the energies as they fall. */
export function StatusPanel({ session }: { session: Session }) {
  const phase = session.phase.value;
  const status = session.fresh.value ? session.match.value?.status : undefined;
  const paused = isPaused(phase);
  const working = isWorking(phase) || isFollowing(phase);
  return (
    <div class="status-row">
      {/* Thirty updates a second would drown a screen reader: it hears the beginning and the end. */}
      <div role="status" aria-live={working && !paused && status ? "off" : "polite"}>
        <p class="headline">{headline(session, status)}</p>
        {isDone(phase) && status?.verdict && status.stop && <p class="stop">{status.stop}</p>}
        {!working && <Resolution session={session} />}
        {status && (
          <dl>
            <Value name="level" label="Grid" value={status.level} text={gridName(status.level)} />
            <Value name="iteration" label="Iteration" value={status.iteration} text={String(status.iteration)} />
            <Value name="total" label="Energy" value={status.energies.total} text={decimals(status.energies.total)} />
            {!working && (
              <>
                <Value
                  name="mismatch-max"
                  label="Largest distance"
                  value={status.mismatch.max}
                  text={cells(status.mismatch.max)}
                />
                <Value
                  name="mismatch-mean"
                  label="Mean distance"
                  value={status.mismatch.mean}
                  text={cells(status.mismatch.mean)}
                />
                <Value
                  name="cover-max"
                  label="Template missed by"
                  value={status.cover.max}
                  text={cells(status.cover.max)}
                />
                <Value name="measure" label="Length ratio" value={status.measure} text={decimals(status.measure)} />
                <Value
                  name="least-determinant"
                  label="Least area ratio"
                  value={status.leastDeterminant}
                  text={decimals(status.leastDeterminant)}
                />
              </>
            )}
          </dl>
        )}
      </div>
      <EnergyChart session={session} />
    </div>
  );
}

/** What the finest grid does not resolve, and the way to one that does. */
function Resolution({ session }: { session: Session }) {
  const inspection = session.inspection.value;
  if (!inspection?.words) return null;
  const { words, level } = inspection;
  return (
    <p class="resolution">
      {words}
      {level !== null && (
        <button type="button" onClick={() => session.matchOn(level)}>
          Match on {gridName(level)}
        </button>
      )}
    </p>
  );
}

/** For machines only what is a number; for people always words. */
function Value({ name, label, value, text }: { name: string; label: string; value: number; text: string }) {
  return (
    <div>
      <dt>{label}</dt>
      <dd>
        {Number.isFinite(value) ? (
          <data data-name={name} value={String(value)}>
            {text}
          </data>
        ) : (
          text
        )}
      </dd>
    </div>
  );
}

function gridName(level: number): string {
  const side = 2 ** level + 1;
  return `${side} × ${side}`;
}

function headline(session: Session, status: Status | undefined): string {
  const phase = session.phase.value;
  switch (phase) {
    case "idle":
      return "Ready: press Match.";
    case "cancelled":
      return "Cancelled. Press Match to start again.";
    case "preparing":
      return session.loaded.value ? "Preparing the shapes …" : "Loading the solver …";
    case "following":
    case "astray":
      return "Following your hand …";
    case "paused":
    case "pausedRefining":
      return "Paused.";
    default:
      if (!isDone(phase)) return status ? `${status.approach}, on the ${gridName(status.level)} grid …` : "Matching …";
      return status ? (status.verdict ?? status.stop ?? "Finished.") : "The shapes have changed: press Match.";
  }
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
      <div class="progress unknown" role="progressbar" aria-label="Match">
        <div />
      </div>
    );
  }
  return (
    <div
      class="progress"
      role="progressbar"
      aria-label="Match"
      aria-valuemin={0}
      aria-valuemax={100}
      aria-valuenow={percent}
    >
      <div style={{ inlineSize: `${percent}%` }} />
    </div>
  );
}

function EnergyChart({ session }: { session: Session }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(
    () =>
      effect(() => {
        const history = session.energies.value;
        const target = canvas.current;
        const context = target?.getContext("2d");
        if (!target || !context) return;
        const { clientWidth, clientHeight } = target;
        target.width = Math.round(clientWidth * devicePixelRatio);
        target.height = Math.round(clientHeight * devicePixelRatio);
        drawEnergies(context, target.width, target.height, devicePixelRatio, theme(), history);
      }),
    [session],
  );
  return (
    <figure class="chart" hidden={session.energies.value.length < 2}>
      <canvas ref={canvas} role="img" aria-label="Energy over iterations" />
      <figcaption>
        <span class="total">energy</span> and <span class="mismatch">its mismatch part</span>, logarithmic
      </figcaption>
    </figure>
  );
}
