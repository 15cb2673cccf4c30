import { useComputed, useSignal, useSignalEffect } from "@preact/signals";
import type { Session } from "../session";
import { matchOf } from "../view/result";
import { en } from "../words/en";
import { fetched } from "./fetched";
import { MorphBar } from "./MorphBar";

/** Slides between the identity and the match; see view/morph.ts for the way between them. */
export function Morph({ session }: { session: Session }) {
  return (
    <MorphBar morph={session.morph} none={session.match.value === null}>
      <Folds session={session} />
    </MorphBar>
  );
}

/** Where the plane folds on its way, that is said: the match itself never does. */
function Folds({ session }: { session: Session }) {
  // Looked for only when somebody leaves the match's end of the way.
  const away = useComputed(() => session.morph.value < 1);
  const foldOf = useSignal<typeof import("../view/fold").foldOf | null>(null);
  useSignalEffect(() => {
    if (!away.value || foldOf.peek()) return;
    fetched(en.morph.what, () => import("../view/fold")).then(
      (part) => {
        foldOf.value = part.foldOf;
      },
      (problem: Error) => {
        session.problem.value = problem.message;
      },
    );
  });
  const fold = useComputed(() => {
    const frame = away.value ? session.match.value : null;
    return frame && foldOf.value?.(matchOf(frame));
  });
  if (!fold.value) return null;
  const [first, last] = fold.value.map((part) => Math.round(100 * part));
  return <p class="folds">{en.morph.folds(first, last)}</p>;
}
