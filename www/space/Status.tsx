import { Computed } from "../controls/Computed";
import { Bar, Numbers, Value } from "../controls/Figures";
import { isDone, isPaused, isWorking } from "../phase";
import { en } from "../words/en";
import { decimals } from "../words/numbers";
import { verdict } from "../words/said";
import { space as say } from "../words/space";
import { farthestOff } from "./pins";
import type { SpaceSession } from "./session";
import { finestLevel } from "./settings";

/** What goes on, in words and as machine-readable values. */
export function Status({ session }: { session: SpaceSession }) {
  const phase = session.phase.value;
  const status = session.fresh.value ? session.result.value?.frame.status : undefined;
  const [paused, working] = [isPaused(phase), isWorking(phase)];
  const cells = (value: number) =>
    Number.isFinite(value) ? { text: decimals(value), unit: say.cells } : { text: say.nothing };
  return (
    // A screen reader hears the beginning and the end.
    <div class="status" role="status" aria-live={working && !paused && status ? "off" : "polite"}>
      <p class="headline">{headline(session)}</p>
      {status && (
        <Numbers
          status={status}
          stale={session.stale.value}
          working={working}
          labels={say.numbers}
          grid={say.grid(status.level)}
          cells={cells}
          among={
            <>
              <Value
                {...named("area-deviation")}
                value={status.stretch.deviation}
                text={decimals(status.stretch.deviation)}
              />
              <PinsOff session={session} />
            </>
          }
        >
          <Computed status={status} />
        </Numbers>
      )}
      {isDone(phase) && !session.stale.value && status?.verdict && status.stop && (
        <p class="stop">{en.status.stop(status)}</p>
      )}
    </div>
  );
}

/** How far the pin that ends farthest from its partner does. */
function PinsOff({ session }: { session: SpaceSession }) {
  const result = session.result.value;
  if (!result || result.pins.length === 0) return null;
  const { pins, reference, frame } = result;
  const off = farthestOff(pins, reference.positions, frame.matched) * 2 ** frame.status.level;
  return <Value {...named("pins-off")} value={off} text={decimals(off)} unit={say.cells} />;
}

/** The one sentence under the picture. */
export function headline(session: SpaceSession): string {
  const phase = session.phase.value;
  const { status: words } = say;
  const status = session.fresh.value ? session.result.value?.frame.status : undefined;
  if (phase === "idle") return words.ready;
  if (phase === "cancelled") return words.cancelled;
  if (phase === "preparing") return session.loaded.value ? words.preparing : words.loading;
  if (isPaused(phase)) return words.paused;
  if (!status || session.stale.value) return words.changed;
  return isDone(phase) ? verdict(status) : words.on(say.grid(status.level));
}

/** The state, for those who do not see the picture. */
export function resultState(session: SpaceSession): string {
  const phase = session.phase.value;
  const { state } = say;
  const status = session.result.value?.frame.status;
  if (!status) return phase === "preparing" ? state.starting : state.none;
  if (isPaused(phase)) return state.paused;
  if (session.stale.value) return state.stale;
  const off = Math.max(status.mismatch.max, status.cover.max);
  return isDone(phase) ? state.matched(decimals(off)) : state.on(say.grid(status.level));
}

function named(name: keyof typeof say.numbers) {
  return { name, label: say.numbers[name] };
}

/** How far the cascade is, as a part of its levels. */
export function Progress({ session }: { session: SpaceSession }) {
  if (!isWorking(session.phase.value)) return <div class="progress idle" />;
  const status = session.fresh.value ? session.result.value?.frame.status : undefined;
  if (!status) return <Bar label={say.actions.match} percent={null} />;
  // Each level takes as long as all before it, and nobody knows how many iterations it needs.
  const left = Math.max(0, finestLevel(session.step.value.settings) - status.level);
  const within = 0.5 + 0.5 * (status.iteration / (status.iteration + 8));
  return <Bar label={say.actions.match} percent={Math.round(100 * 2 ** -left * within)} />;
}
