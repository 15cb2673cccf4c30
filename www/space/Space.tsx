import { signal, useComputed, useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { adopt } from "../controls/adopt";
import legendStyle from "../controls/legend.css?inline";
import { Menu } from "../controls/Menu";
import settingsStyle from "../controls/settings.css?inline";
import { download } from "../export/download";
import { isPaused, isWorking } from "../phase";
import { parseSetting, type SettingField } from "../settings";
import { css, type Scale } from "../view/scales";
import { helps } from "../words/helps";
import { language } from "../words/language";
import { space as say } from "../words/space";
import { START, spoken } from "./camera";
import { json, ply } from "./export";
import { ACCEPTED } from "./files";
import { PAIRS, SURFACES, surface } from "./gallery";
import { SolidCanvas } from "./SolidCanvas";
import { Progress, resultState, Status } from "./Status";
import { type Paint, referenceScene, resultScene, scaleOf, templateScene } from "./scenes";
import { SIDES, type Side, type SpaceSession, VIEWS, type View } from "./session";
import { SPACE_FIELDS } from "./settings";
import style from "./space.css?inline";
import type { Stage } from "./stage";

adopt(legendStyle);
adopt(settingsStyle);
adopt(style);

export type Ways = {
  readonly leave: () => void;
  /** Takes a file for a side. */
  readonly take: (side: Side, file: File) => Promise<void>;
  readonly address: () => string;
};

/** What is drawn is not on its way to anywhere. */
const STILL = signal(0);

type Properties = { readonly session: SpaceSession; readonly ways: Ways };

/** The page while it is about surfaces: the same places as for curves. */
export function Space({ session, ways }: Properties) {
  const dark = useDark();
  const scale = useComputed(() => scaleOf(session.result.value, session.view.value, dark.value));
  const paint = useComputed<Paint>(() => ({
    result: session.result.value,
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
                id={`${side}-surface`}
              />
            </div>
          </section>
        ))}
      </div>
      <div class="actions">
        <Actions session={session} ways={ways} />
        <Problem session={session} />
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
            <Save session={session} stage={stage} />
          </header>
          <div class="stage">
            <div class="surface">
              <Progress session={session} />
              <div class={session.stale.value ? "shown stale" : "shown"}>
                <SolidCanvas
                  session={session}
                  scene={result}
                  morph={session.morph}
                  role="img"
                  label={`${say.result}: ${resultState(session)}`}
                  id="result-surface"
                  staged={staged}
                />
                {scale.value && <ScaleBar scale={scale.value} />}
              </div>
            </div>
          </div>
          {session.view.value === "slice" && <PlaneChoice session={session} />}
          <Morph session={session} />
        </div>
        <Status session={session} />
        <p id="view-caption" class="caption">
          {say.captions[session.view.value]} {!session.result.value && say.waiting}
        </p>
      </section>
      <div class="choices">
        <Examples session={session} />
        <Settings session={session} />
      </div>
    </>
  );
}

/** The gallery of one side, and files. */
function Source({ session, ways, side }: Properties & { side: Side }) {
  const solid = session.step.value[side];
  return (
    <div class="source">
      <select
        aria-label={say.choose(side)}
        value={solid.id}
        onChange={(event) => {
          const chosen = surface(event.currentTarget.value);
          if (chosen) session.commit({ [side]: chosen });
        }}
      >
        {!surface(solid.id) && <option value={solid.id}>{solid.name}</option>}
        {SURFACES.map(({ id, name }) => (
          <option key={id} value={id}>
            {name}
          </option>
        ))}
      </select>
      <label class="as-button">
        {say.file}
        <input
          type="file"
          class="unseen"
          accept={ACCEPTED}
          aria-label={say.open(side)}
          onChange={(event) => {
            const [file] = event.currentTarget.files ?? [];
            if (file) void ways.take(side, file);
            // The same file may be chosen again.
            event.currentTarget.value = "";
          }}
        />
      </label>
    </div>
  );
}

