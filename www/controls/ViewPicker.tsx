import { useSignal } from "@preact/signals";
import type { Session } from "../session";
import { VIEWS, type View } from "../view/names";
import { en } from "../words/en";
import { choose, view } from "./viewing";

/** Chooses how the match is drawn. */
export function ViewPicker({ session, name }: { session: Session; name?: string }) {
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
      aria-label={name ?? en.view}
      aria-busy={busy.value}
      aria-describedby={name ? undefined : "view-caption"}
      value={view.value}
      onChange={(event) => void change(event.currentTarget.value as View)}
    >
      {VIEWS.map((value) => (
        <option key={value} value={value}>
          {en.views[value]}
        </option>
      ))}
    </select>
  );
}
