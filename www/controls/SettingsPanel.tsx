import { useSignal } from "@preact/signals";
import { changedFields, type Session } from "../session";
import { FIELDS, type NumberSetting, parseSetting, type SettingField } from "../settings";
import { fromSlider, onSlider, SLIDER_STEPS } from "./slider";

const GROUPS = ["Energies", "Grid", "Method"] as const;

/** The model's parameters. Only those that differ from their defaults go to the solver. */
export function SettingsPanel({ session }: { session: Session }) {
  const changed = changedFields(session.settings.value).length;
  return (
    <details class="settings">
      <summary>Settings{changed > 0 && <span class="count"> ({changed} changed)</span>}</summary>
      <div class="groups">
        {GROUPS.map((group) => (
          <fieldset key={group}>
            <legend>{group}</legend>
            {FIELDS.filter((field) => field.group === group).map((field) => (
              <Field key={field.name} session={session} field={field} />
            ))}
          </fieldset>
        ))}
      </div>
      <button type="button" disabled={changed === 0} onClick={() => session.resetSettings()}>
        Reset to defaults
      </button>
    </details>
  );
}

function Field({ session, field }: { session: Session; field: SettingField }) {
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
        {problem.value ?? field.help}
      </p>
    </div>
  );
}

/** The same value by a slider, which Live follows while it moves. */
function Slider({ session, field, value }: { session: Session; field: NumberSetting; value: number }) {
  const chosen = (event: { readonly currentTarget: HTMLInputElement }) =>
    fromSlider(field, event.currentTarget.valueAsNumber);
  return (
    <input
      type="range"
      aria-label={`${field.label}, slider`}
      aria-valuetext={`${value} ${field.unit}`.trim()}
      min={0}
      max={SLIDER_STEPS}
      step={1}
      value={onSlider(field, value)}
      onInput={(event) => session.previewSetting(field, chosen(event), event.timeStamp)}
      onChange={(event) => session.changeSetting(field, chosen(event))}
    />
  );
}
