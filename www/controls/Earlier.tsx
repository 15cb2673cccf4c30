import { useComputed } from "@preact/signals";
import { choiceWords, type KeptRun } from "../runs";
import type { Session } from "../session";
import { bandwidth } from "../settings";
import { matchOf } from "../view/result";
import { later } from "../words/later";
import { adopt } from "./adopt";
import style from "./earlier.css?inline";
import { Pair } from "./Pair";
import { Thumbnail } from "./Thumbnail";

adopt(style);

/** The runs so far. Any of them can be shown again, or pinned and compared with what is shown. */
export function Earlier({ session }: { session: Session }) {
  const { runs } = session;
  const outcomes = useComputed(() => [runs.of(runs.pinned.value), session.result.value] as const);
  const list = runs.list.value;
  if (list.length === 0) return <p class="help">{later.runs.none}</p>;
  return (
    <>
      <ul class="earlier" aria-label={later.runs.title}>
        {list.map((run) => (
          <Entry key={run.id} session={session} run={run} />
        ))}
      </ul>
      {outcomes.value[0] && <Pair session={session} outcomes={outcomes} names={[later.runs.pinned, later.runs.now]} />}
    </>
  );
}

function Entry({ session, run }: { session: Session; run: KeptRun }) {
  const scene = { ...run, match: matchOf(run.frame), morph: 1, bandwidth: bandwidth(run.settings) };
  const { runs } = session;
  const title = choiceWords(run.settings, {}).join(", ") || later.runs.defaults;
  return (
    <li>
      <button
        type="button"
        aria-label={later.runs.show(`${later.runs.run(run.id)}, ${title}`)}
        onClick={() => session.showAgain(run)}
      >
        <Thumbnail scene={scene} />
      </button>
      <span class="what">
        {later.runs.run(run.id)}: {title}
      </span>
      <label>
        <input
          type="checkbox"
          checked={runs.pinned.value === run.id}
          aria-label={`${later.runs.pin}: ${later.runs.run(run.id)}`}
          onChange={() => runs.pin(run.id)}
        />
        {later.runs.pin}
      </label>
    </li>
  );
}
