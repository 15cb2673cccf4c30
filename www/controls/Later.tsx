import { useSignal } from "@preact/signals";
import type { FunctionComponent } from "preact";
import type { Session } from "../session";
import { en } from "../words/en";
import { fetched } from "./fetched";

type Part = FunctionComponent<{ session: Session }>;

/** A part of the page that is fetched when it is first opened. */
export function Later({ session, name, title, note, load }: Properties) {
  const part = useSignal<Part | null>(null);
  const open = useSignal(false);
  const toggle = async (details: HTMLDetailsElement) => {
    open.value = details.open;
    if (!details.open || part.value) return;
    try {
      part.value = await fetched(en.parts.named(title), load);
    } catch (error) {
      details.open = false;
      session.problem.value = error instanceof Error ? error.message : String(error);
    }
  };
  const Loaded = part.value;
  return (
    <details class={`later ${name}`} onToggle={(event) => void toggle(event.currentTarget)}>
      <summary>
        {title}
        {note && <span class="count"> {note}</span>}
      </summary>
      {open.value && (Loaded ? <Loaded session={session} /> : <p class="help">{en.parts.loading}</p>)}
    </details>
  );
}

type Properties = {
  readonly session: Session;
  readonly name: string;
  readonly title: string;
  /** Beside the title. */
  readonly note?: string;
  readonly load: () => Promise<Part>;
};
