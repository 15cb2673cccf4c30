import { useSignal } from "@preact/signals";
import { useRef } from "preact/hooks";
import type { Session } from "../session";
import { later } from "../words/later";
import { fetched } from "./fetched";

/** Shows the result alone, and leaves that again. */
export function Present({ session }: { session: Session }) {
  const keys = useSignal<string | null>(null);
  const end = useRef<() => void>(() => {});
  const begin = async () => {
    try {
      const part = await fetched(later.present.what, () => import("./presenting"));
      end.current = part.present(session, () => {
        keys.value = null;
      });
      keys.value = part.keys();
    } catch (error) {
      session.problem.value = error instanceof Error ? error.message : String(error);
    }
  };
  const on = keys.value !== null;
  return (
    <>
      <button
        type="button"
        class="present"
        title={later.present.help}
        onClick={() => (on ? end.current() : void begin())}
      >
        {on ? later.present.leave : later.present.enter}
      </button>
      {on && <p class="present-keys">{keys}</p>}
    </>
  );
}
