import { type Signal, useComputed, useSignal } from "@preact/signals";
import { useEffect, useMemo } from "preact/hooks";
import { sentence } from "../run";
import type { Session } from "../session";
import { bandwidth, type Chosen, FIELDS, parseSetting, withSetting } from "../settings";
import type { ResultScene } from "../view/result";
import { adopt } from "./adopt";
import style from "./compare.css?inline";
import { Comparison, type Outcome } from "./compared";
import { Legend } from "./Legend";
import { MatchCanvas } from "./MatchCanvas";
import { decimals } from "./numbers";
import { Readout } from "./Readout";
import { ViewPicker } from "./ViewPicker";
import { lazy, view } from "./viewing";

adopt(style);

/** One setting changed from those of the page, as text; an empty field changes none. */
type Change = { readonly field: string; readonly value: string };

const SIDES = ["A", "B"] as const;

/** Two settings on the page's shapes, side by side; view and morph are one for both. */
export function Compare({ session }: { session: Session }) {
  const a = useSignal<Change>({ field: "", value: "" });
  const b = useSignal<Change>({ field: "bending", value: "0" });
  const comparison = useMemo(
    () =>
      new Comparison(session.engine, (message) => {
        session.problem.value = sentence(message);
      }),
    [session],
  );
  useEffect(() => () => comparison.dispose(), [comparison]);

  const run = () => {
    try {
      const shapes = session.shapes.value;
      const [first, second] = [a.value, b.value].map((change) => ({
        ...shapes,
        settings: changed(session.settings.value, change),
      }));
      session.problem.value = null;
      comparison.run([first, second]);
    } catch (error) {
      session.problem.value = error instanceof Error ? error.message : String(error);
    }
  };
  const { busy, outcomes } = comparison;
  const [left, right] = outcomes.value;
  const percent = Math.round(100 * session.morph.value);
  return (
    <>
      <div class="compare-bar">
        <ChangeField side="A" change={a} />
        <ChangeField side="B" change={b} />
        <button type="button" class="primary" disabled={busy.value} onClick={run}>
          {busy.value ? "Comparing …" : "Compare"}
        </button>
        <button type="button" disabled={!busy.value} onClick={() => comparison.stop()}>
          Stop comparing
        </button>
        <ViewPicker session={session} name="View of both" />
        <label class="both-morph">
          Morph of both
          <input
            type="range"
            min={0}
            max={100}
            value={percent}
            disabled={!left && !right}
            onInput={(event) => {
              session.morph.value = event.currentTarget.valueAsNumber / 100;
            }}
          />
        </label>
      </div>
      {(left || right) && (
        <div class="pair">
          <Panel session={session} comparison={comparison} index={0} />
          <Panel session={session} comparison={comparison} index={1} />
        </div>
      )}
      {left && right && <Differences a={left} b={right} />}
    </>
  );
}

function ChangeField({ side, change }: { side: "A" | "B"; change: Signal<Change> }) {
  const field = FIELDS.find(({ name }) => name === change.value.field);
  return (
    <fieldset class="change">
      <legend>{side}: the page’s settings, but</legend>
      <select
        aria-label={`Setting that ${side} changes`}
        value={change.value.field}
        onChange={(event) => {
          const name = event.currentTarget.value;
          change.value = { field: name, value: String(FIELDS.find((other) => other.name === name)?.initial ?? "") };
        }}
      >
        <option value="">nothing changed</option>
        {FIELDS.map(({ name, label }) => (
          <option key={name} value={name}>
            {label}
          </option>
        ))}
      </select>
      {field?.kind === "choice" && (
        <select
          aria-label={`${field.label} of ${side}`}
          value={change.value.value}
          onChange={(event) => {
            change.value = { field: field.name, value: event.currentTarget.value };
          }}
        >
          {field.options.map((option) => (
            <option key={String(option.value)} value={String(option.value)}>
              {option.label}
            </option>
          ))}
        </select>
      )}
      {field?.kind === "number" && (
        <input
          type="number"
          step="any"
          min={field.least}
          max={field.most}
          aria-label={`${field.label} of ${side}`}
          value={change.value.value}
          onChange={(event) => {
            change.value = { field: field.name, value: event.currentTarget.value };
          }}
        />
      )}
    </fieldset>
  );
}

/** Throws a sentence for a value the setting cannot have. */
function changed(settings: Chosen, { field: name, value }: Change): Chosen {
  const field = FIELDS.find((candidate) => candidate.name === name);
  return field ? withSetting(settings, field, parseSetting(field, value)) : settings;
}

type PanelProperties = { readonly session: Session; readonly comparison: Comparison; readonly index: 0 | 1 };

function Panel({ session, comparison, index }: PanelProperties) {
  const { outcomes } = comparison;
  const match = useComputed(() => {
    const outcome = outcomes.value[index];
    return outcome && matchOf(outcome);
  });
  const scene = useComputed<ResultScene>(() => {
    const outcome = outcomes.value[index];
    return {
      reference: outcome?.reference ?? [],
      template: outcome?.template ?? [],
      match: match.value,
      morph: session.morph.value,
      bandwidth: bandwidth(outcome?.settings ?? {}),
    };
  });
  // One scale for both, or their colours could not be compared.
  const limit = useComputed(() =>
    Math.max(
      ...outcomes.value.map(
        (outcome) =>
          (outcome && lazy.value?.views.limitOf(view.value, matchOf(outcome), bandwidth(outcome.settings))) || 0,
      ),
      Number.MIN_VALUE,
    ),
  );
  const label = `Result of ${SIDES[index]}`;
  return (
    <figure class="side">
      <figcaption>{SIDES[index]}</figcaption>
      <div class="surface">
        <MatchCanvas label={label} scene={scene} limit={limit} />
        <Legend session={session} match={match} limit={limit} />
        <Readout match={match} name={`Numbers at the point, ${SIDES[index]}`} />
      </div>
    </figure>
  );
}

function matchOf({ frame: { status, deformation, curves } }: Outcome) {
  return { level: status.level, deformation, curves };
}

function Differences({ a, b }: { a: Outcome; b: Outcome }) {
  return (
    <table class="differences">
      <caption class="unseen">Differences between A and B</caption>
      <thead>
        <tr>
          <td />
          <th scope="col">A</th>
          <th scope="col">B</th>
          <th scope="col">B − A</th>
        </tr>
      </thead>
      <tbody>
        {rowsOf(a).map(([name, first], i) => {
          const second = rowsOf(b)[i][1];
          return (
            <tr key={name}>
              <th scope="row">{name}</th>
              <td>{decimals(first)}</td>
              <td>{decimals(second)}</td>
              <td>{decimals(second - first).replace("-", "−")}</td>
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}

function rowsOf({ frame: { status }, millis }: Outcome): readonly (readonly [string, number])[] {
  const { energies, mismatch, cover, stretch } = status;
  return [
    ["Energy", energies.total],
    ["of stretching", energies.membrane],
    ["of bending", energies.bending],
    ["of the mismatch", energies.mismatch],
    ["of the volume", energies.volume],
    ["Largest distance, cells", mismatch.max],
    ["Mean distance, cells", mismatch.mean],
    ["Template missed by, cells", cover.max],
    ["Length ratio", status.measure],
    ["Mean stretch", stretch.mean],
    ["Deviation of the stretch", stretch.deviation],
    ["Least area ratio", status.leastDeterminant],
    ["Evaluations", status.evaluations],
    ["Time, ms", millis],
  ];
}
