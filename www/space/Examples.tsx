import { space as say } from "../words/space";
import { PAIRS, surface } from "./gallery";
import type { SpaceSession } from "./session";
import { Thumb } from "./Thumb";

export function Examples({ session }: { session: SpaceSession }) {
  const { reference, template } = session.step.value;
  return (
    <section class="presets" aria-labelledby="presets-name">
      <header>
        <h2 id="presets-name">{say.examples}</h2>
      </header>
      <ul class="pairs">
        {PAIRS.map((pair) => (
          <li key={pair.name}>
            <button
              type="button"
              aria-pressed={pair.reference === reference.id && pair.template === template.id}
              onClick={() => {
                const [from, to] = [surface(pair.reference), surface(pair.template)];
                if (!from || !to) return;
                session.commit({ reference: from, template: to });
                session.start();
              }}
            >
              <span class="thumbs" aria-hidden="true">
                <Thumb id={pair.reference} />
                <Thumb id={pair.template} />
              </span>
              {pair.name}
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}
