import { useSignal } from "@preact/signals";
import type { Session } from "../session";
import { VIEWS, type View } from "../view/names";
import { choose, view } from "./viewing";

/** Chooses how the match is drawn. */
export function ViewPicker({ session, name = "View" }: { session: Session; name?: string }) {
  const busy = useSignal(false);
  const change = async (wanted: View) => {
    busy.value = true;
    try {
      await choose(wanted);
    } catch (error) {
      session.problem.value = error instanceof Error ? error.message : String(error);
    } finally {
      busy.value = false;
    }
  };
  return (
    <select
      class="view-picker"
      aria-label={name}
      aria-busy={busy.value}
      aria-describedby={name === "View" ? "view-caption" : undefined}
      value={view.value}
      onChange={(event) => void change(event.currentTarget.value as View)}
    >
      {VIEWS.map(({ view: value, label }) => (
        <option key={value} value={value}>
          {label}
        </option>
      ))}
    </select>
  );
}
