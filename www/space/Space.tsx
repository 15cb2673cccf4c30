import { signal, useComputed } from "@preact/signals";
import { useRef } from "preact/hooks";
import { adopt } from "../controls/adopt";
import legendStyle from "../controls/legend.css?inline";
import { ScaleBar } from "../controls/ScaleBar";
import { Stage as Place } from "../controls/Stage";
import { useDark } from "../controls/useDark";
import { space as say } from "../words/space";
import { Actions } from "./Actions";
import { useDrops, useTitle } from "./document";
import { Examples } from "./Examples";
import { LevelChoice, PlaneChoice, ViewPicker } from "./Looks";
import { Morph } from "./Morph";
import { PinGuide } from "./Pins";
import { Problem, Spoken } from "./Said";
import { Save } from "./Save";
import { SettingsPanel } from "./SettingsPanel";
import { SolidCanvas } from "./SolidCanvas";
import { Source } from "./Source";
import { headline, Progress, resultState, Status } from "./Status";
import { type Paint, referenceScene, resultScene, scaleOf, templateScene } from "./scenes";
import { SIDES, type SpaceSession } from "./session";
import style from "./space.css?inline";
import type { Stage } from "./stage";
import type { Ways } from "./ways";

adopt(legendStyle);
adopt(style);

/** What is drawn is not on its way to anywhere. */
const STILL = signal(0);

type Properties = { readonly session: SpaceSession; readonly ways: Ways };

/** The page while it is about surfaces: the same places as for curves. */
export function Space({ session, ways }: Properties) {
  const dark = useDark();
  const moving = useComputed(() => !session.result.value?.frame.status.finished);
  const scale = useComputed(() => scaleOf(session.shown.value, session.view.value, dark.value, moving.value));
  const paint = useComputed<Paint>(() => ({
    result: session.shown.value,
    view: session.view.value,
    plane: session.plane.value,
    scale: scale.value,
    dark: dark.value,
    showsTarget: session.showsTarget.value,
  }));
  const scenes = {
    reference: useComputed(() => referenceScene(session.step.value.reference, paint.value)),
    template: useComputed(() => templateScene(session.step.value.template, paint.value)),
  };
  const result = useComputed(() => {
    const { reference, template } = session.step.value;
    return resultScene(reference, template, paint.value);
  });
  const stage = useRef<Stage | null>(null);
  const staged = useRef((made: Stage | null) => {
    stage.current = made;
  }).current;
  useDrops(ways);
  useTitle();
  return (
    <>
      <div class="sketches">
        <div class="sketch-tools space-ways">
          <button type="button" onClick={ways.leave}>
            {say.leave}
          </button>
        </div>
        {SIDES.map((side) => (
          <section key={side} class="sketch" aria-labelledby={`${side}-name`}>
            <header>
              <h2 id={`${side}-name`} class={side}>
                {say.sides[side]}
              </h2>
              <Source session={session} ways={ways} side={side} />
            </header>
            <div class="surface">
              <SolidCanvas
                session={session}
                scene={scenes[side]}
                morph={STILL}
                role="application"
                label={say.surface[side]}
                shown={side}
                id={`${side}-surface`}
              />
            </div>
          </section>
        ))}
      </div>
      <div class="actions">
        <Actions session={session} ways={ways} />
        <Problem session={session} />
        <PinGuide session={session} />
        <p id="space-keys" class="help">
          {say.keys}
        </p>
        <Spoken session={session} />
      </div>
      <section class="outcome" aria-labelledby="outcome-name">
        <div class="sight">
          <header>
            <h2 id="outcome-name" class="unseen">
              {say.actions.match}
            </h2>
            <ViewPicker session={session} />
            <Save session={session} stage={stage} scene={result} />
          </header>
          <Place said={() => headline(session)}>
            <Progress session={session} />
            <div class={session.stale.value ? "shown stale" : "shown"}>
              <SolidCanvas
                session={session}
                scene={result}
                morph={session.morph}
                role="img"
                label={`${say.result}: ${resultState(session)}`}
                shown="result"
                id="result-surface"
                staged={staged}
              />
              {scale.value && (
                <figure class="legend" aria-label={say.legend}>
                  <ScaleBar scale={scale.value} />
                </figure>
              )}
            </div>
          </Place>
          {session.view.value === "slice" && <PlaneChoice session={session} />}
          <LevelChoice session={session} />
          <Morph session={session} />
        </div>
        <Status session={session} />
        <p id="view-caption" class="caption">
          {say.captions[session.view.value]} {!session.result.value && say.waiting}
        </p>
      </section>
      <div class="choices">
        <Examples session={session} />
        <SettingsPanel session={session} />
      </div>
    </>
  );
}
