import { type Signal, useSignal } from "@preact/signals";
import { useEffect, useMemo } from "preact/hooks";
import { sentence } from "../run";
import type { Session } from "../session";
import { type Chosen, FIELDS, parseSetting, withSetting } from "../settings";
import { later } from "../words/later";
import { adopt } from "./adopt";
import style from "./compare.css?inline";
import { Comparison } from "./compared";
import { Pair } from "./Pair";
import { ViewPicker } from "./ViewPicker";

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
          {busy.value ? later.compare.running : later.compare.run}
        </button>
        <button type="button" disabled={!busy.value} onClick={() => comparison.stop()}>
          {later.compare.stop}
        </button>
        <ViewPicker session={session} name={later.compare.view} />
        <label class="both-morph">
          {later.compare.morph}
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
      <Pair session={session} outcomes={outcomes} names={SIDES} />
    </>
  );
}

function ChangeField({ side, change }: { side: "A" | "B"; change: Signal<Change> }) {
  const field = FIELDS.find(({ name }) => name === change.value.field);
  return (
    <fieldset class="change">
      <legend>{later.compare.but(side)}</legend>
      <select
        aria-label={later.compare.setting(side)}
        value={change.value.field}
        onChange={(event) => {
          const name = event.currentTarget.value;
          change.value = { field: name, value: String(FIELDS.find((other) => other.name === name)?.initial ?? "") };
        }}
      >
        <option value="">{later.compare.nothing}</option>
        {FIELDS.map(({ name, label }) => (
          <option key={name} value={name}>
            {label}
          </option>
        ))}
      </select>
      {field?.kind === "choice" && (
        <select
          aria-label={later.compare.of(field.label, side)}
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
          aria-label={later.compare.of(field.label, side)}
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
