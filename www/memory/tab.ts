/**
 * Which session is this tab's: the same after a reload, another in every other tab. A tab that is duplicated takes its
 * name along; the lock tells which of the two had it first. Where there are no locks, as on pages without https, tabs ask
 * one another.
 */

const KEY = "thinshell:tab";

type Locks = Pick<LockManager, "request">;
type Channel = Pick<BroadcastChannel, "postMessage" | "onmessage">;

/** Whose a name is: a tab asks when it begins, and who has it says so. */
type Word = { readonly kind: "whose" | "mine"; readonly name: string };

export class Tab {
  private readonly storage: () => Storage;
  private readonly locks: Locks | null;
  private name: string;

  constructor(
    storage: () => Storage = () => sessionStorage,
    locks: Locks | null = navigator.locks ?? null,
    channel: () => Channel = () => new BroadcastChannel(KEY),
  ) {
    this.storage = storage;
    this.locks = locks;
    this.name = this.known() ?? this.another();
    if (locks) this.hold();
    else this.ask(channel());
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

  private ask(channel: Channel): void {
    const tell = (kind: Word["kind"]) => channel.postMessage({ kind, name: this.name } satisfies Word);
    channel.onmessage = ({ data: { kind, name } }: MessageEvent<Word>) => {
      if (name !== this.name) return;
      if (kind === "whose") tell("mine");
      else this.name = this.another();
    };
    tell("whose");
  }

  /** For as long as the tab is there. */
  private hold(): void {
    const held = this.locks?.request(`${KEY}:${this.name}`, { ifAvailable: true }, (lock) => {
      if (lock) return new Promise<void>(() => {});
      this.name = this.another();
      this.hold();
    });
    held?.catch(() => {});
  }
}