function Actions({ session, ways }: Properties) {
  const phase = session.phase.value;
  const [working, paused] = [isWorking(phase), isPaused(phase)];
  const { actions } = say;
  const { reference, template } = session.step.value;
  return (
    <div class="toolbar">
      <div class="group">
        <button type="button" class="primary" onClick={() => session.start()}>
          {actions.match}
        </button>
        <button type="button" disabled={!working} onClick={() => (paused ? session.resume() : session.pause())}>
          {paused ? actions.resume : actions.pause}
        </button>
        <button type="button" disabled={!working} onClick={() => session.cancel()}>
          {actions.cancel}
        </button>
      </div>
      <div class="group">
        <button type="button" disabled={!session.canUndo.value} onClick={() => session.undo()}>
          {actions.undo}
        </button>
        <button type="button" disabled={!session.canRedo.value} onClick={() => session.redo()}>
          {actions.redo}
        </button>
        <button
          type="button"
          title={actions.swapHelp}
          onClick={() => session.commit({ reference: template, template: reference })}
        >
          {actions.swap}
        </button>
        <button
          type="button"
          disabled={session.pose.value === START}
          onClick={() => {
            session.pose.value = START;
          }}
        >
          {actions.camera}
        </button>
        <CopyLink ways={ways} />
      </div>
    </div>
  );
}

function CopyLink({ ways }: { ways: Ways }) {
  const said = useSignal<string>(say.actions.link);
  const copy = async () => {
    const address = ways.address();
    try {
      await navigator.clipboard.writeText(address);
      said.value = say.actions.copied;
    } catch {
      // Not allowed here: the address bar holds the same link.
      said.value = say.actions.address;
    }
    setTimeout(() => {
      said.value = say.actions.link;
    }, 1600);
  };
  return (
    <button type="button" title={say.actions.linkHelp} onClick={copy}>
      {said}
    </button>
  );
}

function Problem({ session }: { session: SpaceSession }) {
  const text = session.problem.value;
  return (
    <div role="alert">
      {text && (
        <div class="problem">
          <p class="text">{text}</p>
          <button
            type="button"
            class="quiet"
            onClick={() => {
              session.problem.value = null;
            }}
          >
            {say.actions.dismiss}
          </button>
        </div>
      )}
    </div>
  );
}

/** What the camera sees, a moment after it has come to rest. */
function Spoken({ session }: { session: SpaceSession }) {
  const said = useSignal("");
  const pose = session.pose.value;
  useEffect(() => {
    const timer = setTimeout(() => {
      said.value = pose === START && said.peek() === "" ? "" : spoken(pose);
    }, 250);
    return () => clearTimeout(timer);
  }, [pose, said]);
  return (
    <p class="unseen" aria-live="polite" id="space-pose">
      {said}
    </p>
  );
}

function ViewPicker({ session }: { session: SpaceSession }) {
  return (
    <>
      <select
        class="view-picker"
        aria-label={say.view}
        aria-describedby="view-caption"
        value={session.view.value}
        onChange={(event) => {
          session.view.value = event.currentTarget.value as View;
        }}
      >
        {VIEWS.map((view) => (
          <option key={view} value={view}>
            {say.views[view]}
          </option>
        ))}
      </select>
      <label class="target">
        <input
          type="checkbox"
          checked={session.showsTarget.value}
          onChange={(event) => {
            session.showsTarget.value = event.currentTarget.checked;
          }}
        />
        {say.target}
      </label>
    </>
  );
}

function PlaneChoice({ session }: { session: SpaceSession }) {
  const { axis, part } = session.plane.value;
  return (
    <div class="morph plane">
      <select
        aria-label={say.plane}
        value={String(axis)}
        onChange={(event) => {
          session.plane.value = { axis: Number(event.currentTarget.value), part };
        }}
      >
        {say.axes.map((name, k) => (
          <option key={name} value={String(k)}>
            {say.plane} {name}
          </option>
        ))}
      </select>
      <Slide
        name={say.at}
        value={part}
        text={say.percent(part)}
        change={(value) => {
          session.plane.value = { axis, part: value };
        }}
      />
    </div>
  );
}

