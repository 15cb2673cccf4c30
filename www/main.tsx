/** Wires shapes, solver and views into the page; the only file that knows all. */

import { signal } from "@preact/signals";
import { type FunctionComponent, render } from "preact";
import { EnlargedBar } from "./controls/Enlarge";
import { ForcesSwitch } from "./controls/ForcesSwitch";
import { Guess } from "./controls/Guess";
import { Import } from "./controls/Import";
import { Later } from "./controls/Later";
import { begin, readFile } from "./controls/language";
import { Morph } from "./controls/Morph";
import { Presets } from "./controls/Presets";
import { ResultPanel } from "./controls/ResultPanel";
import { SketchPanel } from "./controls/SketchPanel";
import { SketchTools } from "./controls/SketchTools";
import { Stage } from "./controls/Stage";
import { Caption, Progress, StatusPanel, said } from "./controls/StatusPanel";
import { Terms } from "./controls/Terms";
import { Problem, Toolbar } from "./controls/Toolbar";
import { ViewPicker } from "./controls/ViewPicker";
import { choose, fetchLocal, past, view } from "./controls/viewing";
import { type Engine, moduleAt } from "./engine";
import { open } from "./link/open";
import { Memory } from "./memory/memory";
import { whenIdle } from "./offline/idle";
import { Session } from "./session";
import { changedFields } from "./settings";
import { enter, isSpace, space } from "./space/way";
import { fetchKit } from "./tools/kit";
import { fetchHands, hands } from "./tools/tool";
import "./style.css";
import solverUrl from "./wasm/thinshell_bg.wasm?url";
import { en } from "./words/en";
import { memory as memoryWords } from "./words/memory";
import SolverWorker from "./worker?worker&inline";

/** Says that there is a new version of the page, once it is there itself. */
const news = signal<FunctionComponent | null>(null);

function App({ session, onSurfaces }: { session: Session; onSurfaces: () => void }) {
  if (space.value) return <space.value.View />;
  // Comes with what draws.
  const { Present, Save } = hands.value ?? {};
  return (
    <>
      <div class="sketches">
        <SketchTools session={session} />
        <SketchPanel session={session} side="reference" />
        <SketchPanel session={session} side="template" />
        <EnlargedBar session={session} />
      </div>
      <div class="actions">
        <Toolbar session={session} />
        <Problem session={session} />
        {news.value && <news.value />}
      </div>
      <section class="outcome" aria-labelledby="outcome-name">
        <div class="sight">
          <header>
            <h2 id="outcome-name" class="unseen">
              {en.result.title}
            </h2>
            <ViewPicker session={session} />
            {Present && <Present session={session} />}
            {Save && <Save session={session} />}
          </header>
          <Stage said={() => past.value?.words ?? said(session)}>
            <Progress session={session} />
            <ResultPanel session={session} />
          </Stage>
          <Morph session={session} />
        </div>
        <StatusPanel session={session} />
        <Terms session={session} />
        <div class="extras">
          <ForcesSwitch session={session} />
          <Guess session={session} />
        </div>
        <Caption session={session} />
      </section>
      <div class="choices">
        <Presets session={session} onSurfaces={onSurfaces} />
        <Settings session={session} />
        <Later
          session={session}
          name="energies"
          title={en.parts.energies}
          load={async () => (await import("./controls/EnergyPlot")).EnergyPlot}
        />
        <Later
          session={session}
          name="runs"
          title={en.parts.runs}
          load={async () => (await import("./controls/Earlier")).Earlier}
        />
        <Later
          session={session}
          name="compare"
          title={en.parts.compare}
          load={async () => (await import("./controls/Compare")).Compare}
        />
        <Later
          session={session}
          name="recent"
          title={memoryWords.title}
          load={async () => (await import("./controls/Recent")).Recent}
        />
      </div>
      <Import session={session} />
    </>
  );
}

