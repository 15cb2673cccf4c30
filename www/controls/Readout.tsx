import type { ReadonlySignal } from "@preact/signals";
import type { Match } from "../view/result";
import { en } from "../words/en";
import { decimals } from "../words/numbers";
import { local, probe } from "./viewing";

/** The numbers at the place that is pointed at, in the half of the picture where it is not. */
export function Readout({ match, name = en.readout.name }: Properties) {
  const numbers = match.value && probe.value && local.value?.localNumbers(match.value, probe.value);
  const low = numbers && Math.max(numbers.y, numbers.partnerY) > 0.55;
  return (
    <section class={low ? "readout low" : "readout"} aria-live="polite" aria-label={name}>
      {numbers && (
        <dl>
          <Pair label={en.readout.point} names={["point-x", "point-y"]} values={[numbers.x, numbers.y]} />
          <Pair
            label={en.readout.partner}
            names={["partner-x", "partner-y"]}
            values={[numbers.partnerX, numbers.partnerY]}
          />
          <Pair label={en.readout.stretch} names={["stretch"]} values={[numbers.stretch]} unit="×" />
          <Pair label={en.readout.determinant} names={["determinant"]} values={[numbers.determinant]} unit="×" />
          <Pair
            label={en.readout.curvatures}
            names={["curvature", "partner-curvature"]}
            values={[numbers.curvature, numbers.partnerCurvature]}
            unit={en.readout.perSide}
          />
          <Pair label={en.readout.distance} names={["distance"]} values={[numbers.distance]} unit={en.readout.cells} />
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
