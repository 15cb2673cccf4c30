import { takeOver, waiting } from "../offline/updates";
import { offline as say } from "../words/offline";

export { keepOffline } from "../offline/updates";

/** A new version waits: it says so, and a press lets it in. */
export function Update() {
  return (
    // No status: that is the run's alone.
    <section class="update" aria-live="polite" aria-label={say.region}>
      {waiting.value && (
        <div class="news">
          <p class="text">{say.waiting}</p>
          <button type="button" onClick={() => takeOver()}>
            {say.takeOver}
          </button>
        </div>
      )}
    </section>
  );
}
