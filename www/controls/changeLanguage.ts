/** The switch at the foot of the page: another language, by which nothing is lost. */

import { language, speak } from "../words/language";
import { change, KEY } from "./language";

/** `failed` is told of a language that does not come. */
export function listenForLanguage(failed: () => void): void {
  const button = change();
  if (!button) return;
  button.hidden = false;
  button.onclick = async () => {
    const wanted = language.value === "en" ? "de" : "en";
    try {
      await speak(wanted);
    } catch {
      failed();
      return;
    }
    try {
      localStorage.setItem(KEY, wanted);
    } catch {
      // Then it is chosen for this visit.
    }
    // What was asked for there is answered.
    const url = new URL(location.href);
    url.searchParams.delete("lang");
    history.replaceState(history.state, "", url);
  };
}
