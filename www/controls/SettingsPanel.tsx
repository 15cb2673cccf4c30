import type { Session } from "../session";
import { bandwidth, changedFields, FIELDS, type SettingField } from "../settings";
import { helps } from "../words/helps";
import { later } from "../words/later";
import { decimals } from "../words/numbers";
import { adopt } from "./adopt";
import { computedBy } from "./Computed";
import { Field } from "./Field";
import style from "./settings.css?inline";

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
              <Setting key={field.name} session={session} field={field} />
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
                  <Setting key={field.name} session={session} field={field} />
                ))}
            </fieldset>
          ))}
        </details>
      </div>
      <button type="button" disabled={changed === 0} onClick={() => session.choices.reset()}>
        {later.settings.reset}
      </button>
    </>
  );
}

/** A field of this session's, with what its value means where that is not plain. */
export function Setting({ session, field }: { session: Session; field: SettingField }) {
  const { automatic } = later.settings;
  const value = session.settings.value[field.name] ?? field.initial;
  const isAutomatic = field.name === "bandwidth" && value === 0;
  const status = field.name === "backend" ? session.match.value?.status : undefined;
  const last = status && later.card.last(computedBy(status));
  return (
    <Field
      field={field}
      value={value}
      help={`${helps[field.name] ?? ""}${isAutomatic ? ` ${automatic(chosenBand(session))}` : ""}${last ? ` ${last}` : ""}`}
      change={(next) => session.choices.change(field, next)}
      preview={(next, at) => field.kind === "number" && session.choices.preview(field, next, at)}
    />
  );
}

function chosenBand(session: Session): string {
  return decimals(bandwidth(session.settings.value));
}
