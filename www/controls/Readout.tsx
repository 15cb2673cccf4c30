import type { ReadonlySignal } from "@preact/signals";
import type { Match } from "../view/result";
import { decimals } from "../words/numbers";
import { local, probe } from "./viewing";

/** The numbers at the place that is pointed at, in the half of the picture where it is not. */
export function Readout({ match, name = "Numbers at the point" }: Properties) {
  const numbers = match.value && probe.value && local.value?.localNumbers(match.value, probe.value);
  const low = numbers && Math.max(numbers.y, numbers.partnerY) > 0.55;
  return (
    <section class={low ? "readout low" : "readout"} aria-live="polite" aria-label={name}>
      {numbers && (
        <dl>
          <Pair label="Point" names={["point-x", "point-y"]} values={[numbers.x, numbers.y]} />
          <Pair label="Partner" names={["partner-x", "partner-y"]} values={[numbers.partnerX, numbers.partnerY]} />
          <Pair label="Stretch" names={["stretch"]} values={[numbers.stretch]} unit="×" />
          <Pair label="Area ratio" names={["determinant"]} values={[numbers.determinant]} unit="×" />
          <Pair
            label="Curvatures"
            names={["curvature", "partner-curvature"]}
            values={[numbers.curvature, numbers.partnerCurvature]}
            unit="per side"
          />
          <Pair label="Distance" names={["distance"]} values={[numbers.distance]} unit="cells" />
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
