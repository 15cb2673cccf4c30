import { space as say } from "../words/space";
import { Slide } from "./Slide";
import type { SpaceSession } from "./session";

export function Morph({ session }: { session: SpaceSession }) {
  const percent = Math.round(100 * session.morph.value);
  return (
    <div class="morph">
      <Slide
        name={say.morph}
        value={session.morph.value}
        text={say.morphPart(percent)}
        disabled={session.result.value === null}
        change={(value) => {
          session.morph.value = value;
        }}
      />
    </div>
  );
}
