import { signal } from "@preact/signals";
import type { FunctionComponent } from "preact";
import type { Session, Side } from "../session";
import { en } from "../words/en";
import { fetched } from "./fetched";

/** The surface that fills the screen. */
export const enlarged = signal<Side | null>(null);

const bar = signal<FunctionComponent<{ session: Session }> | null>(null);

/** Lets one surface fill the screen, where there is little of it. */
export function Enlarge({ session, side }: { session: Session; side: Side }) {
  const begin = async () => {
    try {
      bar.value ??= (await fetched(en.enlarge.what, () => import("./Enlarged"))).Enlarged;
      enlarged.value = side;
    } catch (error) {
      session.problem.value = error instanceof Error ? error.message : String(error);
    }
  };
  return (
    <button
      type="button"
      class="enlarge"
      aria-label={en.enlarge.begin(side)}
      title={en.enlarge.begin(side)}
      onClick={begin}
    >
      <svg viewBox="0 0 16 16" aria-hidden="true">
        <path d="M9.5 2.5h4v4M13.5 2.5l-5 5M6.5 13.5h-4v-4M2.5 13.5l5-5" />
      </svg>
    </button>
  );
}

/** What is pressed while a surface fills the screen. */
export function EnlargedBar({ session }: { session: Session }) {
  const Bar = bar.value;
  return enlarged.value && Bar && <Bar session={session} />;
}
