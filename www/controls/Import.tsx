import { useSignal } from "@preact/signals";
import type { FunctionComponent } from "preact";
import { useEffect } from "preact/hooks";
import type { Session, Side } from "../session";
import { importing, listenForImports } from "./importing";

type Dialog = FunctionComponent<{ session: Session }>;

/** Opens the import dialog for one side. */
export function ImportButton({ side }: { side: Side }) {
  return (
    <button
      type="button"
      class="quiet import-button"
      aria-label={`Import ${side}`}
      title={`Take the ${side} from a drawing, a picture, a list of points or the gallery`}
      onClick={() => {
        importing.value = { side, input: null };
      }}
    >
      <svg viewBox="0 0 16 16" aria-hidden="true">
        <path d="M8 2v8M4.5 6.8 8 10.3l3.5-3.5M2.5 11v2.5h11V11" />
      </svg>
      <span>Import</span>
    </button>
  );
}

/** The import dialog, fetched when it is first needed: readers of six formats are no part of the first load. */
export function Import({ session }: { session: Session }) {
  const dialog = useSignal<Dialog | null>(null);
  useEffect(listenForImports, []);
  const wanted = importing.value !== null;
  useEffect(() => {
    if (!wanted || dialog.value) return;
    import("./ImportDialog").then(
      (loaded) => {
        dialog.value = loaded.ImportDialog;
      },
      () => {
        importing.value = null;
        session.problem.value = "The import dialog could not be loaded; check the connection, or reload the page.";
      },
    );
  }, [wanted, session, dialog]);
  const Loaded = dialog.value;
  return wanted && Loaded ? <Loaded session={session} /> : null;
}