function Morph({ session }: { session: SpaceSession }) {
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

type Slid = {
  readonly name: string;
  readonly value: number;
  readonly text: string;
  readonly disabled?: boolean;
  readonly change: (value: number) => void;
};

function Slide({ name, value, text, disabled = false, change }: Slid) {
  return (
    <label class="way">
      <span>{name}</span>
      <input
        type="range"
        aria-label={name}
        min={0}
        max={100}
        value={Math.round(100 * value)}
        disabled={disabled}
        aria-valuetext={text}
        onInput={(event) => change(event.currentTarget.valueAsNumber / 100)}
      />
      <span class="percent">{Math.round(100 * value)} %</span>
    </label>
  );
}

function ScaleBar({ scale }: { scale: Scale }) {
  const last = scale.colours.length - 1;
  const stops = Array.from({ length: 17 }, (_, i) => css(scale.colours[Math.round((i / 16) * last)]));
  return (
    <figure class="legend" aria-label={say.legend}>
      <div class="bar" style={{ background: `linear-gradient(to right, ${stops.join(", ")})` }} />
      <ol class="ticks">
        {scale.ticks.map(({ part, text }) => (
          <li key={part} style={{ insetInlineStart: `${100 * part}%` }}>
            {text}
          </li>
        ))}
      </ol>
      <figcaption>
        {scale.title}
        {scale.unit && <span class="unit">{scale.unit}</span>}
      </figcaption>
    </figure>
  );
}

/** Pixels a side: 20 cm at 300 dots per inch. */
const PRINT_SIDE = 2400;

type Format = keyof typeof say.formats;

function Save({ session, stage }: { session: SpaceSession; stage: { readonly current: Stage | null } }) {
  const save = async (format: Format) => {
    try {
      const result = session.result.peek();
      const match = result?.frame.status.finished ? result : null;
      if (format === "ply" && !match) throw new Error(say.noMatch);
      const name = `thinshell-surfaces.${format}`;
      if (format === "png") {
        if (!stage.current) throw new Error(say.noWebGl);
        download({ blob: await stage.current.picture(session.pose.peek(), session.morph.peek(), PRINT_SIDE), name });
      } else {
        const text = format === "ply" && match ? ply(match) : json(session.step.peek(), match);
        download({ blob: new Blob([text], { type: "application/octet-stream" }), name });
      }
    } catch (error) {
      session.problem.value = say.notSaved(say.formats[format], error instanceof Error ? error.message : String(error));
    }
  };
  const matched = session.result.value?.frame.status.finished === true;
  return (
    <Menu kind="save" label={say.save}>
      {(Object.keys(say.formats) as Format[]).map((format) => (
        <li key={format}>
          <button type="button" disabled={format === "ply" && !matched} onClick={() => void save(format)}>
            {say.formats[format]}
          </button>
        </li>
      ))}
    </Menu>
  );
}

function Examples({ session }: { session: SpaceSession }) {
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
              {pair.name}
            </button>
          </li>
        ))}
      </ul>
    </section>
  );
}

function Settings({ session }: { session: SpaceSession }) {
  const { settings } = session.step.value;
  const count = SPACE_FIELDS.filter(({ name }) => settings[name] !== undefined).length;
  return (
    <details class="later settings">
      <summary>
        {say.settings}
        <span class="count">{say.changed(count)}</span>
      </summary>
      <fieldset>
        <legend class="unseen">{say.settings}</legend>
        {SPACE_FIELDS.map((field) => (
          <Field key={field.name} session={session} field={field} />
        ))}
      </fieldset>
      <button type="button" disabled={count === 0} onClick={() => session.commit({ settings: {} })}>
        {say.reset}
      </button>
    </details>
  );
}

