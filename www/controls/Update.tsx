import { takeOver, waiting } from "../offline/updates";
import { offline as say } from "../words/offline";

/** A new version waits: it says so, and a press lets it in. */
export function Update() {
  return (
    <div role="status" class="update" aria-label={say.region}>
      {waiting.value && (
        <p>
          {say.waiting}{" "}
          <button type="button" onClick={() => takeOver()}>
            {say.takeOver}
          </button>
        </p>
      )}
    </div>
  );
}
