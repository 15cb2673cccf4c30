import type { Signal } from "@preact/signals";
import { Morph } from "../controls/Morph";
import { Pair } from "../controls/Pair";
import { ResultPanel } from "../controls/ResultPanel";
import { Setting } from "../controls/SettingsPanel";
import { SketchPanel } from "../controls/SketchPanel";
import { SketchTools } from "../controls/SketchTools";
import { Progress, StatusPanel } from "../controls/StatusPanel";
import { Terms } from "../controls/Terms";
import { Problem } from "../controls/Toolbar";
import { ViewPicker } from "../controls/ViewPicker";
import { isPaused, isWorking } from "../phase";
import type { Session } from "../session";
import { space } from "../space/way";
import { embed as say } from "../words/embed";
import { en } from "../words/en";
import type { Asked, Control } from "./asked";
import type { Scene } from "./scene";

type Properties = { readonly session: Session; readonly asked: Asked; readonly scene: Scene };

/** The page in another one: as much of it as its address asks for, within the frame. */
export function Frame({ session, asked, scene }: Properties) {
  if (space.value) return <space.value.View />;
  const { kind, controls, sliders } = asked;
  const has = (name: Control) => controls.has(name);
  return (
    <div class={has("numbers") ? "frame numbers" : "frame"}>
      {kind === "full" && (
        <div class="sketches">
          {has("match") && <SketchTools session={session} />}
          <SketchPanel session={session} side="reference" />
          <SketchPanel session={session} side="template" />
        </div>
      )}
      <Problem session={session} />
      <section class="picture" aria-label={en.result.title}>
        {kind === "compare" ? <Both session={session} scene={scene} /> : <One session={session} />}
      </section>
      <div class="beside">
        {(has("match") || has("view") || has("link")) && (
          <div class="group">
            {has("match") && <Actions session={session} scene={scene} />}
            {has("view") && <ViewPicker session={session} />}
            {has("link") && <Open session={session} />}
          </div>
        )}
        {has("morph") && (kind === "compare" ? <BothMorph morph={session.morph} /> : <Morph session={session} />)}
        {kind !== "compare" && <StatusPanel session={session} />}
        {has("terms") && kind !== "compare" && <Terms session={session} />}
        {sliders.length > 0 && (
          <div class="groups">
            {sliders.map((field) => (
              <Setting key={field.name} session={session} field={field} />
            ))}
          </div>
        )}
      </div>
    </div>
  );
}

function One({ session }: { session: Session }) {
  return (
    <div class="surface">
      <Progress session={session} />
      <ResultPanel session={session} />
    </div>
  );
}

const SIDES = ["A", "B"] as const;

function Both({ session, scene }: Omit<Properties, "asked">) {
  const { comparison } = scene;
  if (!comparison) return null;
  const [a, b] = comparison.outcomes.value;
  if (a || b) return <Pair session={session} outcomes={comparison.outcomes} names={SIDES} />;
  return (
    <p role="status">
      {comparison.busy.value ? (
        en.status.matching
      ) : (
        <button type="button" class="primary" onClick={scene.start}>
          {say.compare}
        </button>
      )}
    </p>
  );
}

function BothMorph({ morph }: { morph: Signal<number> }) {
  const percent = Math.round(100 * morph.value);
  return (
    <label class="way">
      {en.morph.name}
      <input
        type="range"
        min={0}
        max={100}
        value={percent}
        aria-valuetext={en.morph.part(percent)}
        onInput={(event) => {
          morph.value = event.currentTarget.valueAsNumber / 100;
        }}
      />
    </label>
  );
}

/** What is pressed most; all the rest is in the page. */
function Actions({ session, scene }: Omit<Properties, "asked">) {
  const { actions } = en;
  if (scene.comparison)
    return (
      <button type="button" class="primary" onClick={scene.start}>
        {say.compare}
      </button>
    );
  const working = isWorking(session.phase.value);
  const paused = isPaused(session.phase.value);
  return (
    <>
      {working ? (
        <button type="button" class="primary" onClick={() => (paused ? session.resume() : session.pause())}>
          {paused ? actions.resume : actions.pause}
        </button>
      ) : (
        <button type="button" class="primary" onClick={() => session.start()}>
          {actions.match}
        </button>
      )}
      <button
        type="button"
        class="switch"
        role="switch"
        aria-checked={session.live.value}
        title={actions.liveHelp}
        onClick={() => session.setLive(!session.live.value)}
      >
        {actions.live}
      </button>
      <button type="button" disabled={!session.canUndo.value} onClick={() => session.undo()}>
        {actions.undo}
      </button>
    </>
  );
}

function Open({ session }: { session: Session }) {
  // What was asked of the frame is not asked of the page.
  const url = new URL(location.pathname, location.href);
  url.hash = session.link();
  return (
    <a class="as-button open" href={url.href} target="_blank" rel="noopener" title={`${say.open}: ${say.openHelp}`}>
      <span class="unseen">{say.open}</span>
      <svg viewBox="0 0 16 16" aria-hidden="true">
        <path d="M9.5 2.5h4v4M13.5 2.5 7 9M12.5 9.5v4h-10v-10h4" />
      </svg>
    </a>
  );
}
