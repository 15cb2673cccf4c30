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
  const remember = () => {
    if (text.peek() === written) return;
    written = text.peek();
    write(written);
  };
  effect(() => {
    if (text.value === written) delay.stop();
    else delay.start(remember);
  });
  // Leaving the page within that time loses nothing either.
  addEventListener("pagehide", remember);
}
