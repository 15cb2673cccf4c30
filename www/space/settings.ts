/** The settings as they are for surfaces: other levels are usual than for curves. */

import { type Chosen, FIELDS, type SettingField } from "../settings";
import { space as say } from "../words/space";

const FINEST = 5;
const LEVELS = [4, 5, 6, 7];

/** What the panel offers. */
const OFFERED: ReadonlySet<string> = new Set([
  "membrane",
  "bending",
  "penalty",
  "volume",
  "align",
  "bendingModel",
  "pinWeight",
  "backend",
]);

export const SPACE_FIELDS: readonly SettingField[] = FIELDS.flatMap((field): SettingField[] => {
  if (field.name === "finest") {
    const options = LEVELS.map((value) => ({ value, label: say.grid(value) }));
    return [
      {
        ...field,
        kind: "choice",
        initial: FINEST,
        options,
        // Asked for whenever it is shown, for the language may have changed.
        get label() {
          return say.finest;
        },
      },
    ];
  }
  return OFFERED.has(field.name) ? [field] : [];
});

export function finestLevel(chosen: Chosen): number {
  return chosen.finest ?? FINEST;
}
