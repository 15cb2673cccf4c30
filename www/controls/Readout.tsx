import type { ReadonlySignal } from "@preact/signals";
import { localNumbers } from "../view/local";
import type { Match } from "../view/result";
import { later } from "../words/later";
import { decimals } from "../words/numbers";
import { probe } from "./viewing";

export { localNumbers };

/** The numbers at the place that is pointed at, in the half of the picture where it is not. */
export function Readout({ match, name = later.readout.name }: Properties) {
  const numbers = match.value && probe.value && localNumbers(match.value, probe.value);
  const low = numbers && Math.max(numbers.y, numbers.partnerY) > 0.55;
  return (
    <section class={low ? "readout low" : "readout"} aria-live="polite" aria-label={name}>
      {numbers && (
        <dl>
          <Pair label={later.readout.point} names={["point-x", "point-y"]} values={[numbers.x, numbers.y]} />
          <Pair
            label={later.readout.partner}
            names={["partner-x", "partner-y"]}
            values={[numbers.partnerX, numbers.partnerY]}
          />
          <Pair label={later.readout.stretch} names={["stretch"]} values={[numbers.stretch]} unit="×" />
          <Pair label={later.readout.determinant} names={["determinant"]} values={[numbers.determinant]} unit="×" />
          <Pair
            label={later.readout.curvatures}
            names={["curvature", "partner-curvature"]}
            values={[numbers.curvature, numbers.partnerCurvature]}
            unit={later.readout.perSide}
          />
          <Pair
            label={later.readout.distance}
            names={["distance"]}
            values={[numbers.distance]}
            unit={later.readout.cells}
          />
        </dl>
      )}
    </section>
  );
}

type Properties = { readonly match: ReadonlySignal<Match | null>; readonly name?: string };

type PairProperties = {
  readonly label: string;
  readonly names: readonly string[];
  readonly values: readonly number[];
  readonly unit?: string;
};

function Pair({ label, names, values, unit }: PairProperties) {
  return (
    <div>
      <dt>{label}</dt>
      <dd>
        {values.map((value, i) => (
          <span key={names[i]}>
            {i > 0 && ", "}
            <data data-name={names[i]} value={String(value)}>
              {decimals(value)}
            </data>
          </span>
        ))}
        {unit && <span class="unit">{unit}</span>}
      </dd>
    </div>
  );
}
