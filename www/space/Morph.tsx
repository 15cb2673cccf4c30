import { MorphBar } from "../controls/MorphBar";
import type { SpaceSession } from "./session";

/** Slides between the reference and its match. */
export function Morph({ session }: { session: SpaceSession }) {
  return <MorphBar morph={session.morph} none={session.result.value === null} />;
}
