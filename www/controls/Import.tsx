import { useSignal } from "@preact/signals";
import type { FunctionComponent } from "preact";
import { useEffect } from "preact/hooks";
import type { Session, Side } from "../session";
import { en } from "../words/en";
import { fetched } from "./fetched";
import { importing } from "./imported";

type Dialog = FunctionComponent<{ session: Session }>;

/** Opens the import dialog for one side. */
export function ImportButton({ side }: { side: Side }) {
  return (
    <button
      type="button"
      class="quiet import-button"
      aria-label={en.imports.of(side)}
      title={en.imports.help(side)}
      onClick={() => {
        importing.value = { side, input: null };
      }}
    >
      <svg viewBox="0 0 16 16" aria-hidden="true">
        <path d="M8 2v8M4.5 6.8 8 10.3l3.5-3.5M2.5 11v2.5h11V11" />
      </svg>
      <span>{en.imports.name}</span>
    </button>
  );
}

/** The import dialog, fetched when it is first needed: readers of six formats are no part of the first load. */
export function Import({ session }: { session: Session }) {
  const dialog = useSignal<Dialog | null>(null);
  const wanted = importing.value !== null;
  useEffect(() => {
    if (!wanted || dialog.value) return;
    fetched(en.imports.what, () => import("./ImportDialog")).then(
      (loaded) => {
        dialog.value = loaded.ImportDialog;
      },
      (error) => {
        importing.value = null;
        session.problem.value = error.message;
      },
    );
  }, [wanted, session, dialog]);
  const Loaded = dialog.value;
  if (!wanted) return null;
  return Loaded ? (
    <Loaded session={session} />
  ) : (
    <p class="coming" aria-live="polite">
      {en.imports.loading}
    </p>
  );
}
