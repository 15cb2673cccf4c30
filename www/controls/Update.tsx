import { takeOver, waiting } from "../offline/updates";
import { offline as say } from "../words/offline";

/** A new version waits: it says so, and a press lets it in. */
export function Update() {
  return (
    <div role="status" class="update" aria-label={say.region}>
      {waiting.value && (
        <div class="news">
          <p class="text">{say.waiting}</p>
          <button type="button" onClick={() => takeOver()}>
            {say.takeOver}
          </button>
        </div>
      )}
    </div>
  );
}
