/** The switch at the foot of the page: another language, by which nothing is lost. */

import { en } from "../words/en";
import { language, speak } from "../words/language";
import { change, KEY } from "./language";

/** For a page that has no place of its own for what goes wrong: says above its content that a language does not come. */
export function sayAbove(content: HTMLElement): () => void {
  const alert = document.createElement("p");
  alert.className = "problem";
  alert.setAttribute("role", "alert");
  return () => {
    alert.textContent = en.missing.sentence(en.missing.language);
    content.before(alert);
  };
}

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
