/** Writes down what is on the page, a moment after each change and when the page is left. */

import { effect, type ReadonlySignal } from "@preact/signals";
import { Delay } from "../delay";

/** Browsers allow the address to be written some three times a second. */
const REMEMBER_MILLIS = 400;

/** `last` is what is written down already. */
export function rememberChanges(
  text: ReadonlySignal<string>,
  last: string | null,
  write: (text: string) => void,
): void {
  const delay = new Delay(REMEMBER_MILLIS);
  let written = last;
  let waiting = false;
  const remember = () => {
    waiting = false;
    if (text.peek() === written) return;
    written = text.peek();
    write(written);
  };
  effect(() => {
    // While something changes all the time, as a morph that plays, what has changed beside it is written too.
    if (text.value === written || waiting) return;
    waiting = true;
    delay.start(remember);
  });
  // Leaving the page within that time loses nothing either.
  addEventListener("pagehide", remember);
}
