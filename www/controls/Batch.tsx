import { useSignal } from "@preact/signals";
import { useEffect, useMemo } from "preact/hooks";
import { type Dropped, gathered, MOST_FILES, readable } from "../batch/gather";
import { BatchRun } from "../batch/run";
import { type Row, semilandmarksCsv, semilandmarksTps, strainsCsv, tableCsv } from "../batch/tables";
import { download } from "../export/download";
import type { Session } from "../session";
import { batch as say } from "../words/batch";
import { written } from "../words/numbers";
import { adopt } from "./adopt";
import style from "./batch.css?inline";

adopt(style);

const POINTS = 100;
const MOST_POINTS = 2000;

type Props = {
  readonly session: Session;
  readonly dropped: Dropped;
  readonly accepted: string;
  /** A match has been shown on the page. */
  readonly onShown: () => void;
};

/** One reference against many targets: files in, a table and points out. The page stays as it is meanwhile. */
export function Batch({ session, dropped, accepted, onShown }: Props) {
  const run = useMemo(() => new BatchRun(session), [session]);
  const files = useSignal<readonly File[]>([]);
  const first = useSignal(session.shapes.value.reference.length === 0);
  const outline = useSignal(true);
  const points = useSignal(POINTS);
  const take = (given: readonly File[]) => {
    files.value = given.slice(0, MOST_FILES);
    run.problem.value = given.length > MOST_FILES ? say.most(MOST_FILES) : null;
  };
  useEffect(() => () => run.stop(), [run]);
  useEffect(() => {
    if (dropped.length === 0) return;
    gathered(dropped).then(take, (error) => {
      run.problem.value = String(error.message ?? error);
    });
  }, [dropped]);

  const running = run.running.value;
  const show = ({ target, match }: Row) => {
    const plan = run.plan.value;
    if (!plan || !target || !match) return;
    const { status, deformation, curves, pins } = match;
    const shapes = { reference: plan.reference.shape, template: target.shape, pins };
    session.restore({ ...shapes, settings: plan.settings, match: { status, deformation, curves } });
    onShown();
  };
  return (
    <div class="batch">
      <p class="help">{say.help}</p>
      <div class="choose">
        <Chooser name={say.files} accepted={accepted} onFiles={take} disabled={running} />
        <Chooser name={say.folder} folder onFiles={(all) => take(readable(all))} disabled={running} />
        <p class="count">{say.chosen(files.value.length)}</p>
      </div>
      <div class="options">
        <label>
          {say.reference}
          <select
            value={first.value ? "first" : "page"}
            disabled={running}
            onChange={(event) => {
              first.value = event.currentTarget.value === "first";
            }}
          >
            <option value="page">{say.references.page}</option>
            <option value="first">{say.references.first}</option>
          </select>
        </label>
        <label>
          {say.points}
          <input
            type="number"
            min={3}
            max={MOST_POINTS}
            value={points.value}
            disabled={running}
            onChange={(event) => {
              const value = Math.round(Number(event.currentTarget.value));
              points.value = Math.min(MOST_POINTS, Math.max(3, value || POINTS));
              event.currentTarget.value = String(points.value);
            }}
          />
        </label>
        <label class="tick">
          <input
            type="checkbox"
            checked={outline.value}
            disabled={running}
            onChange={(event) => {
              outline.value = event.currentTarget.checked;
            }}
          />
          {say.outline}
        </label>
      </div>
      <div class="go">
        {running ? (
          <button type="button" onClick={() => run.stop()}>
            {say.stop}
          </button>
        ) : (
          <button
            type="button"
            class="primary"
            disabled={files.value.length === 0}
            onClick={() =>
              void run.start({
                files: files.value,
                first: first.value,
                outline: outline.value,
                points: points.value,
              })
            }
          >
            {say.start}
          </button>
        )}
        {running && <progress aria-label={say.progress} value={run.done.value[0]} max={run.done.value[1]} />}
        <p role="status">{run.words.value}</p>
      </div>
      <div role="alert">{run.problem.value && <p class="refusal">{run.problem.value}</p>}</div>
      {run.rows.value.length > 0 && <Rows rows={run.rows.value} onShow={show} />}
      <Saves run={run} />
    </div>
  );
}

type ChooserProps = {
  readonly name: string;
  readonly accepted?: string;
  readonly folder?: boolean;
  readonly disabled: boolean;
  readonly onFiles: (files: readonly File[]) => void;
};

function Chooser({ name, accepted, folder = false, disabled, onFiles }: ChooserProps) {
  return (
    <label class="file">
      <span>{name}</span>
      <input
        type="file"
        multiple
        disabled={disabled}
        accept={accepted}
        ref={(input) => {
          input?.toggleAttribute("webkitdirectory", folder);
        }}
        onChange={(event) => {
          onFiles([...(event.currentTarget.files ?? [])]);
          event.currentTarget.value = "";
        }}
      />
    </label>
  );
}

function Rows({ rows, onShow }: { readonly rows: readonly Row[]; readonly onShow: (row: Row) => void }) {
  const { columns } = say;
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls has to be reached by the keyboard
    <section class="rows" tabIndex={0} aria-label={say.table}>
      <table>
        <thead>
          <tr>
            {Object.values(columns).map((column) => (
              <th key={column} scope="col">
                {column}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {rows.map((row) => (
            <tr key={row.name}>
              <th scope="row">
                {row.match ? (
                  <button type="button" class="quiet" title={say.show(row.name)} onClick={() => onShow(row)}>
                    {row.name}
                  </button>
                ) : (
                  row.name
                )}
              </th>
              <td>{row.match && written(row.match.procrustesDistance.toFixed(4))}</td>
              <td>{row.match && written(String(Number(row.match.centroidSize.toPrecision(4))))}</td>
              <td>{row.match && written(row.match.status.mismatch.max.toFixed(2))}</td>
              <td>{row.outcome}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}

/** What has been matched by now can be saved, also while others are under way. */
function Saves({ run }: { readonly run: BatchRun }) {
  const [plan, rows] = [run.plan.value, run.rows.value];
  const none = !plan || !rows.some(({ match }) => match);
  const saves = [
    [say.saves.table, "table.csv", () => tableCsv(rows)],
    [say.saves.tps, "semilandmarks.tps", () => (plan ? semilandmarksTps(plan, rows) : "")],
    [say.saves.points, "semilandmarks.csv", () => (plan ? semilandmarksCsv(plan, rows) : "")],
    [say.saves.strains, "strains.csv", () => (plan ? strainsCsv(plan, rows) : "")],
  ] as const;
  return (
    <footer>
      {saves.map(([label, name, text]) => (
        <button
          key={name}
          type="button"
          disabled={none}
          onClick={() => download({ blob: new Blob([text()], { type: "text/plain" }), name })}
        >
          {label}
        </button>
      ))}
    </footer>
  );
}
