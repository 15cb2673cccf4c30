/** What this tab is at, kept in its address and in the browser's storage. */

import { signal } from "@preact/signals";
import { addressOf } from "../link/open";
import { Sessions } from "./sessions";
import { Tab } from "./tab";

export class Memory {
  readonly sessions: Sessions;
  private readonly tab: Pick<Tab, "id">;
  /** What was there when the page was opened: this tab's own session, else the last of all. A link's text. */
  readonly found: string | null;
  /** How often something has been kept: whoever lists the sessions looks again. */
  readonly writes = signal(0);
  private failed = false;
  /** Told once, when the storage keeps nothing. */
  onFailure: () => void = () => {};

  constructor(sessions = new Sessions(), tab: Pick<Tab, "id"> = new Tab()) {
    this.sessions = sessions;
    this.tab = tab;
    this.found = (sessions.read(tab.id) ?? sessions.list()[0])?.text ?? null;
  }

  get own(): string {
    return this.tab.id;
  }

  /** At once: the tab may be gone in the next moment. */
  keep(text: string): void {
    const kept = this.sessions.write({ id: this.tab.id, at: Date.now(), text });
    this.writes.value = this.writes.peek() + 1;
    if (kept || this.failed) return;
    this.failed = true;
    this.onFailure();
  }

  /** Leaves this tab's session as it is, beside what is kept from now on. */
  setAside(): void {
    const kept = this.sessions.read(this.own);
    if (kept) this.sessions.write({ ...kept, id: `${kept.id}-${kept.at}` });
  }

  /** In the address as well, which browsers allow to be written some three times a second. */
  remember(text: string): void {
    history.replaceState(null, "", addressOf(text));
    this.keep(text);
  }
}
