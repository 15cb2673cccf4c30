import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { space as say } from "../words/space";
import { START, spoken } from "./camera";
import type { SpaceSession } from "./session";

/** What went wrong, until it is dismissed. */
export function Problem({ session }: { session: SpaceSession }) {
  const text = session.problem.value;
  return (
    <div role="alert">
      {text && (
        <div class="problem">
          <p class="text">{text}</p>
          <button
            type="button"
            class="quiet"
            onClick={() => {
              session.problem.value = null;
            }}
          >
            {say.actions.dismiss}
          </button>
        </div>
      )}
    </div>
  );
}

/** What the camera sees, a moment after it has come to rest. */
export function Spoken({ session }: { session: SpaceSession }) {
  const said = useSignal("");
  const pose = session.pose.value;
  useEffect(() => {
    const timer = setTimeout(() => {
      said.value = pose === START && said.peek() === "" ? "" : spoken(pose);
    }, 250);
    return () => clearTimeout(timer);
  }, [pose, said]);
  return (
    <p class="unseen" aria-live="polite" id="space-pose">
      {said}
    </p>
  );
}
