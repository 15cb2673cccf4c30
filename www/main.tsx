/** Wires shapes, solver and views into the page; the only file that knows all. */

import { render } from "preact";
import { Import } from "./controls/Import";
import { Later } from "./controls/Later";
import { Morph } from "./controls/Morph";
import { Presets } from "./controls/Presets";
import { ResultPanel } from "./controls/ResultPanel";
import { Save } from "./controls/Save";
import { SettingsPanel } from "./controls/SettingsPanel";
import { SketchPanel } from "./controls/SketchPanel";
import { Progress, StatusPanel } from "./controls/StatusPanel";
import { Problem, Toolbar } from "./controls/Toolbar";
import { ViewPicker } from "./controls/ViewPicker";
import { moduleAt } from "./engine";
import { Session } from "./session";
import { open, readStorage } from "./state";
import "./style.css";
import "./controls/views.css";
import solverUrl from "./wasm/thinshell_bg.wasm?url";
import SolverWorker from "./worker?worker&inline";

function App({ session }: { session: Session }) {
  return (
    <>
      <div class="sketches">
        <SketchPanel session={session} side="reference" />
        <SketchPanel session={session} side="template" />
      </div>
      <div class="actions">
        <Toolbar session={session} />
        <Problem session={session} />
      </div>
      <section class="outcome" aria-labelledby="outcome-name">
        <header>
          <h2 id="outcome-name" class="unseen">
            Match
          </h2>
          <ViewPicker session={session} />
          <Morph session={session} />
          <Save session={session} />
        </header>
        <div class="surface">
          <Progress session={session} />
          <ResultPanel session={session} />
        </div>
        <StatusPanel session={session} />
        <Later
          session={session}
          name="energies"
          title="Energies over iterations"
          load={async () => (await import("./controls/EnergyPlot")).EnergyPlot}
        />
      </section>
      <div class="choices">
        <Presets session={session} />
        <SettingsPanel session={session} />
      </div>
      <Later
        session={session}
        name="compare"
        title="Compare side by side"
        load={async () => (await import("./controls/Compare")).Compare}
      />
      <Import session={session} />
    </>
  );
}

function shortcuts(session: Session): void {
  addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
    const typing = event.target instanceof HTMLInputElement && event.target.type === "number";
    if (typing) return;
    const key = event.key.toLowerCase();
    if (key === "z" && !event.shiftKey) session.undo();
    else if ((key === "z" && event.shiftKey) || key === "y") session.redo();
    else return;
    event.preventDefault();
  });
}

function spawn(): Worker {
  return new SolverWorker({ name: "thinshell solver" });
}

const root = document.getElementById("app");
if (!root) throw new Error("index.html has no #app");
const session = new Session({ module: moduleAt(solverUrl), spawn }, open(location.hash, readStorage()));
shortcuts(session);
addEventListener("hashchange", () => session.openLink(location.hash));
root.replaceChildren();
render(<App session={session} />, root);
