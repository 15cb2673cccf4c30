/** Numbers and progress as every status of the page shows them. */

import type { ComponentChildren } from "preact";
import type { Status } from "../protocol";
import { decimals } from "../words/numbers";

type ValueProperties = {
  /** For machines. */
  readonly name: string;
  readonly label: string;
  readonly value: number;
  readonly text: string;
  readonly unit?: string;
};

/** For machines only what is a number; for people always words. */
export function Value({ name, label, value, text, unit = "" }: ValueProperties) {
  return (
    <div>
      <dt>{label}</dt>
      <dd>
        {Number.isFinite(value) ? (
          <data data-name={name} value={String(value)}>
            {text}
          </data>
        ) : (
          text
        )}
        {unit && <span class="unit">{unit}</span>}
      </dd>
    </div>
  );
}

type Name =
  | "level"
  | "iteration"
  | "total"
  | "mismatch-max"
  | "mismatch-mean"
  | "cover-max"
  | "measure"
  | "least-determinant";

type NumbersProperties = {
  readonly status: Status;
  readonly stale: boolean;
  readonly working: boolean;
  /** What each number is called, by its name for machines. */
  readonly labels: Readonly<Record<Name, string>>;
  readonly grid: string;
  readonly cells: (distance: number) => Pick<ValueProperties, "text" | "unit">;
  /** What stands before the last of them. */
  readonly among?: ComponentChildren;
  readonly children?: ComponentChildren;
};

/** How far a match is, and once it is there how good. */
export function Numbers({ status, stale, working, labels, grid, cells, among, children }: NumbersProperties) {
  const one = (name: Name, value: number, said: Pick<ValueProperties, "text" | "unit">) => (
    <Value name={name} label={labels[name]} value={value} {...said} />
  );
  const plain = (name: Name, value: number) => one(name, value, { text: decimals(value) });
  const { level, iteration, energies, mismatch, cover, measure, leastDeterminant } = status;
  return (
    <dl class={stale ? "stale" : undefined}>
      {one("level", level, { text: grid })}
      {/* What came out best is taken up as it was, without one more. */}
      {(working || iteration > 0) && one("iteration", iteration, { text: String(iteration) })}
      {plain("total", energies.total)}
      {!working && (
        <>
          {one("mismatch-max", mismatch.max, cells(mismatch.max))}
          {one("mismatch-mean", mismatch.mean, cells(mismatch.mean))}
          {one("cover-max", cover.max, cells(cover.max))}
          {plain("measure", measure)}
          {among}
          {plain("least-determinant", leastDeterminant)}
          {children}
        </>
      )}
    </dl>
  );
}

/** A bar that knows how far it is, or that it does not. */
export function Bar({ label, percent }: { readonly label: string; readonly percent: number | null }) {
  const known = percent === null ? {} : { "aria-valuemin": 0, "aria-valuemax": 100, "aria-valuenow": percent };
  return (
    <div class={percent === null ? "progress unknown" : "progress"} role="progressbar" aria-label={label} {...known}>
      <div style={percent === null ? undefined : { inlineSize: `${percent}%` }} />
    </div>
  );
}
