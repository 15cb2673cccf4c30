/** The page's side of the way to surfaces and back: what has to be there before anything of them. */

import { type Signal, signal } from "@preact/signals";
import { fetched } from "../controls/fetched";
import { way } from "../words/way";

type Shown = Awaited<ReturnType<typeof import("./index").open>>;

/** Surfaces instead of curves, while they are shown. */
export const space = signal<Shown | null>(null);

/** Whether an address is of surfaces. */
export const isSpace = (hash: string) => /^#(.*&)?space=/.test(hash);

/** Shows surfaces: what the address says of them, or what was there. `leave` brings back the curves. */
export async function enter(problem: Signal<string | null>, leave: () => void): Promise<void> {
  try {
    const { open } = await fetched(way.part, () => import("./index"));
    space.value = await open(location.hash, () => {
      space.value = null;
      leave();
    });
  } catch (error) {
    problem.value = (error as Error).message;
  }
}
