/** The page of the paper's experiments: what each is, and its outcome computed live. */

import { render } from "preact";
import paper from "../../docs/paper.md?raw";
import surfaces from "../../docs/surfaces.md?raw";
import { listenForLanguage, sayAbove } from "../controls/changeLanguage";
import { begin, readFile } from "../controls/language";
import { type Engine, moduleAt } from "../engine";
import solverUrl from "../wasm/thinshell_bg.wasm?url";
import solidSolverUrl from "../wasm-solid/thinshell_bg.wasm?url";
import { experiments as say } from "../words/experiments";
import { page } from "../words/language";
import { written } from "../words/numbers";
import { type Block, INDEX, type Study, seconds } from "./experiment";
import { EXPERIMENTS } from "./index";
import { linkTo } from "./link";
import { readDocument } from "./precomputed";
import { type Run, Runs } from "./runs";
import { SOLID_EXPERIMENTS } from "./solids/index";
import { linkToSpace } from "./solids/link";
import SolidWorker from "./solids/worker?worker&inline";
import ExperimentWorker from "./worker?worker&inline";
import "../style.css";
import "./page.css";

/** The outcome that is kept with the sources, and its figures, under the titles of the sources. */
const sections = new Map([...readDocument(paper), ...readDocument(surfaces)]);
const STUDIES: readonly Study[] = [...EXPERIMENTS, ...SOLID_EXPERIMENTS];
const BEFOREHAND = new Map(STUDIES.map(({ id, title }) => [id, sections.get(title) ?? []]));
const FIGURES: Record<string, string> = import.meta.glob("../../docs/figures/*.svg", {
  query: "?url",
  import: "default",
  eager: true,
});

type Shown = { readonly study: Study; readonly link: () => string; readonly engine: Engine };
type Part = { readonly name: "curves" | "surfaces"; readonly shown: readonly Shown[] };

const planeEngine = { module: moduleAt(solverUrl), spawn: () => new ExperimentWorker() };
// At once: later nothing needs the network. A failure is said when somebody computes, who then tries again.
planeEngine.module().catch(() => {});
/** Fetched only when it is asked for: it is larger, and few come for it. */
const solidEngine = { module: moduleAt(solidSolverUrl), spawn: () => new SolidWorker() };

const PARTS: readonly Part[] = [
  {
    name: "curves",
    shown: EXPERIMENTS.map((study) => ({ study, link: () => linkTo(study.example()), engine: planeEngine })),
  },
  {
    name: "surfaces",
    shown: SOLID_EXPERIMENTS.map((study) => ({ study, link: () => linkToSpace(study.example), engine: solidEngine })),
  },
];

function App({ runs }: { runs: Runs }) {
  return (
    <>
      {PARTS.map(({ name, shown }) => (
        <nav key={name} aria-label={say.lists[name]}>
          <ul>
            {shown.map(({ study: { id, title } }) => (
              <li key={id}>
                <a href={`#${id}`}>{title}</a>
              </li>
            ))}
          </ul>
        </nav>
      ))}
      {PARTS.flatMap(({ shown }) => shown).map((one) => (
        <Section key={one.study.id} {...one} runs={runs} />
      ))}
    </>
  );
}

function Section({ study, link, engine, runs }: Shown & { runs: Runs }) {
  const { id, title, paper, setup, hasShortForm } = study;
  const run = runs.of(id).value;
  return (
    <section id={id} class="experiment" aria-labelledby={`${id}-title`}>
      <h2 id={`${id}-title`}>{title}</h2>
      <p>
        <strong>{say.paper}</strong> {typeset(paper)}
      </p>
      <p>
        <strong>{say.here}</strong> {typeset(setup)}
      </p>
      <div class="group">
        <a class="as-button" href={`./index.html#${link()}`} aria-label={say.of(say.open, title)}>
          {say.open}
        </a>
        {run.kind === "running" ? (
          <button type="button" onClick={() => runs.cancel()} aria-label={say.of(say.cancel, title)}>
            {say.cancel}
          </button>
        ) : (
          <>
            <button
              type="button"
              class="primary"
              onClick={() => runs.start(id, hasShortForm ? "short" : "full", engine)}
              aria-label={say.of(say.compute, title)}
            >
              {say.compute}
            </button>
            {hasShortForm && (
              <button
                type="button"
                onClick={() => runs.start(id, "full", engine)}
                aria-label={say.of(say.inFull, title)}
              >
                {say.inFull}
              </button>
            )}
          </>
        )}
      </div>
      <State run={run} title={title} />
      <Outcome study={study} run={run} />
    </section>
  );
}