function Field({ session, field }: { session: SpaceSession; field: SettingField }) {
  const problem = useSignal<string | null>(null);
  const value = String(session.step.value.settings[field.name] ?? field.initial);
  const id = `setting-${field.name}`;
  const change = (text: string) => {
    try {
      session.changeSetting(field, parseSetting(field, text));
      problem.value = null;
    } catch (error) {
      problem.value = error instanceof Error ? error.message : String(error);
    }
  };
  return (
    <div class="field">
      <label for={id}>{field.label}</label>
      {field.kind === "choice" ? (
        <select
          id={id}
          value={value}
          aria-describedby={`${id}-help`}
          onChange={(event) => change(event.currentTarget.value)}
        >
          {field.options.map((option) => (
            <option key={String(option.value)} value={String(option.value)}>
              {option.label}
            </option>
          ))}
        </select>
      ) : (
        <span class="number">
          <input
            id={id}
            type="number"
            inputMode="decimal"
            min={field.least}
            max={field.most}
            step="any"
            value={value}
            aria-describedby={`${id}-help`}
            aria-invalid={problem.value !== null}
            onChange={(event) => change(event.currentTarget.value)}
          />
          {field.unit && <span class="unit">{field.unit}</span>}
        </span>
      )}
      <p id={`${id}-help`} class={problem.value ? "help wrong" : "help"}>
        {problem.value ?? (field.name === "finest" ? say.finestHelp : helps[field.name])}
      </p>
    </div>
  );
}

/** Files dropped anywhere: onto the template for it, else for the reference. */
function useDrops(ways: Ways): void {
  useEffect(() => {
    const over = (event: DragEvent) => {
      if (!event.dataTransfer?.types.includes("Files")) return;
      event.preventDefault();
      document.documentElement.toggleAttribute("data-dropping", true);
    };
    const end = () => document.documentElement.toggleAttribute("data-dropping", false);
    const drop = (event: DragEvent) => {
      end();
      const [file] = event.dataTransfer?.files ?? [];
      if (!file) return;
      event.preventDefault();
      const section = event.target instanceof Element ? event.target.closest(".sketch") : null;
      void ways.take(section?.querySelector("#template-surface") ? "template" : "reference", file);
    };
    addEventListener("dragover", over);
    addEventListener("dragleave", end);
    addEventListener("drop", drop);
    return () => {
      end();
      removeEventListener("dragover", over);
      removeEventListener("dragleave", end);
      removeEventListener("drop", drop);
    };
  }, [ways]);
}

/** The page says what it is about; what explains curves goes. */
function useTitle(): void {
  const spoken = language.value;
  useEffect(() => {
    const root = document.documentElement;
    const texts = { title: say.document, h1: say.title, ".promise": say.promise };
    const back = Object.entries(texts).map(([place, text]) => inPlaceOf(document.querySelector(place), text));
    root.toggleAttribute("data-space", true);
    return () => {
      for (const bring of back) bring();
      root.toggleAttribute("data-space", false);
    };
  }, [spoken]);
}

/** Another element, for the sentences of the first change with the language. Returns how to bring it back. */
function inPlaceOf(element: Element | null, text: string): () => void {
  const other = element?.cloneNode() as Element | undefined;
  if (!element || !other) return () => {};
  other.textContent = text;
  element.replaceWith(other);
  return () => other.replaceWith(element);
}

function useDark() {
  const dark = useSignal(matchMedia("(prefers-color-scheme: dark)").matches);
  useEffect(() => {
    const query = matchMedia("(prefers-color-scheme: dark)");
    const change = () => {
      dark.value = query.matches;
    };
    query.addEventListener("change", change);
    return () => query.removeEventListener("change", change);
  }, [dark]);
  return dark;
}
