import { adopt } from "../controls/adopt";
import { computedBy } from "../controls/Computed";
import { Field } from "../controls/Field";
import style from "../controls/settings.css?inline";
import { helps } from "../words/helps";
import { later } from "../words/later";
import { space as say } from "../words/space";
import type { SpaceSession } from "./session";
import { SPACE_FIELDS } from "./settings";

adopt(style);

function helpOf(name: string, session: SpaceSession): string {
  if (name === "finest") return say.finestHelp;
  const help = helps[name as keyof typeof helps] ?? "";
  const status = name === "backend" ? session.result.value?.frame.status : undefined;
  return status ? `${help} ${later.card.last(computedBy(status))}` : help;
}

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
            help={helpOf(field.name, session)}
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