function Settings({ session }: { session: Session }) {
  const changed = changedFields(session.settings.value).length;
  return (
    <Later
      session={session}
      name="settings"
      title={en.parts.settings}
      note={changed > 0 ? en.parts.changed(changed) : ""}
      load={async () => (await import("./controls/SettingsPanel")).SettingsPanel}
    />
  );
}

function shortcuts(session: Session): void {
  addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
    const typing = event.target instanceof HTMLInputElement && event.target.type === "number";
    if (typing) return;
    const key = event.key.toLowerCase();
    const shown = space.value ?? session;
    if (key === "z" && !event.shiftKey) shown.undo();
    else if ((key === "z" && event.shiftKey) || key === "y") shown.redo();
    else return;
    event.preventDefault();
  });
}

function spawn(): Worker {
  return new SolverWorker({ name: "thinshell solver" });
}

const engine: Engine = {
  module: moduleAt(solverUrl),
  spawn,
  // From 513 × 513 on a card may be faster.
  card: (settings) =>
    settings.backend === "gpu" || (settings.backend !== "cpu" && (settings.finest ?? 0) > 8)
      ? import("./card/choice").then(({ engineFor }) => engineFor(settings, "plane", engine))
      : undefined,
};

/** Within another page. */
const isEmbedded = new URLSearchParams(location.search).has("embed");

/** Opens what the address holds, in the language wished for if it came. */
function start(root: HTMLElement, isSpoken: boolean): void {
  const memory = new Memory();
  const isInSpace = isSpace(location.hash);
  // Then the address is not the curves'.
  const opened = isInSpace
    ? { ...open({ hash: "", search: location.search }, memory.found), unwritten: false, later: true }
    : open(location, memory.found);
  if (opened.unread) memory.setAside();
  const session = new Session(engine, opened, { view, choose }, memory);
  if (!opened.later) session.glance();
  const refuse = () => {
    session.problem.value = en.missing.sentence(en.missing.language);
  };
  if (!isSpoken) refuse();
  // Surfaces in place of curves; the way back finds the curves as they were.
  const enterSpace = () =>
    void enter(session.problem, () => {
      memory.remember(session.link());
      if (!session.match.value) session.glance();
    });
  shortcuts(session);
  addEventListener("hashchange", () => {
    if (isSpace(location.hash)) return enterSpace();
    space.value?.hide();
    space.value = null;
    session.openLink(location.hash);
  });
  if (isInSpace) enterSpace();
  root.replaceChildren();
  render(<App session={session} onSurfaces={enterSpace} />, root);
  coming.then(
    ({ announceChanges, listenForImports, listenForLanguage }) => {
      announceChanges(session);
      listenForImports();
      listenForLanguage(refuse);
    },
    (problem: Error) => {
      session.problem.value = problem.message;
    },
  );
}

function embedded(root: HTMLElement): Promise<void> {
  return import("./embed").then(
    ({ embed }) => embed(root, engine),
    () => {
      root.textContent = en.missing.sentence(en.missing.view);
      root.setAttribute("role", "alert");
    },
  );
}

const root = document.getElementById("app");
if (!root) throw new Error("index.html has no #app");
readFile("indexFile", "h1, .promise, #method h2, #method p, footer p");
// On its way while the page is drawn, which does not wait for it.
const coming = fetchHands();
const show = (isSpoken: boolean) => (isEmbedded ? embedded(root) : start(root, isSpoken));
begin().then(
  () => show(true),
  () => show(false),
);
whenIdle(async () => {
  // A pointer over the result, or a first stroke, will want these. Where they do not come now, they are asked for again
  // then, and their absence is told.
  await Promise.allSettled([fetchLocal(), fetchKit()]);
  // While developing, nothing is to come from yesterday; and a frame keeps nothing.
  if (!import.meta.env.PROD || isEmbedded) return;
  // Without the network on a first visit there is nothing to keep.
  const part = await import("./controls/Update").catch(() => null);
  news.value = part?.Update ?? null;
  await part?.keepOffline();
});
