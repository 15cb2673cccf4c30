/**
 * Which session is this tab's: the same after a reload, another in every other tab. A tab that is duplicated takes its
 * name along; the lock tells which of the two had it first.
 */

const KEY = "thinshell:tab";

type Locks = Pick<LockManager, "request">;

export class Tab {
  private readonly storage: () => Storage;
  private readonly locks: Locks | undefined;
  private name: string;

  constructor(storage: () => Storage = () => sessionStorage, locks: Locks | undefined = navigator.locks) {
    this.storage = storage;
    this.locks = locks;
    this.name = this.known() ?? this.another();
    this.hold();
  }

  get id(): string {
    return this.name;
  }

  private known(): string | null {
    try {
      return this.storage().getItem(KEY);
    } catch {
      return null;
    }
  }

  private another(): string {
    const name = Array.from(crypto.getRandomValues(new Uint8Array(8)), (byte) => byte.toString(16).padStart(2, "0"));
    try {
      this.storage().setItem(KEY, name.join(""));
    } catch {
      // Switched off: then a reload begins another session, with the same shapes from the address.
    }
    return name.join("");
  }

  /** For as long as the tab is there; a browser without locks has to trust the name. */
  private hold(): void {
    const held = this.locks?.request(`${KEY}:${this.name}`, { ifAvailable: true }, (lock) => {
      if (lock) return new Promise<void>(() => {});
      this.name = this.another();
      this.hold();
    });
    held?.catch(() => {});
  }
}
