import type { Session } from "../session";
import type { Shape } from "../shapes/geometry";
import { PRESETS } from "../shapes/presets";
import { hands } from "../tools/tool";
import { en } from "../words/en";
import { way } from "../words/way";
import { importing } from "./imported";
import { reveal } from "./Stage";

/** Examples that start with one click. */
export function Presets({ session, onSurfaces }: { session: Session; onSurfaces: () => void }) {
  const chosen = session.preset.value;
  return (
    <section class="presets" aria-labelledby="presets-name">
      <header>
        <h2 id="presets-name">{en.examples.title}</h2>
        <button type="button" class="quiet" title={way.help} onClick={onSurfaces}>
          {way.enter}
        </button>
        <button
          type="button"
          class="quiet"
          title={hands.value?.hint("gallery")}
          onClick={() => {
            importing.value = { side: "reference", input: null, gallery: true };
          }}
        >
          {en.examples.gallery}
        </button>
      </header>
      <ul>
        {PRESETS.map((preset) => (
          <li key={preset.id}>
            <button
              type="button"
              title={preset.title}
              aria-label={preset.title}
              aria-pressed={preset.id === chosen}
              onClick={() => {
                session.choosePreset(preset);
                reveal();
              }}
            >
              <svg viewBox="0 0 1.46 0.76" aria-hidden="true">
                <path class="reference" d={path(preset.reference, -0.12)} />
                <path class="template" d={path(preset.template, 0.58)} />
              </svg>
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}

/** Every second point is plenty at this size. */
function path(shape: Shape, right: number): string {
  return shape
    .map((loop) => {
      let text = "";
      for (let i = 0; i < loop.length; i += 4) {
        text += `${i === 0 ? "M" : "L"}${(loop[i] + right).toFixed(3)} ${(0.88 - loop[i + 1]).toFixed(3)}`;
      }
      return `${text}Z`;
    })
    .join("");
}
