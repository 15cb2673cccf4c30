import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import type { Session } from "../session";
import { en } from "../words/en";
import { fetched } from "./fetched";

/** Draws what each term pulls at, over the picture. */
export function ForcesSwitch({ session }: { session: Session }) {
  const on = useSignal(false);
  const stop = useRef<() => void>(() => {});
  useEffect(() => () => stop.current(), []);
  const change = async (wanted: boolean) => {
    on.value = wanted;
    stop.current();
    stop.current = () => {};
    if (!wanted) return;
    try {
      const { showForces } = await fetched(en.terms.forces, () => import("../forces/showing"));
      if (on.value) stop.current = showForces(session);
    } catch (error) {
      on.value = false;
      session.problem.value = error instanceof Error ? error.message : String(error);
    }
  };
  return (
    <label class="forces">
      <input type="checkbox" checked={on.value} onChange={(event) => void change(event.currentTarget.checked)} />
      {en.terms.forces}
    </label>
  );
}
