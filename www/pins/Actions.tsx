import type { Session } from "../session";
import { said } from "../tools/tool";
import { begun, chosen } from "./kit";
import { without } from "./places";
import { actions, told } from "./words";

/** What can be done to pins by a press, for those without a Delete key. */
export function Actions({ session }: { session: Session }) {
  const { pins } = session.shapes.value;
  const index = chosen.value;
  if (pins.length === 0) return null;
  const remove = (remaining: typeof pins, words: string) => {
    session.commitPins(remaining);
    chosen.value = null;
    said.value = words;
  };
  return (
    <div class="group">
      {index !== null && index < pins.length && (
        <button type="button" onClick={() => remove(without(pins, index), told.deleted(index))}>
          {actions.delete(index)}
        </button>
      )}
      <button type="button" onClick={() => remove([], told.allDeleted)}>
        {actions.deleteAll}
      </button>
    </div>
  );
}

/** What can be done next with pins. */
export function guide({ shapes }: Session): string {
  const { pins } = shapes.value;
  const waiting = begun.value;
  if (waiting) return actions.partner(pins.length + 1, waiting.side === "reference" ? "template" : "reference");
  return chosen.value !== null && pins[chosen.value] ? actions.chosen(chosen.value) : actions.first;
}
