import { adopt } from "../controls/adopt";
import { Field } from "../controls/Field";
import style from "../controls/settings.css?inline";
import { helps } from "../words/helps";
import { space as say } from "../words/space";
import type { SpaceSession } from "./session";
import { SPACE_FIELDS } from "./settings";

adopt(style);

/** What can be chosen of the model for surfaces. */
export function SettingsPanel({ session }: { session: SpaceSession }) {
  const { settings } = session.step.value;
  const count = SPACE_FIELDS.filter(({ name }) => settings[name] !== undefined).length;
  return (
    <details class="later settings">
      <summary>
        {say.settings}
        <span class="count">{say.changed(count)}</span>
      </summary>
      <fieldset>
        <legend class="unseen">{say.settings}</legend>
        {SPACE_FIELDS.map((field) => (
          <Field
            key={field.name}
            field={field}
            value={settings[field.name] ?? field.initial}
            help={field.name === "finest" ? say.finestHelp : (helps[field.name] ?? "")}
            change={(value) => session.changeSetting(field, value)}
          />
        ))}
      </fieldset>
      <button type="button" disabled={count === 0} onClick={() => session.commit({ settings: {} })}>
        {say.reset}
      </button>
    </details>
  );
}
