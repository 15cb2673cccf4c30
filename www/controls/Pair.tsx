import { type ReadonlySignal, useComputed } from "@preact/signals";
import { choiceWords } from "../runs";
import type { Session } from "../session";
import { bandwidth } from "../settings";
import { matchOf, type ResultScene } from "../view/result";
import { missedBy } from "../view/unreached";
import { later } from "../words/later";
import { decimals } from "../words/numbers";
import { adopt } from "./adopt";
import type { Outcome } from "./compared";
import { Legend } from "./Legend";
import { MatchCanvas } from "./MatchCanvas";
import style from "./pair.css?inline";
import { Readout } from "./Readout";
import { lazy, view } from "./viewing";

adopt(style);

type Outcomes = ReadonlySignal<readonly [Outcome | null, Outcome | null]>;
type Names = readonly [string, string];
type PairProperties = { readonly session: Session; readonly outcomes: Outcomes; readonly names: Names };

/** Two matches side by side under one view, one morph and one scale, titled by what differs, with their numbers. */
export function Pair({ session, outcomes, names }: PairProperties) {
  const [a, b] = outcomes.value;
  if (!a && !b) return null;
  return (
    <>
      <div class="pair">
        <Panel session={session} outcomes={outcomes} names={names} index={0} />
        <Panel session={session} outcomes={outcomes} names={names} index={1} />
      </div>
      {a && b && <Differences a={a} b={b} names={names} />}
    </>
  );
}

/** Of the two, what the one has chosen otherwise. */
function titleOf(outcome: Outcome | null, other: Outcome | null): string {
  return outcome && other ? choiceWords(outcome.settings, other.settings).join(", ") : "";
}

function Panel({ session, outcomes, names, index }: PairProperties & { readonly index: 0 | 1 }) {
  const match = useComputed(() => {
    const outcome = outcomes.value[index];
    return outcome && matchOf(outcome.frame);
  });
  const scene = useComputed<ResultScene>(() => {
    const outcome = outcomes.value[index];
    return {
      reference: outcome?.reference ?? [],
      template: outcome?.template ?? [],
      pins: outcome?.pins ?? [],
      match: match.value,
      morph: session.morph.value,
      bandwidth: bandwidth(outcome?.settings ?? {}),
      missed: missedBy(outcome?.frame ?? null),
    };
  });
  // One scale for both, or their colours could not be compared.
  const limit = useComputed(() =>
    Math.max(
      ...outcomes.value.map(
        (outcome) =>
          (outcome && lazy.value?.views.limitOf(view.value, matchOf(outcome.frame), bandwidth(outcome.settings))) || 0,
      ),
      Number.MIN_VALUE,
    ),
  );
  const title = titleOf(outcomes.value[index], outcomes.value[1 - index]);
  const label = later.compare.result(names[index]);
  return (
    <figure class="side">
      <figcaption>
        {names[index]}
        {title && `: ${title}`}
      </figcaption>
      <div class="surface">
        <MatchCanvas label={label} scene={scene} limit={limit} />
        <Legend session={session} match={match} limit={limit} bandwidth={scene.value.bandwidth} />
        <Readout match={match} name={later.compare.numbers(names[index])} />
      </div>
    </figure>
  );
}

function Differences({ a, b, names }: { a: Outcome; b: Outcome; names: Names }) {
  return (
    <table class="differences">
      <caption class="unseen">{later.compare.differences(...names)}</caption>
      <thead>
        <tr>
          <td />
          <th scope="col">{names[0]}</th>
          <th scope="col">{names[1]}</th>
          <th scope="col">
            {names[1]} − {names[0]}
          </th>
        </tr>
      </thead>
      <tbody>
        {rowsOf(a).map(([name, first], i) => {
          const second = rowsOf(b)[i][1];
          return (
            <tr key={name}>
              <th scope="row">{name}</th>
              <td>{decimals(first)}</td>
              <td>{decimals(second)}</td>
              <td>{decimals(second - first)}</td>
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}

function rowsOf({ frame: { status }, millis }: Outcome): readonly (readonly [string, number])[] {
  const { energies, mismatch, cover, stretch } = status;
  const { rows } = later.compare;
  return [
    [rows.total, energies.total],
    [rows.membrane, energies.membrane],
    [rows.bending, energies.bending],
    [rows.mismatch, energies.mismatch],
    [rows.volume, energies.volume],
    [rows.pins, energies.pins],
    [rows.largest, mismatch.max],
    [rows.mean, mismatch.mean],
    [rows.missed, cover.max],
    [rows.measure, status.measure],
    [rows.stretch, stretch.mean],
    [rows.deviation, stretch.deviation],
    [rows.area, status.leastDeterminant],
    [rows.evaluations, status.evaluations],
    ...(millis === undefined ? [] : [[rows.millis, millis] as const]),
  ];
}
