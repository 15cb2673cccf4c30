import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { isDone } from "../phase";
import type { Session } from "../session";
import { en } from "../words/en";
import { fetched } from "./fetched";
import { guess } from "./viewing";

/** Asks where a point will go before it is shown. */
export function Guess({ session }: { session: Session }) {
  const part = useSignal<typeof import("./guessing") | null>(null);
  const end = useRef<() => void>(() => {});
  const of = session.match.value?.deformation;
  // Another match is another question.
  useEffect(() => () => end.current(), [of]);
  const ask = async () => {
    try {
      part.value ??= await fetched(en.guess.begin, () => import("./guessing"));
      end.current = part.value.ask(session);
    } catch (error) {
      session.problem.value = error instanceof Error ? error.message : String(error);
    }
  };
  const on = guess.value !== null && guess.value.of === of;
  return (
    <>
      <button type="button" disabled={!isDone(session.phase.value)} onClick={() => void ask()}>
        {on ? en.guess.another : en.guess.begin}
      </button>
      {on && (
        <button type="button" onClick={() => end.current()}>
          {en.guess.end}
        </button>
      )}
    </>
  );
}
