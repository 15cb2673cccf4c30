import { useSignal } from "@preact/signals";
import { changedFields, type Session } from "../session";
import { bandwidth, FIELDS, type NumberSetting, parseSetting, type SettingField } from "../settings";
import { helps } from "../words/helps";
import { later } from "../words/later";
import { decimals, written } from "../words/numbers";
import { adopt } from "./adopt";
import style from "./settings.css?inline";
import { fromSlider, onSlider, SLIDER_STEPS } from "./slider";

adopt(style);

const GROUPS = ["Energies", "Grid", "Method"] as const;

/** What most people want to change; the others are for those who know the paper. */
const PLAIN: ReadonlySet<string> = new Set(["membrane", "bending", "penalty", "volume", "pinWeight", "finest"]);

/** The model's parameters. Only those that differ from their defaults go to the solver. */
export function SettingsPanel({ session }: { session: Session }) {
  const changed = changedFields(session.settings.value).length;
  // Without pins their strength would be a riddle.
  const pinned = session.shapes.value.pins.length > 0;
  const fields = FIELDS.filter(({ name }) => name !== "pinWeight" || pinned);
  return (
    <>
      <div class="groups">
        <fieldset>
          <legend class="unseen">{later.settings.plain}</legend>
          {fields
            .filter(({ name }) => PLAIN.has(name))
            .map((field) => (
              <Field key={field.name} session={session} field={field} />
            ))}
        </fieldset>
        <details class="experts">
          <summary>{later.settings.experts}</summary>
          {GROUPS.map((group) => (
            <fieldset key={group}>
              <legend>{later.settings.groups[group]}</legend>
              {fields
                .filter((field) => field.group === group && !PLAIN.has(field.name))
                .map((field) => (
                  <Field key={field.name} session={session} field={field} />
                ))}
            </fieldset>
          ))}
        </details>
      </div>
      <button type="button" disabled={changed === 0} onClick={() => session.resetSettings()}>
        {later.settings.reset}
      </button>
    </>
  );
}

function Field({ session, field }: { session: Session; field: SettingField }) {
  const { automatic } = later.settings;
  const problem = useSignal<string | null>(null);
  const value = session.settings.value[field.name] ?? field.initial;
  const id = `setting-${field.name}`;
  const change = (text: string) => {
    try {
      session.changeSetting(field, parseSetting(field, text));
      problem.value = null;
    } catch (error) {
      problem.value = error instanceof Error ? error.message : String(error);
    }
  };
  return (
    <div class="field">
      <label for={id}>{field.label}</label>
      <Sign text={field.symbol} />
      {field.kind === "choice" ? (
        <select
          id={id}
          value={String(value)}
          aria-describedby={`${id}-help`}
          onChange={(event) => change(event.currentTarget.value)}
        >
          {field.options.map((option) => (
            <option key={String(option.value)} value={String(option.value)}>
              {option.label}
            </option>
          ))}
        </select>
      ) : (
        <span class="number">
          <input
            id={id}
            type="number"
            inputMode="decimal"
            min={field.least}
            max={field.most}
            step="any"
            value={String(value)}
            aria-describedby={`${id}-help`}
            aria-invalid={problem.value !== null}
            onChange={(event) => change(event.currentTarget.value)}
          />
          {field.unit && <span class="unit">{field.unit}</span>}
        </span>
      )}
      {field.kind === "number" && <Slider session={session} field={field} value={Number(value)} />}
      <p id={`${id}-help`} class={problem.value ? "help wrong" : "help"}>
        {problem.value ?? helps[field.name]}
        {field.name === "bandwidth" && value === 0 && ` ${automatic(chosenBand(session))}`}
      </p>
    </div>
  );
}

/** A symbol with an index, beside the word for it; one without stands in the label. */
function Sign({ text }: { text: string }) {
  if (!text.includes("_")) return null;
  const [letter, index] = text.split("_");
  return (
    <span class="symbol">
      {letter}
      <sub>{index}</sub>
    </span>
  );
}

function chosenBand(session: Session): string {
  return decimals(bandwidth(session.settings.value));
}

/** The same value by a slider, which Live follows while it moves. */
function Slider({ session, field, value }: { session: Session; field: NumberSetting; value: number }) {
  const chosen = (event: { readonly currentTarget: HTMLInputElement }) =>
    fromSlider(field, event.currentTarget.valueAsNumber);
  return (
    <input
      type="range"
      aria-label={later.settings.slider(field.label)}
      aria-valuetext={`${written(String(value))} ${field.unit}`.trim()}
      min={0}
      max={SLIDER_STEPS}
      step={1}
      value={onSlider(field, value)}
      onInput={(event) => session.previewSetting(field, chosen(event), event.timeStamp)}
      onChange={(event) => session.changeSetting(field, chosen(event))}
    />
  );
}
