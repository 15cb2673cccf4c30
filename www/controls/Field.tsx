import { useSignal } from "@preact/signals";
import { type NumberSetting, parseSetting, type SettingField } from "../settings";
import { later } from "../words/later";
import { written } from "../words/numbers";
import { Sign } from "./Sign";
import { fromSlider, onSlider, SLIDER_STEPS } from "./slider";

type Properties = {
  readonly field: SettingField;
  readonly value: number | string | boolean;
  readonly help: string;
  /** Throws a sentence for what cannot be chosen. */
  readonly change: (value: number | string | boolean) => void;
  /** Where a slider is followed while it moves, with the time of the event. */
  readonly preview?: (value: number, at: number) => void;
};

/** One setting: its name, its value in a list or in words, and what it does. */
export function Field({ field, value, help, change, preview }: Properties) {
  const problem = useSignal<string | null>(null);
  const id = `setting-${field.name}`;
  const take = (text: string) => {
    try {
      change(parseSetting(field, text));
      problem.value = null;
    } catch (error) {
      problem.value = error instanceof Error ? error.message : String(error);
    }
  };
  return (
    <div class="field">
      <label for={id}>{field.label}</label>
      {field.symbol.includes("_") && <Sign text={field.symbol} />}
      {field.kind === "choice" ? (
        <select
          id={id}
          value={String(value)}
          aria-describedby={`${id}-help`}
          onChange={(event) => take(event.currentTarget.value)}
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
            onChange={(event) => take(event.currentTarget.value)}
          />
          {field.unit && <span class="unit">{field.unit}</span>}
        </span>
      )}
      {field.kind === "number" && preview && (
        <Slider field={field} value={Number(value)} change={change} preview={preview} />
      )}
      <p id={`${id}-help`} class={problem.value ? "help wrong" : "help"}>
        {problem.value ?? help}
      </p>
    </div>
  );
}

/** The same value by a slider, which Live follows while it moves. */
function Slider({ field, value, change, preview }: Slid) {
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
      onInput={(event) => preview(chosen(event), event.timeStamp)}
      onChange={(event) => change(chosen(event))}
    />
  );
}

type Slid = Required<Pick<Properties, "change" | "preview">> & {
  readonly field: NumberSetting;
  readonly value: number;
};