/** What has been computed here, and before that what the documents hold. */
function Outcome({ study: { id, title }, run }: { study: Study; run: Run }) {
  const blocks = run.kind === "done" ? run.blocks : (BEFOREHAND.get(id) ?? []);
  return (
    // What runs write is English in every language.
    <div lang="en" class={run.kind === "running" ? "results waiting" : "results"} aria-busy={run.kind === "running"}>
      {blocks.map((block, i) => (
        <Piece key={`${id}-${i}`} block={block} name={say.part(title, i + 1)} />
      ))}
    </div>
  );
}

function State({ run, title }: { run: Run; title: string }) {
  if (run.kind === "failed")
    return (
      <p class="problem" role="alert">
        {say.failed(run.message)}
      </p>
    );
  const percent = run.kind === "running" ? Math.round(100 * run.done) : 0;
  return (
    <>
      {run.kind === "running" && (
        <div
          class="bar"
          role="progressbar"
          aria-label={title}
          aria-valuemin={0}
          aria-valuemax={100}
          aria-valuenow={percent}
        >
          <div style={{ width: `${percent}%` }} />
        </div>
      )}
      <p class="state" role="status">
        {run.kind === "running" && say.doing(percent, run.doing)}
        {run.kind === "idle" && say.beforehand}
        {run.kind === "done" && say.done(written(seconds(run.millis)), run.size === "short")}
      </p>
    </>
  );
}

/** `name` tells tables apart. */
function Piece({ block, name }: { block: Block; name: string }) {
  if (block.kind === "text") return <p>{typeset(block.text)}</p>;
  if (block.kind === "figure") {
    const drawn = `data:image/svg+xml,${encodeURIComponent(block.svg)}`;
    const address = block.svg ? drawn : FIGURES[`../../docs/figures/${block.name}.svg`];
    return (
      <figure>
        {/* An image, so that the figure's style sheet stays its own. */}
        <img src={address} alt={block.caption} />
        <figcaption>
          {typeset(block.caption)}{" "}
          <a href={address} download={`${block.name}.svg`}>
            {say.saveSvg}
          </a>
        </figcaption>
      </figure>
    );
  }
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls must be reachable with the keyboard
    <section class="wide" tabIndex={0} aria-label={say.table(name)}>
      <table>
        <thead>
          <tr>
            {block.head.map((cell, i) =>
              cell === "" ? (
                <td key={`${i}-`} />
              ) : (
                <th key={`${i}-${cell}`} scope="col">
                  {typeset(cell)}
                </th>
              ),
            )}
          </tr>
        </thead>
        <tbody>
          {block.rows.map((row) => (
            <tr key={row.join("|")}>
              {row.map((cell, i) =>
                i === 0 ? (
                  <th key={block.head[i]} scope="row">
                    {typeset(cell)}
                  </th>
                ) : (
                  <td key={`${i}-${block.head[i]}`}>{typeset(cell)}</td>
                ),
              )}
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}

/** Indices as such: every second part of what is split at them. */
function typeset(words: string) {
  return words.split(INDEX).map((part, i) => (i % 2 === 0 ? part : <sub key={`${i}-${part}`}>{part}</sub>));
}

const root = document.getElementById("experiments");
if (!root) throw new Error("experiments.html has no #experiments");
readFile("experimentsFile", "h1, .promise, footer p");
page("experimentTexts", Object.fromEntries(STUDIES.map((study) => [study.id, study])));
const refuse = sayAbove(root);
listenForLanguage(refuse);
const runs = new Runs();
begin()
  // The page goes on in English.
  .catch(refuse)
  .then(() => {
    root.replaceChildren();
    render(<App runs={runs} />, root);
    // The sections did not exist yet when the browser looked for the one in the address.
    if (location.hash) document.getElementById(location.hash.slice(1))?.scrollIntoView();
  });
